#include "lattice/Quadrature.hpp"
#include "lattice/LatticeFace.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

namespace isph
{
namespace
{

constexpr double pi = std::numbers::pi;

Axis between(double from, double to, int count, bool staggered = false)
{
    return {'y', from, to - from, count, Axis::Ends::bounded, staggered};
}

template<class Function>
double integral(const Axis& axis, Function f)
{
    const std::vector<double> weights = quadratureWeights(axis);
    double total = 0;
    for (int i = 0; i < axis.count; ++i) { total += weights[static_cast<std::size_t>(i)] * f(axis.coordinate(i)); }
    return total;
}

TEST(Quadrature, IsExactForPolynomialsThatItsPointsDetermine)
{
    for (const int n : {2, 3, 4, 5, 6, 7, 8, 9, 13, 40})
    {
        const Axis axis = between(-0.5, 1.5, n);
        for (int degree = 0; degree <= std::min(n - 1, 6); ++degree)
        {
            const double exact = (std::pow(1.5, degree + 1) - std::pow(-0.5, degree + 1)) / (degree + 1);
            EXPECT_NEAR(integral(axis, [degree](double y) { return std::pow(y, degree); }), exact, 1e-13)
                << n << " points, degree " << degree;
        }
    }
}

TEST(Quadrature, HasPositiveWeightsThatAddUpToTheExtent)
{
    for (int n = 2; n < 40; ++n)
    {
        const std::vector<double> weights = quadratureWeights(between(0, 3, n));
        EXPECT_GT(*std::ranges::min_element(weights), 0) << n;
        EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 3, 1e-14) << n;
    }
}

TEST(Quadrature, IsOfEighthOrderAtWalls)
{
    const auto error = [](int intervals)
    {
        const double exact = std::exp(1) * (std::sin(5) - 5 * std::cos(5)) / 26 + 5.0 / 26;
        return std::abs(integral(between(0, 1, intervals + 1), [](double y) { return std::exp(y) * std::sin(5 * y); }) -
                        exact);
    };
    EXPECT_LT(error(20), 2e-7);
    EXPECT_GT(std::log2(error(20) / error(40)), 7.5);
    EXPECT_GT(std::log2(error(40) / error(80)), 7.5);
}

// The vorticity of a boundary layer: a spike of thickness d at each wall. A trapezoidal rule is off by 2 % at d = 2 dx.
TEST(Quadrature, LosesLittleOfASpikeAtAWall)
{
    const auto error = [](double thickness)
    {
        const double d = thickness / 64;
        const auto spike = [d](double y) { return std::exp(-y / d) + std::exp((y - 1) / d); };
        return std::abs(integral(between(0, 1, 65), spike) / (2 * d * (1 - std::exp(-1 / d))) - 1);
    };
    EXPECT_LT(error(1), 1e-3);
    EXPECT_LT(error(2), 1.1e-5);
    EXPECT_LT(error(4), 1e-7);
}

TEST(Quadrature, TakesTheProductOfItsAxes)
{
    const Lattice lattice({Axis{'x', 0, 2, 12}, between(0, 1, 21), Axis{'z', -1, 2, 17, Axis::Ends::bounded}}, {});
    const auto [x, y, z] = lattice.coordinates();
    std::vector<double> f;
    std::vector<double> g;
    for (std::size_t n = 0; n < lattice.points(); ++n)
    {
        f.push_back(1 + std::cos(pi * x[n]));
        g.push_back(std::exp(y[n]) * (1 + z[n] * z[n]));
    }
    const Quadrature quadrature(lattice);
    EXPECT_NEAR(quadrature.ofProducts(f, g), 2 * (std::exp(1) - 1) * 8.0 / 3, 1e-11);
    EXPECT_NEAR(quadrature.ofSquares(f), 2 * 1.5 * 1 * 2, 1e-13);
    EXPECT_NEAR(quadrature.of(f), 2 * 2, 1e-13);
}

TEST(Quadrature, IsThePlainSumInPeriodicAndStaggeredBoxes)
{
    const Lattice lattice({Axis{'x', 0, 2, 12}, between(0, 1, 8, true), Axis{'z'}}, {});
    std::vector<double> f(lattice.points());
    std::iota(f.begin(), f.end(), 1.0);
    EXPECT_DOUBLE_EQ(Quadrature(lattice).of(f), lattice.pointVolume() * 96 * 97 / 2);
}

TEST(RunningIntegral, IsOfSixthOrderToPointsAndEnds)
{
    for (const bool staggered : {false, true})
    {
        const auto error = [staggered](int count)
        {
            const Axis axis = between(0.25, 1.5, count, staggered);
            std::vector<double> values;
            for (int i = 0; i < count; ++i) { values.push_back(4 * std::cos(4 * axis.coordinate(i))); }
            const std::vector<double> found = runningIntegral(axis, values);
            double largest = std::abs(found.back() - std::sin(6) + std::sin(1));
            for (int i = 0; i < count; ++i)
            {
                const double exact = std::sin(4 * axis.coordinate(i)) - std::sin(1);
                largest = std::max(largest, std::abs(found[static_cast<std::size_t>(i)] - exact));
            }
            return largest;
        };
        EXPECT_LT(error(41), 1e-7) << staggered;
        EXPECT_GT(std::log2(error(20) / error(40)), 5.4) << staggered;
    }
}

TEST(RunningIntegral, GoesOnceAroundAPeriod)
{
    const Axis axis{'x', 0, 1, 64};
    std::vector<double> values;
    for (int i = 0; i < axis.count; ++i) { values.push_back(2 * pi * std::cos(2 * pi * axis.coordinate(i)) + 3); }
    const std::vector<double> found = runningIntegral(axis, values);
    ASSERT_EQ(found.size(), 65u);
    for (int i = 0; i <= 64; ++i)
    {
        EXPECT_NEAR(found[static_cast<std::size_t>(i)], std::sin(2 * pi * i / 64) + 3 * i / 64.0, 1e-8);
    }
}

TEST(LatticeFace, HoldsTheValuesAndWeightsOfItsPoints)
{
    const Lattice lattice({Axis{'x', 0, 2, 5}, between(0, 1, 7), Axis{'z', 0, 3, 4}}, {});
    const auto [x, y, z] = lattice.coordinates();
    std::vector<double> f;
    for (std::size_t n = 0; n < lattice.points(); ++n) { f.push_back(x[n] + 10 * y[n] + 100 * z[n]); }
    const LatticeFace face(lattice, 1, true);
    ASSERT_EQ(face.points(), 20u);
    EXPECT_EQ(face.outward(), 1);
    std::vector<double> values(face.points());
    face.values(f, values);
    for (std::size_t n = 0; n < face.points(); ++n)
    {
        const auto& at = face.coordinates();
        EXPECT_DOUBLE_EQ(values[n], at[0][n] + 10 + 100 * at[2][n]);
        EXPECT_EQ(at[1][n], 1);
        EXPECT_DOUBLE_EQ(face.weights()[n], 0.4 * 0.75);
    }
}

TEST(LatticeFace, ExtrapolatesToStaggeredWalls)
{
    const Lattice lattice({between(0, 1, 6, true), between(-1, 1, 9, true), Axis{'z'}}, {});
    const auto [x, y, z] = lattice.coordinates();
    std::vector<double> f;
    for (std::size_t n = 0; n < lattice.points(); ++n) { f.push_back(x[n] * std::pow(y[n], 3)); }
    for (const LatticeFace& face : boundedFaces(lattice))
    {
        std::vector<double> values(face.points());
        face.values(f, values);
        for (std::size_t n = 0; n < face.points(); ++n)
        {
            EXPECT_NEAR(values[n], face.coordinates()[0][n] * std::pow(face.coordinates()[1][n], 3), 1e-14);
        }
    }
}

TEST(LatticeFace, AreThoseOfAPatch)
{
    const Patch sides{"sides", Patch::Type::wall, {"xMin", "xMax"}};
    const Patch lid{"lid", Patch::Type::wall, {"yMax"}};
    const Patch floor{"floor", Patch::Type::wall, {"yMin"}};
    const Lattice lattice({between(0, 1, 6), between(0, 1, 6), Axis{'z'}}, {sides, lid, floor});
    ASSERT_EQ(facesOf(sides, lattice).size(), 2u);
    EXPECT_EQ(facesOf(sides, lattice)[0].outward(), -1);
    ASSERT_EQ(facesOf(lid, lattice).size(), 1u);
    EXPECT_EQ(facesOf(lid, lattice)[0].direction(), 1);
    EXPECT_EQ(boundedFaces(lattice).size(), 4u);
}

} // namespace
} // namespace isph
