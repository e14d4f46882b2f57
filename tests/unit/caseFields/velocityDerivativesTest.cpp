#include "caseFields/VelocityDerivatives.hpp"
#include "core/Error.hpp"

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
    VelocityDerivatives derivatives(U, lattice);
    const RealField vorticity = derivatives.vorticity();
    const RealField divergence = derivatives.divergence();
    const RealField Q = derivatives.Q();
    const RealField psi = derivatives.streamFunction();
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
                     EXPECT_NEAR(psi[0][n], s * C / (2 * pi) + mean, roundOff);
                 });
    EXPECT_NEAR(derivatives.streamFunctionGain()[0], 0.25, roundOff);
    EXPECT_NEAR(derivatives.streamFunctionGain()[1], 1, roundOff);
}

TEST(VelocityDerivatives, TurnAboutTheNormalOfTheirPlane)
{
    // u_z = sin(2 pi x): the y component of the curl is -d(u_z)/dx.
    const Lattice lattice({Axis{'x', 0, 1, 8}, Axis{'y'}, Axis{'z', 0, 1, 8}}, {});
    RealField U(2, lattice.points());
    forEachPoint(lattice, [&](std::size_t n, double x, double, double) { U[1][n] = std::sin(2 * pi * x); });
    const RealField vorticity = VelocityDerivatives(U, lattice).vorticity();
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
    VelocityDerivatives derivatives(U, lattice);
    const RealField vorticity = derivatives.vorticity();
    const RealField divergence = derivatives.divergence();
    const RealField Q = derivatives.Q();
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

TEST(VelocityDerivatives, NeedPeriodicAxes)
{
    const Lattice lattice({Axis{'x', 0, 1, 8}, Axis{'y', 0, 1, 8, Axis::Ends::bounded}, Axis{'z'}}, {});
    try
    {
        VelocityDerivatives(RealField(2, lattice.points()), lattice);
        FAIL() << "accepted";
    }
    catch (const Error& error)
    {
        EXPECT_STREQ(error.what(),
                     "constant/lattice: derivatives need a lattice that is periodic along every axis, but "
                     "y is bounded\n    leave out the derived fields");
    }
}

} // namespace
} // namespace isph
