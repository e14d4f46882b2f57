#include "continuation/LineEigenbasis.hpp"

#include "continuation/ContinuedDerivative.hpp"
#include "continuation/Polynomial.hpp"
#include "continuation/SmoothGram.hpp"
#include "support/kernels.hpp"
#include "support/messageOf.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>
#include <optional>
#include <random>

namespace isph
{
namespace
{

using test::closedGaussian;
using test::exactKernel;

constexpr double pi = std::numbers::pi;

/// An end, and whether the continuation itself has slope zero there (for free ends).
struct TestEnd
{
    LineEnd end;
    bool level = false;

    EndCondition condition() const { return level ? EndCondition::neumann : EndCondition::dirichlet; }
};

const TestEnd value{LineEnd::value};
const TestEnd slope{LineEnd::slope};
const TestEnd level{LineEnd::free, true};

/// Lines over [0, 1] with both walls among their points, by default of degree 4 with the exact derivative.
struct Problem
{
    Problem(int n, TestEnd low, TestEnd high, std::size_t inner = 1, std::size_t outer = 1, int degree = 4,
            const KernelSettings& kernel = exactKernel())
        : layout{inner, static_cast<std::size_t>(n), outer},
          line(SmoothGram(automaticNewPoints(n), degree), n, low.condition(), high.condition()),
          symbol(lineSymbol(kernel, line.extendedPoints(), 1.0 / (n - 1))),
          basis(layout, line, symbol, low.end, high.end, 1.0 / (n - 1)),
          derivative(ContinuedTransform(layout, line, 1.0 / (n - 1)), symbol)
    {
    }

