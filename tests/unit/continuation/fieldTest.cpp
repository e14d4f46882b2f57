#include "continuation/ContinuedDerivative.hpp"
#include "continuation/continuedField.hpp"
#include "continuation/Mirror.hpp"
#include "continuation/SmoothGram.hpp"
#include "continuation/smoothness.hpp"
#include "kernels/ExactKernel.hpp"
#include "kernels/Gaussian.hpp"
#include "kernels/QuinticSpline.hpp"
#include "support/messageOf.hpp"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

namespace isph
{
namespace
{

constexpr double pi = std::numbers::pi;

Axis boundedAxis(char name, double origin, double extent, int count)
{
    return {name, origin, extent, count, Axis::Ends::bounded, false};
}

Axis periodicAxis(char name, double extent, int count) { return {name, 0, extent, count, Axis::Ends::periodic, false}; }

/// x periodic, y and z bounded, all different.
Lattice mixedLattice()
{
    return {{periodicAxis('x', 2, 12), boundedAxis('y', -0.5, 1, 41), boundedAxis('z', 0, 2, 81)}, {}};
}

template<class Function>
RealField evaluated(const Lattice& lattice, Function f)
{
    RealField values(1, lattice.points());
    const auto at = lattice.coordinates();
    for (std::size_t n = 0; n < lattice.points(); ++n) { values[0][n] = f(at[0][n], at[1][n], at[2][n]); }
    return values;
}

double largestDifference(std::span<const double> a, std::span<const double> b)
{
    double largest = 0;
    for (std::size_t n = 0; n < a.size(); ++n) { largest = std::max(largest, std::abs(a[n] - b[n])); }
    return largest;
}

KernelSettings settingsOf(std::unique_ptr<Kernel> kernel, double smoothingLength, KernelSettings::Symbol symbol)
{
    KernelSettings settings;
    settings.kernel = std::move(kernel);
    settings.smoothingLength = smoothingLength;
    settings.symbol = symbol;
    settings.supportRadius = settings.kernel->supportRadius();
    return settings;
}

TEST(LineLayout, FindsTheLinesOfEachAxis)
{
    const Lattice lattice({periodicAxis('x', 1, 4), boundedAxis('y', 0, 1, 5), boundedAxis('z', 0, 1, 6)}, {});
    RealField values(1, lattice.points());
    for (std::size_t n = 0; n < lattice.points(); ++n) { values[0][n] = static_cast<double>(n); }
    for (int direction = 0; direction < 3; ++direction)
    {
        const LineLayout layout = linesAlong(lattice, direction);
        EXPECT_EQ(layout.points(), lattice.points());
        RealField copy(1, lattice.points());
        for (std::size_t first = 0; first < layout.lines(); first += 7)
        {
            RealField lines(7, layout.count);
            gatherLines(values[0], layout, first, lines);
            EXPECT_EQ(lines[0][1] - lines[0][0], static_cast<double>(layout.inner));
            scatterLines(lines, layout, first, copy[0]);
        }
        EXPECT_EQ(largestDifference(values[0], copy[0]), 0) << direction;
    }
}

TEST(ContinuedDerivative, WorksAlongEveryAxisOfThreeDimensions)
{
    const Lattice lattice = mixedLattice();
    const auto f = [](double x, double y, double z) { return std::sin(pi * x) * std::exp(y) * std::cos(z); };
    const RealField values = evaluated(lattice, f);
    KernelSettings exact;
    exact.kernel = std::make_unique<ExactKernel>();
    const std::array<RealField, 3> expected{
        evaluated(lattice,
                  [](double x, double y, double z) { return pi * std::cos(pi * x) * std::exp(y) * std::cos(z); }),
        evaluated(lattice, f),
        evaluated(lattice, [](double x, double y, double z) { return -std::sin(pi * x) * std::exp(y) * std::sin(z); })};
    const std::array<double, 3> eigenvalue{-pi * pi, 1, -1};
    for (int direction = 0; direction < 3; ++direction)
    {
        const Axis& axis = lattice.axis(direction);
        std::optional<LineContinuation> continuation;
        if (!axis.periodic())
        {
            continuation = LineContinuation(SmoothGram(automaticNewPoints(axis.count)), axis.count);
        }
        ContinuedTransform transform(linesAlong(lattice, direction), continuation, axis.spacing());
        EXPECT_EQ(transform.length(), axis.count + (axis.periodic() ? 0 : automaticNewPoints(axis.count)));
        const LineSymbol symbol = lineSymbol(exact, transform.length(), axis.spacing());
        ContinuedDerivative derivative(std::move(transform), symbol);
        RealField first(1, lattice.points());
        RealField second(1, lattice.points());
        derivative(values[0], first[0], second[0]);
        const bool bounded = !axis.periodic();
        EXPECT_LT(largestDifference(first[0], expected[static_cast<std::size_t>(direction)][0]),
                  bounded ? 2e-6 : 1e-13);
        for (double& value : second[0]) { value /= eigenvalue[static_cast<std::size_t>(direction)]; }
        EXPECT_LT(largestDifference(second[0], values[0]), bounded ? 3e-4 : 1e-13) << direction;
        RealField alone(1, lattice.points());
        derivative(values[0], alone[0], {});
        EXPECT_EQ(largestDifference(alone[0], first[0]), 0);
    }
}

TEST(LineSymbol, IsTheKernelsClosedOne)
{
    const Gaussian kernel(6);
    const LineSymbol symbol =
        lineSymbol(settingsOf(std::make_unique<Gaussian>(6), 1.4, KernelSettings::Symbol::closed), 20, 0.1);
    ASSERT_EQ(symbol.first.size(), 11U);
    for (int m = 0; m <= 10; ++m)
    {
        const double k = 2 * pi * m / 2;
        const double W = kernel.symbol(0.25 * k * k * 0.14 * 0.14);
        EXPECT_NEAR(symbol.first[static_cast<std::size_t>(m)], m == 10 ? 0 : k * W, 1e-13 * k);
        EXPECT_NEAR(symbol.second[static_cast<std::size_t>(m)], k * k * W, 1e-13 * k * k);
    }
}

TEST(LineSymbol, OfSamplesComesNearTheClosedOne)
{
    // A wide kernel is sampled well; what is left is aliasing, exp(-(pi h/dx)^2/4) of the order of 1e-4 at h = 2 dx.
    const auto sampled =
        lineSymbol(settingsOf(std::make_unique<Gaussian>(4), 2, KernelSettings::Symbol::sampled), 64, 0.1);
    const auto closed =
        lineSymbol(settingsOf(std::make_unique<Gaussian>(4), 2, KernelSettings::Symbol::closed), 64, 0.1);
    for (std::size_t m = 0; m < closed.first.size(); ++m)
    {
        EXPECT_NEAR(sampled.first[m], closed.first[m], 0.2) << m;
        EXPECT_NEAR(sampled.second[m], closed.second[m], 3) << m;
    }
    EXPECT_NEAR(sampled.first[1], closed.first[1], 1e-3 * closed.first[1]);
}

TEST(LineSymbol, OfRenormalisedSamplesIsConsistent)
{
    auto settings = settingsOf(std::make_unique<QuinticSpline>(), 1.2, KernelSettings::Symbol::sampled);
    settings.renormalise = true;
    const LineSymbol symbol = lineSymbol(settings, 4000, 0.1);
    const double k = 2 * pi / 400;
    EXPECT_NEAR(symbol.first[1], k, 1e-5 * k);
    EXPECT_NEAR(symbol.second[1], k * k, 1e-5 * k * k);
    EXPECT_THAT(messageOf([&settings] { lineSymbol(settings, 6, 0.1); }),
                testing::HasSubstr("the kernel reaches 3 points to each side, too far for a line of 6"));
}

TEST(ContinuedField, IsPeriodicAndKeepsItsPoints)
{
    const Lattice lattice = mixedLattice();
    Continuations continuations;
    continuations[1] = std::make_unique<SmoothGram>(25);
    continuations[2] = std::make_unique<SmoothGram>(27);
    const Lattice extended = extendedLattice(lattice, continuations);
    EXPECT_TRUE(extended.periodic());
    EXPECT_EQ(extended.axis(0).count, 12);
    EXPECT_EQ(extended.axis(1).count, 66);
    EXPECT_EQ(extended.axis(2).count, 108);
    EXPECT_NEAR(extended.axis(1).spacing(), lattice.axis(1).spacing(), 1e-15);
    EXPECT_EQ(extended.axis(1).coordinate(0), -0.5);

    const RealField values = evaluated(lattice, [](double x, double y, double z)
                                       { return std::sin(pi * x) * (1 + y * y) * (2 - z + z * z); });
    const RealField continued = continuedField(values, lattice, continuations);
    ASSERT_EQ(continued.size(), extended.points());
    for (std::size_t iz : {0U, 40U, 80U})
    {
        for (std::size_t iy : {0U, 7U, 40U})
        {
            for (std::size_t ix : {0U, 5U, 11U})
            {
                EXPECT_EQ(continued[0][ix + 12 * (iy + 66 * iz)], values[0][ix + 12 * (iy + 41 * iz)]);
            }
        }
    }
    // A product of lines is continued as the product of their continuations, also in the corner of both, up to
    // round-off times the amplification of each, 4e4.
    const LineContinuation alongY(*continuations[1], 41);
    std::vector<double> y(66);
    for (std::size_t i = 0; i < 41; ++i) { y[i] = 1 + std::pow(lattice.axis(1).coordinate(static_cast<int>(i)), 2); }
    alongY.extend(y);
    const LineContinuation alongZ(*continuations[2], 81);
    std::vector<double> z(108);
    for (std::size_t i = 0; i < 81; ++i)
    {
        const double at = lattice.axis(2).coordinate(static_cast<int>(i));
        z[i] = 2 - at + at * at;
    }
    alongZ.extend(z);
    const double sine = std::sin(pi * lattice.axis(0).coordinate(3));
    for (std::size_t iz : {3U, 90U, 107U})
    {
        for (std::size_t iy : {2U, 50U, 65U})
        {
            EXPECT_NEAR(continued[0][3 + 12 * (iy + 66 * iz)], sine * y[iy] * z[iz], 1e-6);
        }
    }
}

TEST(Smoothness, SeesHowManyDerivativesMatch)
{
    const auto lineOf = [](const Continuation& continuation)
    {
        const int n = 101;
        const LineContinuation ready(continuation, n);
        std::vector<double> line(static_cast<std::size_t>(ready.extendedPoints()));
        for (int i = 0; i < n; ++i) { line[static_cast<std::size_t>(i)] = std::exp(0.01 * i) * std::sin(0.05 * i); }
        ready.extend(line);
        return line;
    };
    const Smoothness smooth = smoothnessOf(lineOf(SmoothGram(25)), 101);
    const Smoothness mirrored = smoothnessOf(lineOf(Mirror(25, false)), 101);
    EXPECT_LT(smooth.upperJump[0], 1e-5);
    EXPECT_LT(smooth.lowerJump[0], 1e-5);
    EXPECT_LT(smooth.upperJump[1], 1e-7);
    EXPECT_LT(smooth.lowerJump[1], 1e-7);
    // A reflected value keeps the slope, but the curvature changes its sign: e (-24 sin 5 + 10 cos 5) dx^2.
    EXPECT_LT(mirrored.upperJump[0], 1e-5);
    EXPECT_GT(mirrored.upperJump[1], 1e-3);
    EXPECT_LT(smooth.tail, 1e-8);
    EXPECT_GT(mirrored.tail, 1e-6);
    EXPECT_EQ(smoothnessOf(std::vector<double>(20, 0.0), 10).tail, 0);
}

TEST(DifferenceWeights, AreThoseOfTables)
{
    const std::vector<double> central{-1, 0, 1};
    EXPECT_THAT(differenceWeights(central, 1), testing::ElementsAre(-0.5, 0, 0.5));
    EXPECT_THAT(differenceWeights(central, 2), testing::ElementsAre(1, -2, 1));
    const std::vector<double> forward{0, 1, 2};
    EXPECT_THAT(differenceWeights(forward, 1), testing::ElementsAre(-1.5, 2, -0.5));
}

} // namespace
} // namespace isph
