#include "dictionary/SpaceTimeFunction.hpp"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

using Point = std::array<double, 4>; // x y z t

/// The flow of a dictionary in etc/solutions, behind which parameters may follow.
class Flow
{
public:
    Flow(const std::string& name, const std::string& block, double viscosity, const std::string& parameters)
        : dictionary_(Dictionary::parse("#includeEtc \"solutions/" + name + "\"\n" + parameters, name, ".")),
          U_(readFunction(dictionary_.dictionary(block), "U", 3, {{"nu", viscosity}}, "")),
          p_(readFunction(dictionary_.dictionary(block), "p", 1, {{"nu", viscosity}}, "")),
          nu_(viscosity)
    {
    }

    double U(int i, const Point& at) const { return U_(i, at[0], at[1], at[2], at[3]); }
    double p(const Point& at) const { return p_(0, at[0], at[1], at[2], at[3]); }

    /// Largest term-by-term residual of the Navier-Stokes equations at a point, by central differences of order 4.
    double residual(const Point& at) const
    {
        double largest = std::abs(divergence(at));
        for (int i = 0; i < 3; ++i)
        {
            const auto Ui = [this, i](const Point& point) { return U(i, point); };
            const auto pressure = [this](const Point& point) { return p(point); };
            double sum = first(Ui, at, 3) + first(pressure, at, i);
            for (int j = 0; j < 3; ++j) { sum += U(j, at) * first(Ui, at, j) - nu_ * second(Ui, at, j); }
            largest = std::max(largest, std::abs(sum));
        }
        return largest;
    }

    double divergence(const Point& at) const
    {
        double sum = 0;
        for (int i = 0; i < 3; ++i)
        {
            sum += first([this, i](const Point& point) { return U(i, point); }, at, i);
        }
        return sum;
    }

private:
    static constexpr double step = 1e-3;

    static Point moved(Point at, int axis, double by)
    {
        at[static_cast<std::size_t>(axis)] += by;
        return at;
    }
    template<class F>
    static double first(const F& f, const Point& at, int axis)
    {
        const auto d = [&](double s) { return f(moved(at, axis, s)) - f(moved(at, axis, -s)); };
        return (8 * d(step) - d(2 * step)) / (12 * step);
    }
    template<class F>
    static double second(const F& f, const Point& at, int axis)
    {
        const auto d = [&](double s) { return f(moved(at, axis, s)) - 2 * f(at) + f(moved(at, axis, -s)); };
        return (16 * d(step) - d(2 * step)) / (12 * step * step);
    }

    Dictionary dictionary_;
    SpaceTimeFunction U_;
    SpaceTimeFunction p_;
    double nu_;
};

constexpr std::array<Point, 4> places{
    {{0.1, 0.13, 0.2, 0}, {-0.17, 0.05, 0.7, 0.3}, {0.3, -0.12, -0.4, 0.1}, {0.04, 0.29, 0.33, 0.7}}};

// Differences of order 4 over 1e-3 of functions with wavenumbers up to 4 pi: errors of 1e-12 k^5 < 1e-6, times speeds.
constexpr double tolerance = 1e-6;

TEST(Solutions, TaylorGreen2DSolvesNavierStokes)
{
    const Flow still("taylorGreen2D", "exact", 0.01, "");
    const Flow moving("taylorGreen2D", "exact", 0.02, "U0 1; V0 -0.5; speed 2; L 1.5;");
    for (const Point& place : places)
    {
        EXPECT_LT(still.residual(place), tolerance);
        EXPECT_LT(moving.residual(place), tolerance);
    }
    EXPECT_NEAR(still.U(0, {0, 0.25, 0, 0}), -1, 1e-15);
    EXPECT_NEAR(moving.U(0, {0, 0.375, 0, 0}), -1, 1e-15);
}

TEST(Solutions, GreshoSolvesEuler)
{
    const Flow flow("gresho", "exact", 0, "");
    const Flow larger("gresho", "exact", 0, "R 0.3; speed 2; x0 0.1; y0 -0.1;");
    for (const Point& place : places)
    {
        EXPECT_LT(flow.residual(place), tolerance);
        EXPECT_LT(larger.residual(place), 2e-6);
    }
    EXPECT_EQ(flow.U(1, {0.2, 0, 0, 0}), 1);
    EXPECT_EQ(flow.U(1, {0, 0, 0, 0}), 0);
    EXPECT_EQ(flow.U(1, {0.45, 0, 0, 0}), 0);
    // The pressure has no jumps at R and 2R.
    for (const double r : {0.2, 0.4}) { EXPECT_NEAR(flow.p({r - 1e-9, 0, 0, 0}), flow.p({r + 1e-9, 0, 0, 0}), 1e-7); }
}

TEST(Solutions, Beltrami3DSolvesNavierStokes)
{
    const Flow flow("beltrami3D", "exact", 0.1, "");
    const Flow other("beltrami3D", "exact", 0.05, "A 0.5; B 2; C -1; L 3;");
    for (const Point& place : places)
    {
        EXPECT_LT(flow.residual(place), tolerance);
        EXPECT_LT(other.residual(place), tolerance);
    }
}

TEST(Solutions, InitialFieldsAreFreeOfDivergence)
{
    const Flow shear("doubleShearLayer", "initial", 0, "steepness 30;");
    const Flow vortex("taylorGreen3D", "initial", 0, "speed 2; L 1;");
    for (const Point& place : places)
    {
        EXPECT_LT(std::abs(shear.divergence(place)), tolerance);
        EXPECT_LT(std::abs(vortex.divergence(place)), tolerance);
    }
    EXPECT_EQ(shear.U(0, {0, 0.25, 0, 0}), 0);
    EXPECT_NEAR(shear.U(0, {0, 0.5, 0, 0}), 1, 1e-6);
}

TEST(Solutions, TaylorGreen3DPressureMeetsItsPoissonEquation)
{
    // laplacian p = -dUi/dxj dUj/dxi, at a place where all terms differ, by differences of order 2.
    const Flow flow("taylorGreen3D", "initial", 0, "");
    constexpr double h = 1e-3;
    const Point place{0.3, 0.7, 0.2, 0};
    const auto moved = [&place](int axis, double by)
    {
        Point point = place;
        point[static_cast<std::size_t>(axis)] += by;
        return point;
    };
    const auto gradient = [&](int i, int j) { return (flow.U(i, moved(j, h)) - flow.U(i, moved(j, -h))) / (2 * h); };
    double sum = 0;
    for (int i = 0; i < 3; ++i)
    {
        sum += (flow.p(moved(i, h)) - 2 * flow.p(place) + flow.p(moved(i, -h))) / (h * h);
        for (int j = 0; j < 3; ++j) { sum += gradient(i, j) * gradient(j, i); }
    }
    EXPECT_NEAR(sum, 0, 1e-5);
}

} // namespace
} // namespace isph