    LineLayout layout;
    LineContinuation line;
    LineSymbol symbol;
    LineEigenbasis basis;
    ContinuedDerivative derivative;
};

AlignedVector<double> randomValues(std::size_t size, unsigned seed)
{
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    AlignedVector<double> values(size);
    for (double& entry : values) { entry = uniform(engine); }
    return values;
}

/// Calls visit(point, line, index) for all points of all lines.
template<class Visit>
void forAll(const LineLayout& layout, Visit visit)
{
    for (std::size_t line = 0; line < layout.lines(); ++line)
    {
        for (std::size_t i = 0; i < layout.count; ++i) { visit(layout.start(line) + i * layout.inner, line, i); }
    }
}

double largest(std::span<const double> values)
{
    double result = 0;
    for (const double entry : values) { result = std::max(result, std::abs(entry)); }
    return result;
}

TEST(LineEigenbasis, HasTheEigenvaluesOfTheInterval)
{
    for (const int degree : {3, 4})
    {
        const Problem walls(65, value, value, 1, 1, degree);
        EXPECT_NEAR(walls.basis.eigenvalues()[0], -pi * pi, 1e-6 * pi * pi);
        EXPECT_LT(walls.basis.condition(), 1.6); // 1.15 and 1.5
        EXPECT_FALSE(walls.basis.constantMode());
        for (const double eigenvalue : walls.basis.eigenvalues()) { EXPECT_LT(eigenvalue, 0); }

        const Problem slopes(65, slope, slope, 1, 1, degree);
        EXPECT_TRUE(slopes.basis.constantMode());
        EXPECT_EQ(slopes.basis.eigenvalues()[0], 0);
        EXPECT_NEAR(slopes.basis.eigenvalues()[1], -4 * pi * pi, degree == 4 ? 3e-4 : 2e-2); // even ones come first
        EXPECT_LT(slopes.basis.condition(), 3);

        const Problem mixed(65, slope, value, 1, 1, degree);
        EXPECT_NEAR(mixed.basis.eigenvalues()[0], -0.25 * pi * pi, 1e-4);
        EXPECT_LT(mixed.basis.condition(), 3);
        EXPECT_FALSE(mixed.basis.constantMode());

        const Problem levels(65, level, level, 1, 1, degree);
        EXPECT_TRUE(levels.basis.constantMode());
        EXPECT_LT(levels.basis.condition(), 3);
        EXPECT_EQ(levels.basis.count(), 65U);
    }
}

TEST(LineEigenbasis, GoesToModesAndBack)
{
    // Lines along each axis, in numbers that fill no batch; even and odd counts.
    for (const auto& [inner, outer] : {std::pair<std::size_t, std::size_t>{1, 45}, {1, 3}, {37, 1}, {5, 9}, {70, 2}})
    {
        for (const int n : {16, 33})
        {
            for (const TestEnd high : {value, slope, level})
            {
                Problem problem(n, value, high, inner, outer);
                const AlignedVector<double> values = randomValues(problem.layout.points(), 1);
                AlignedVector<double> modes = values;
                problem.basis.forward(modes);
                forAll(problem.layout,
                       [&](std::size_t point, std::size_t, std::size_t i)
                       {
                           const std::size_t known = i - problem.basis.first();
                           if (known >= problem.basis.count()) { EXPECT_EQ(modes[point], values[point]); }
                       });
                problem.basis.backward(modes);
                for (std::size_t i = 0; i < values.size(); ++i) { ASSERT_NEAR(modes[i], values[i], 1e-13); }
            }
        }
    }
}

/// Values and data at random: the derivatives of ContinuedDerivative are those of the basis, and the data hold.
TEST(LineEigenbasis, IsTheSecondDerivativeOfContinuedLines)
{
    for (const TestEnd low : {value, slope, level})
    {
        for (const TestEnd high : {value, slope, level})
        {
            for (const auto& [inner, outer] : {std::pair<std::size_t, std::size_t>{1, 3}, {3, 2}})
            {
                const int n = 40;
                Problem problem(n, low, high, inner, outer);
                LineEigenbasis& basis = problem.basis;
                const LineLayout& layout = problem.layout;
                const auto lowData = randomValues(layout.lines(), 2);
                const auto highData = randomValues(layout.lines(), 3);
                AlignedVector<double> values = randomValues(layout.points(), 4);
                basis.fillEnds(lowData, highData, values);
                AlignedVector<double> first(values.size());
                AlignedVector<double> second(values.size());
                EndData data;
                if (low.level) { data.lower = lowData; }
                if (high.level) { data.upper = highData; }
                problem.derivative(values, first, second, data);

                AlignedVector<double> own = values;
                basis.forward(own);
                forAll(layout,
                       [&](std::size_t point, std::size_t, std::size_t i)
                       {
                           const std::size_t known = i - basis.first();
                           if (known < basis.count()) { own[point] *= basis.eigenvalues()[known]; }
                       });
                basis.backward(own);
                basis.addData(1, lowData, highData, own);

                // Extrapolated noise is 1e5 times as large, and so is its round-off.
                const double tolerance = 1e5 * 1e-15 * std::pow(pi * n, 2) * largest(values);
                forAll(layout,
                       [&](std::size_t point, std::size_t line, std::size_t i)
                       {
                           const bool atLow = i == 0;
                           const bool atHigh = i + 1 == layout.count;
                           if (atLow || atHigh)
                           {
                               const LineEnd end = atLow ? low.end : high.end;
                               const double datum = atLow ? lowData[line] : highData[line];
                               if (end == LineEnd::value) { EXPECT_EQ(values[point], datum); }
                               if (end == LineEnd::slope) { EXPECT_NEAR(first[point], datum, 1e-9 * n); }
                               if (end != LineEnd::free) { return; }
                           }
                           EXPECT_NEAR(own[point], second[point], tolerance);
                       });
            }
        }
    }
}

TEST(LineEigenbasis, TakesEmptyDataForZeros)
{
    Problem problem(20, value, slope, 2, 2);
    const std::vector<double> zeros(4, 0.0);
    AlignedVector<double> with = randomValues(problem.layout.points(), 5);
    AlignedVector<double> without = with;
    problem.basis.fillEnds(zeros, zeros, with);
    problem.basis.addData(3, zeros, zeros, with);
    problem.basis.fillEnds({}, {}, without);
    problem.basis.addData(3, {}, {}, without);
    EXPECT_EQ(with, without);
}

TEST(LineEigenbasis, RefusesWhatHasNoRealBasis)
{
    EXPECT_EQ(messageOf([] { Problem(65, slope, slope, 1, 1, 4, closedGaussian(4, 1.3)); }),
              "the second derivative on a line of 63 unknown points has complex eigenvalues (imaginary parts up to "
              "0.0065 of the largest)\n    choose kernel exact or a gaussian of order 20, and continuation of degree 3 "
              "or 4");
    // Nothing holds the ends: constants and straight lines share an eigenvalue.
    const TestEnd open{LineEnd::free};
    EXPECT_THAT(messageOf([&] { Problem(65, open, open); }), testing::HasSubstr("eigenvalues"));
    // Few points and the quintic: unstable (Lin, Fourtakas & Rogers 2026, see docs/theory/continuation.md).
    const LineContinuation published(Polynomial(32, 5, 7), 129);
    const LineSymbol symbol = lineSymbol(closedGaussian(4, 1.3), published.extendedPoints(), 1.0 / 128);
    EXPECT_THAT(messageOf(
                    [&] {
                        LineEigenbasis({1, 129, 1}, published, symbol, LineEnd::value, LineEnd::value);
                    }),
                testing::HasSubstr("eigenvalues"));
}

} // namespace
} // namespace isph
