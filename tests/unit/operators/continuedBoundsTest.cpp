#include "operators/continuedBounds.hpp"

#include "continuation/Mirror.hpp"
#include "continuation/Polynomial.hpp"
#include "continuation/SmoothGram.hpp"
#include "operators/lineSymbolOf.hpp"
#include "support/kernels.hpp"
#include "support/periodicBox.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace isph
{
namespace
{

using std::numbers::pi;

/// x periodic, y between walls.
Lattice channel(int nx, int ny)
{
    const Axis x{.name = 'x', .extent = 1, .count = nx};
    const Axis y{.name = 'y', .extent = 1, .count = ny, .ends = Axis::Ends::bounded};
    return {{x, y, Axis{.name = 'z'}}, {}};
}

Continuations walls(int newPoints)
{
    Continuations continuations;
    continuations[1] = std::make_unique<SmoothGram>(newPoints, 4, 16);
    return continuations;
}

TEST(ContinuedBounds, OfTheExactDerivativeReachTheNyquistWavenumberOfEachAxis)
{
    const Lattice lattice = channel(64, 33); // dx = 1/64, dy = 1/32; 33 + 27 new points are 60
    const OperatorBounds bounds = continuedBounds(lattice, walls(27), test::exactKernel());
    EXPECT_NEAR(bounds.laplacian, pi * pi * (64 * 64 + 32 * 32), 1e-6);
    EXPECT_DOUBLE_EQ(bounds.derivative[0], 64 * pi * 31 / 32); // the Nyquist mode has no first derivative
    EXPECT_DOUBLE_EQ(bounds.derivative[1], 32 * pi * 29 / 30);
    EXPECT_DOUBLE_EQ(bounds.derivativeMagnitude, std::hypot(bounds.derivative[0], bounds.derivative[1]));
    EXPECT_DOUBLE_EQ(bounds.derivativeOverLaplacian, 1);
    EXPECT_EQ(bounds.leastLaplacian, 0);
}

/// Largest second derivative of lines between walls, in units of (pi/dx)^2.
double radius(const KernelSettings& kernel, std::unique_ptr<Continuation> continuation, int points = 65)
{
    Axis wide{.name = 'x', .extent = 1, .count = 4096};
    wide.extent = 1e6; // its own part vanishes
    const Axis y{.name = 'y', .extent = 1, .count = points, .ends = Axis::Ends::bounded};
    const Lattice lattice({wide, y, Axis{.name = 'z'}}, {});
    Continuations continuations;
    continuations[1] = std::move(continuation);
    return continuedBounds(lattice, continuations, kernel).laplacian / std::pow(pi * (points - 1), 2);
}

std::unique_ptr<Continuation> smooth(int degree) { return std::make_unique<SmoothGram>(25, degree, 16); }

TEST(ContinuedBounds, KnowTheModesAtWalls)
{
    // Eigenvalues of the matrices, by a dense solver; the symbols alone reach 0.466, 0.201 and 0.085.
    EXPECT_NEAR(radius(test::closedGaussian(8, 1.3), smooth(4)), 0.466, 0.002);
    EXPECT_NEAR(radius(test::closedGaussian(4, 1.3), smooth(4)), 0.258, 0.005);
    EXPECT_NEAR(radius(test::closedGaussian(4, 2), smooth(4)), 0.247, 0.005);
    EXPECT_NEAR(radius(test::closedGaussian(4, 2), smooth(3)), 0.188, 0.005);
    EXPECT_NEAR(radius(test::closedGaussian(4, 2), std::make_unique<Mirror>(25, false, 16)), 0.085, 0.005);
}

TEST(ContinuedBounds, TellWhereAContinuationMakesModesGrow)
{
    // Lin, Fourtakas & Rogers' polynomial through few points (docs/theory/continuation.md).
    const auto least = [](int points, const KernelSettings& kernel)
    {
        Continuations continuations;
        continuations[1] = std::make_unique<Polynomial>(32, 5, points, 2);
        return continuedBounds(channel(128, 129), continuations, kernel).leastLaplacian;
    };
    EXPECT_LT(least(8, test::closedGaussian(4, 1.3)), -5e4);
    EXPECT_EQ(least(32, test::closedGaussian(4, 1.3)), 0);
    EXPECT_EQ(continuedBounds(channel(64, 33), walls(27), test::exactKernel()).leastLaplacian, 0);
}

TEST(LineSymbolOf, HasThreeFormsThatAgreeForLongWaves)
{
    constexpr int length = 400;
    constexpr double dx = 0.01;
    const double k = 2 * pi / (length * dx);
    for (const bool sampled : {false, true})
    {
        const KernelSettings kernel = sampled ? test::sampledGaussian(4, 2, 6) : test::closedGaussian(4, 2);
        for (const LaplacianForm form : {LaplacianForm::morris, LaplacianForm::secondDerivative, LaplacianForm::exact})
        {
            const LineSymbol symbol = lineSymbolOf(kernel, form, length, dx);
            EXPECT_NEAR(symbol.second[1] / (k * k), 1, 1e-6);
            EXPECT_GE(*std::ranges::min_element(symbol.second), -1e-9 * symbol.second.back());
        }
    }
}

TEST(LineSymbolOf, SampledMorrisIsItsClosedFormWhereNothingIsCutOff)
{
    const LineSymbol closed = lineSymbolOf(test::closedGaussian(4, 2), LaplacianForm::morris, 200, 0.01);
    const LineSymbol sampled = lineSymbolOf(test::sampledGaussian(4, 2, 8), LaplacianForm::morris, 200, 0.01);
    for (std::size_t m = 1; m <= 50; ++m)
    {
        EXPECT_NEAR(sampled.second[m], closed.second[m], 1e-6 * closed.second[50]) << m;
    }
}

} // namespace
} // namespace isph
