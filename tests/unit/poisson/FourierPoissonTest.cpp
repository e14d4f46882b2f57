#include "poisson/FourierPoisson.hpp"

#include "support/fields.hpp"
#include "support/kernels.hpp"
#include "support/periodicBox.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace isph
{
namespace
{

using std::numbers::pi;
using test::fieldOf;
using test::periodicBox;
using test::relativeL2;

FourierPoisson solverOf(const Lattice& lattice, Eigenvalues form)
{
    const KernelSettings kernel = test::exactKernel();
    const DerivativeSymbol derivative(lattice, kernel, nullptr);
    return {lattice, invertedEigenvalues(derivative.rows(), poissonEigenvalues(lattice, form, derivative, {}))};
}

TEST(FourierPoisson, SolvesAManufacturedProblem)
{
    // phi = sin(2 pi x) cos(6 pi y): lap phi = -40 pi^2 phi.
    const Lattice lattice = periodicBox({12, 15, 1}, {1, 1, 0});
    FourierPoisson solver = solverOf(lattice, Eigenvalues::exact);
    const RealField exact = fieldOf(
        lattice, 1, [](int, double x, double y, double) { return std::sin(2 * pi * x) * std::cos(6 * pi * y); });
    const RealField source = fieldOf(lattice, 1,
                                     [](int, double x, double y, double)
                                     { return -40 * pi * pi * std::sin(2 * pi * x) * std::cos(6 * pi * y); });
    RealField phi(1, lattice.points());
    solver.solve(source, phi);
    EXPECT_LE(relativeL2(phi, exact), 1e-14); // round-off of two transforms
}

TEST(FourierPoisson, SolvesInThreeDimensions)
{
    const Lattice lattice = periodicBox({8, 9, 10}, {1, 2, 0.5}, {3, -1, 7});
    FourierPoisson solver = solverOf(lattice, Eigenvalues::exact);
    const auto wave = [](int, double x, double y, double z)
    { return std::sin(2 * pi * x) * std::cos(pi * y) * std::sin(4 * pi * z); };
    const RealField exact = fieldOf(lattice, 1, wave);
    const RealField source = fieldOf(
        lattice, 1, [&](int c, double x, double y, double z) { return -(4 + 1 + 16) * pi * pi * wave(c, x, y, z); });
    RealField phi(1, lattice.points());
    solver.solve(source, phi);
    EXPECT_LE(relativeL2(phi, exact), 1e-13); // coordinates away from 0 round the waves' phases
}

TEST(FourierPoisson, HasTheOrderOfItsDifferences)
{
    const auto error = [](int n, Eigenvalues form)
    {
        const Lattice lattice = periodicBox({n, 4, 1}, {1, 1, 0});
        FourierPoisson solver = solverOf(lattice, form);
        const RealField exact = fieldOf(lattice, 1, [](int, double x, double, double) { return std::sin(2 * pi * x); });
        const RealField source =
            fieldOf(lattice, 1, [](int, double x, double, double) { return -4 * pi * pi * std::sin(2 * pi * x); });
        RealField phi(1, lattice.points());
        solver.solve(source, phi);
        return relativeL2(phi, exact);
    };
    // Next terms: a tenth of (k dx)^2, 0.02 at 32 points.
    EXPECT_NEAR(std::log2(error(16, Eigenvalues::secondOrder) / error(32, Eigenvalues::secondOrder)), 2, 0.05);
    EXPECT_NEAR(std::log2(error(16, Eigenvalues::fourthOrder) / error(32, Eigenvalues::fourthOrder)), 4, 0.05);
}

TEST(FourierPoisson, GivesAMeanOfZeroAndLeavesItsSource)
{
    const Lattice lattice = test::unitSquare(8);
    FourierPoisson solver = solverOf(lattice, Eigenvalues::exact);
    RealField source = test::noise(lattice, 1, 1);
    for (double& value : source[0]) { value += 5; } // no solution has this mean: it is left out
    const RealField before = copyOf(source);
    RealField phi(1, lattice.points());
    solver.solve(source, phi);
    double mean = 0;
    for (const double value : phi[0]) { mean += value; }
    EXPECT_NEAR(mean, 0, 1e-15 * 64);
    EXPECT_EQ(relativeL2(source, before), 0);
}

TEST(FourierPoisson, LeavesCheckerboardsOfAConsistentSolverOut)
{
    const Lattice lattice = test::unitSquare(8);
    FourierPoisson solver = solverOf(lattice, Eigenvalues::consistent);
    const RealField checkerboard = fieldOf(
        lattice, 1, [](int, double x, double y, double) { return std::cos(8 * pi * x) * std::cos(8 * pi * y); });
    RealField phi(1, lattice.points());
    solver.solve(checkerboard, phi);
    for (const double value : phi[0]) { EXPECT_NEAR(value, 0, 1e-16); }
}

TEST(FourierPoisson, LosesNoModesOfAStretchedBox)
{
    // L_x/L_y = 1000: the longest wave in x has an eigenvalue 1e-6/N^2 of the largest.
    const Lattice lattice = periodicBox({32, 32, 1}, {1000, 1, 0});
    for (const Eigenvalues form : {Eigenvalues::exact, Eigenvalues::consistent, Eigenvalues::secondOrder})
    {
        FourierPoisson solver = solverOf(lattice, form);
        const double k = 2 * pi / 1000;
        const double eigenvalue =
            form == Eigenvalues::secondOrder ? std::pow(2 * std::sin(pi / 32) / (1000.0 / 32), 2) : k * k;
        const RealField exact = fieldOf(lattice, 1, [k](int, double x, double, double) { return std::sin(k * x); });
        RealField source = copyOf(exact);
        for (double& value : source[0]) { value *= -eigenvalue; }
        RealField phi(1, lattice.points());
        solver.solve(source, phi);
        EXPECT_LE(relativeL2(phi, exact), 1e-13); // round-off of the wave times its second difference
    }
}

} // namespace
} // namespace isph
