#include "caseFields/VelocityDerivatives.hpp"
#include "caseFields/StreamFunction.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace isph
{
namespace
{

constexpr double pi = std::numbers::pi;

/// Calls visit(n, x, y, z) for every point.
template<class Visit>
void forEachPoint(const Lattice& lattice, Visit visit)
{
    const auto [x, y, z] = lattice.coordinates();
    for (std::size_t n = 0; n < lattice.points(); ++n) { visit(n, x[n], y[n], z[n]); }
}

/// Round-off of sums of a few derivatives of fields of size 1 with wavenumbers up to 6 pi.
constexpr double roundOff = 1e-12;

// psi = sin(2 pi x) cos(6 pi y)/(2 pi) on a box of another shape than its period, with a mean flow (0.5, -0.25).
TEST(VelocityDerivatives, AreExactInAPlane)
{
    const Lattice lattice({Axis{'x', -0.5, 1, 12}, Axis{'y', 0.25, 2, 45}, Axis{'z'}}, {});
    RealField U(2, lattice.points());
    forEachPoint(lattice,
                 [&](std::size_t n, double x, double y, double)
                 {
                     U[0][n] = 0.5 - 3 * std::sin(2 * pi * x) * std::sin(6 * pi * y);
                     U[1][n] = -0.25 - std::cos(2 * pi * x) * std::cos(6 * pi * y);
                 });
    VelocityDerivatives derivatives(lattice);
    const RealField vorticity = derivatives.vorticity(U);
    const RealField divergence = derivatives.divergence(U);
    const RealField Q = derivatives.Q(U);
    const StreamFunction psi = streamFunction(U, lattice);
    ASSERT_EQ(vorticity.components(), 1);
    forEachPoint(lattice,
                 [&](std::size_t n, double x, double y, double)
                 {
                     const double s = std::sin(2 * pi * x);
                     const double c = std::cos(2 * pi * x);
                     const double S = std::sin(6 * pi * y);
                     const double C = std::cos(6 * pi * y);
                     EXPECT_NEAR(vorticity[0][n], (2 + 18) * pi * s * C, 100 * roundOff);
                     EXPECT_NEAR(divergence[0][n], 0, 100 * roundOff);
                     EXPECT_NEAR(Q[0][n], -36 * pi * pi * (c * c * S * S - s * s * C * C), 1e4 * roundOff);
                     const double mean = 0.5 * (y - 0.25) + 0.25 * (x + 0.5);
                     EXPECT_NEAR(psi.values[0][n], s * C / (2 * pi) + mean, roundOff);
                 });
    EXPECT_NEAR(psi.periodGain[0], 0.25, roundOff);
    EXPECT_NEAR(psi.periodGain[1], 1, roundOff);
}

TEST(VelocityDerivatives, TurnAboutTheNormalOfTheirPlane)
{
    // u_z = sin(2 pi x): the y component of the curl is -d(u_z)/dx.
    const Lattice lattice({Axis{'x', 0, 1, 8}, Axis{'y'}, Axis{'z', 0, 1, 8}}, {});
    RealField U(2, lattice.points());
    forEachPoint(lattice, [&](std::size_t n, double x, double, double) { U[1][n] = std::sin(2 * pi * x); });
    const RealField vorticity = VelocityDerivatives(lattice).vorticity(U);
    forEachPoint(lattice, [&](std::size_t n, double x, double, double)
                 { EXPECT_NEAR(vorticity[0][n], -2 * pi * std::cos(2 * pi * x), roundOff); });
}

// The Arnold-Beltrami-Childress flow is its own curl.
TEST(VelocityDerivatives, AreExactInABox)
{
    const Lattice lattice({Axis{'x', 0, 1, 6}, Axis{'y', 0, 1, 10}, Axis{'z', 0, 1, 7}}, {});
    RealField U(3, lattice.points());
    constexpr double k = 2 * pi;
    forEachPoint(lattice,
                 [&](std::size_t n, double x, double y, double z)
                 {
                     U[0][n] = std::sin(k * z) + 0.5 * std::cos(k * y);
                     U[1][n] = 2 * std::sin(k * x) + std::cos(k * z);
                     U[2][n] = 0.5 * std::sin(k * y) + 2 * std::cos(k * x);
                 });
    VelocityDerivatives derivatives(lattice);
    const RealField vorticity = derivatives.vorticity(U);
    const RealField divergence = derivatives.divergence(U);
    const RealField Q = derivatives.Q(U);
    forEachPoint(lattice,
                 [&](std::size_t n, double x, double y, double z)
                 {
                     for (int d = 0; d < 3; ++d) { EXPECT_NEAR(vorticity[d][n], k * U[d][n], 10 * roundOff); }
                     EXPECT_NEAR(divergence[0][n], 0, 10 * roundOff);
                     // Q = -tr(A A)/2 with the three products of opposite off-diagonal entries.
                     const double xy = -0.5 * std::sin(k * y) * 2 * std::cos(k * x);
                     const double xz = std::cos(k * z) * -2 * std::sin(k * x);
                     const double yz = -std::sin(k * z) * 0.5 * std::cos(k * y);
                     EXPECT_NEAR(Q[0][n], -k * k * (xy + xz + yz), 1e3 * roundOff);
                 });
}

Axis walls(char name, double from, double to, int count, bool staggered = false)
{
    return {name, from, to - from, count, Axis::Ends::bounded, staggered};
}

template<class Function>
void fill(RealField& field, int component, const Lattice& lattice, Function f)
{
    forEachPoint(lattice, [&](std::size_t n, double x, double y, double z) { field[component][n] = f(x, y, z); });
}

/// The largest error over the points.
template<class Function>
double error(const RealField& field, int component, const Lattice& lattice, Function exact)
{
    double largest = 0;
    forEachPoint(lattice, [&](std::size_t n, double x, double y, double z)
                 { largest = std::max(largest, std::abs(field[component][n] - exact(x, y, z))); });
    return largest;
}

/// At walls the continuation of degree 4 leaves an error of order 4.
void expectOrder(double coarse, double fine, double order) { EXPECT_GT(std::log2(coarse / fine), order); }

// psi = exp(x) sin(3 y) in a box, U = 3 exp(x) cos(3 y), V = -exp(x) sin(3 y).
TEST(VelocityDerivatives, AreOfFourthOrderBetweenWalls)
{
    std::array<double, 3> coarse{};
    for (const int n : {40, 80})
    {
        const Lattice lattice({walls('x', 0, 1, n + 1), walls('y', -1, 1, 2 * n + 1), Axis{'z'}}, {});
        RealField U(2, lattice.points());
        fill(U, 0, lattice, [](double x, double y, double) { return 3 * std::exp(x) * std::cos(3 * y); });
        fill(U, 1, lattice, [](double x, double y, double) { return -std::exp(x) * std::sin(3 * y); });
        VelocityDerivatives derivatives(lattice);
        const std::array<double, 3> errors{
            error(derivatives.vorticity(U), 0, lattice,
                  [](double x, double y, double) { return 8 * std::exp(x) * std::sin(3 * y); }),
            error(derivatives.divergence(U), 0, lattice, [](double, double, double) { return 0; }),
            error(derivatives.Q(U), 0, lattice,
                  [](double x, double y, double)
                  {
                      const double c = std::cos(3 * y);
                      const double s = std::sin(3 * y);
                      return std::exp(2 * x) * (-9 * c * c - 9 * s * s);
                  })};
        for (std::size_t i = 0; n == 80 && i < 3; ++i) { expectOrder(coarse[i], errors[i], 3.8); }
        coarse = errors;
    }
    EXPECT_LT(coarse[0], 2e-4);
}

// A channel between walls in z, periodic in x and y: U = (sin(2 pi y) exp(z), z^3, cos(2 pi x) sin(z)).
TEST(VelocityDerivatives, MixPeriodicAndBoundedAxes)
{
    const Lattice lattice({Axis{'x', 0, 1, 8}, Axis{'y', 0, 1, 8}, walls('z', 0, 1, 81)}, {});
    RealField U(3, lattice.points());
    fill(U, 0, lattice, [](double, double y, double z) { return std::sin(2 * pi * y) * std::exp(z); });
    fill(U, 1, lattice, [](double, double, double z) { return z * z * z; });
    fill(U, 2, lattice, [](double x, double, double z) { return std::cos(2 * pi * x) * std::sin(z); });
    const RealField omega = VelocityDerivatives(lattice).vorticity(U);
    EXPECT_LT(error(omega, 0, lattice, [](double, double, double z) { return -3 * z * z; }), 1e-7);
    EXPECT_LT(error(omega, 1, lattice,
                    [](double x, double y, double z)
                    { return std::sin(2 * pi * y) * std::exp(z) + 2 * pi * std::sin(2 * pi * x) * std::sin(z); }),
              1e-6);
    EXPECT_LT(error(omega, 2, lattice,
                    [](double, double y, double z) { return -2 * pi * std::cos(2 * pi * y) * std::exp(z); }),
              1e-10);
}

// The corners of a moving lid are points of the walls beside it, too, but these know nothing of its speed.
TEST(VelocityDerivatives, DoNotRingAlongWallsBesideALid)
{
    const Lattice lattice({walls('x', 0, 1, 17), walls('y', 0, 1, 17), Axis{'z'}}, {});
    RealField U(2, lattice.points());
    fill(U, 0, lattice, [](double, double y, double) { return y == 1 ? 1 : 0; });
    VelocityDerivatives derivatives(lattice);
    const RealField omega = derivatives.vorticity(U);
    const RealField Q = derivatives.Q(U);
    forEachPoint(lattice,
                 [&](std::size_t n, double x, double y, double)
                 {
                     if ((x == 0 || x == 1) && y > 0 && y < 1)
                     {
                         EXPECT_EQ(omega[0][n], 0);
                         EXPECT_EQ(Q[0][n], 0);
                     }
                 });
}

TEST(VelocityDerivatives, AreThereForAFewPoints)
{
    const Lattice lattice({walls('x', 0, 1, 2), walls('y', 0, 1, 3), Axis{'z'}}, {});
    RealField U(2, lattice.points());
    fill(U, 0, lattice, [](double, double y, double) { return y * y; });
    fill(U, 1, lattice, [](double x, double, double) { return x; });
    const RealField omega = VelocityDerivatives(lattice).vorticity(U);
    EXPECT_LT(error(omega, 0, lattice, [](double, double y, double) { return 1 - 2 * y; }), 1e-3);
}

} // namespace
} // namespace isph
