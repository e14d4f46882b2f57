#include "continuation/Gram.hpp"
#include "continuation/LineContinuation.hpp"
#include "continuation/Mirror.hpp"
#include "continuation/Polynomial.hpp"
#include "continuation/SmoothGram.hpp"
#include "support/messageOf.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>
#include <vector>

namespace isph
{
namespace
{

TEST(SmoothStep, HasTheCheckValues)
{
    EXPECT_NEAR(smoothStep(16, 1.0 / 26), 5.6960628355406e-16, 1e-29);
    EXPECT_NEAR(smoothStep(16, 5.0 / 26), 3.2431063859232e-05, 1e-18);
    EXPECT_NEAR(smoothStep(16, 10.0 / 26), 0.087850698323553, 1e-15);
    EXPECT_NEAR(smoothStep(16, 12.0 / 26), 0.32783051678670, 1e-14);
    for (const double t : {0.0, 0.1, 0.4, 0.5, 0.7, 1.0})
    {
        EXPECT_NEAR(smoothStep(2, t), t * t * t * (10 - 15 * t + 6 * t * t), 4e-16) << t;
        EXPECT_NEAR(smoothStep(16, t) + smoothStep(16, 1 - t), 1, 1e-15) << t;
    }
}

/// Weights without the blending, which is divided out; only where it leaves something.
double unblended(const EndBlock& block, int k, int c, int smoothness)
{
    return block.weight(k, c) / (1 - smoothStep(smoothness, static_cast<double>(k) / (block.newPoints + 1)));
}

TEST(SmoothGram, HasTheCheckWeights)
{
    const EndBlock block = SmoothGram(25).end(EndCondition::dirichlet);
    ASSERT_EQ(block.points, 5);
    const std::vector<double> first{5, -10, 10, -5, 1};
    const std::vector<double> middle{1190, -4420, 6188, -3867.5, 910};
    for (int c = 0; c < 5; ++c)
    {
        EXPECT_NEAR(unblended(block, 1, c, 16), first[static_cast<std::size_t>(c)], 1e-13);
        // Half-way the blending is a half.
        EXPECT_NEAR(block.weight(13, c), middle[static_cast<std::size_t>(c)], 1e-11);
    }
    EXPECT_TRUE(block.data.empty());
}

TEST(AutomaticNewPoints, MakeTheLengthFourTimesASmallProduct)
{
    const std::vector<std::pair<int, int>> known{{33, 27},  {49, 31},  {65, 31},  {97, 31},  {101, 27},
                                                 {129, 31}, {161, 31}, {193, 31}, {201, 39}, {257, 31},
                                                 {401, 31}, {513, 27}, {601, 39}};
    for (const auto& [n, d] : known) { EXPECT_EQ(automaticNewPoints(n), d) << n; }
}

struct Named
{
    std::string name;
    std::unique_ptr<Continuation> continuation;
    int degree; ///< of the polynomials that each end goes on
};

std::vector<Named> extrapolating()
{
    std::vector<Named> all;
    for (int P = 3; P <= 6; ++P)
    {
        all.push_back({"smoothGram " + std::to_string(P), std::make_unique<SmoothGram>(25, P), P});
    }
    all.push_back({"polynomial 5 of 8", std::make_unique<Polynomial>(12, 5, 8), 5});
    all.push_back({"polynomial 3 of 20", std::make_unique<Polynomial>(16, 3, 20, 9), 3});
    all.push_back({"mirror", std::make_unique<Mirror>(25, false), 1});
    return all;
}

/// Largest difference between the extension of a polynomial and the polynomials of both ends, blended.
double extensionError(const Continuation& continuation, int smoothness, int power)
{
    const int n = 40;
    const LineContinuation line(continuation, n);
    const int d = line.newPoints();
    std::vector<double> values(static_cast<std::size_t>(n + d));
    const auto f = [power](double i) { return std::pow(i / 40, power); };
    for (int i = 0; i < n; ++i) { values[static_cast<std::size_t>(i)] = f(i); }
    line.extend(values);
    double largest = 0;
    for (int k = 1; k <= d; ++k)
    {
        const double sigma = smoothStep(smoothness, static_cast<double>(k) / (d + 1));
        const double expected = (1 - sigma) * f(n - 1 + k) + sigma * f(-(d + 1 - k));
        largest = std::max(largest, std::abs(values[static_cast<std::size_t>(n - 1 + k)] - expected));
    }
    return largest;
}

TEST(Continuation, ReproducesPolynomials)
{
    const std::vector<int> smoothness{16, 16, 16, 16, 2, 9, 16};
    std::size_t index = 0;
    for (const auto& [name, continuation, degree] : extrapolating())
    {
        for (int power = 0; power <= degree; ++power)
        {
            // Round-off times the sum of the weights' magnitudes, up to 1e8 for degree 6.
            EXPECT_LT(extensionError(*continuation, smoothness[index], power), degree == 6 ? 1e-7 : 1e-9)
                << name << ", power " << power;
        }
        ++index;
    }
}

TEST(Continuation, ContinuesAConstantAsItIs)
{
    for (const auto& [name, continuation, degree] : extrapolating())
    {
        const EndBlock block = continuation->end(EndCondition::dirichlet);
        for (int k = 1; k <= block.newPoints; ++k)
        {
            double sum = 0;
            double magnitudes = 0;
            for (const int row : {k, block.newPoints + 1 - k})
            {
                for (int c = 0; c < block.points; ++c)
                {
                    sum += block.weight(row, c);
                    magnitudes += std::abs(block.weight(row, c));
                }
            }
            EXPECT_NEAR(sum, 1, 1e-15 * (1 + 4 * magnitudes)) << name << ", row " << k;
        }
    }
}

TEST(Continuation, GoesOnWithTheDerivativeOfTheWall)
{
    // A polynomial of one degree more for smoothGram, of the same for a fit, of degree 2 without its square for mirror.
    const int n = 40;
    const double dx = 0.025;
    std::vector<Named> all;
    all.push_back({"smoothGram", std::make_unique<SmoothGram>(25, 4), 5});
    all.push_back({"polynomial", std::make_unique<Polynomial>(12, 5, 8, 16), 5});
    all.push_back({"mirror", std::make_unique<Mirror>(25, false), 1});
    for (const auto& [name, continuation, degree] : all)
    {
        const LineContinuation line(*continuation, n, EndCondition::neumann, EndCondition::neumann);
        const int d = line.newPoints();
        for (int power = 0; power <= degree; ++power)
        {
            const auto f = [power](double x) { return std::pow(x, power); };
            const auto slope = [power](double x) { return power == 0 ? 0 : power * std::pow(x, power - 1); };
            std::vector<double> values(static_cast<std::size_t>(n + d));
            for (int i = 0; i < n; ++i) { values[static_cast<std::size_t>(i)] = f(i * dx); }
            line.extend(values, -slope(0) * dx, slope((n - 1) * dx) * dx);
            for (int k = 1; k <= d; ++k)
            {
                const double sigma = smoothStep(16, static_cast<double>(k) / (d + 1));
                const double expected = (1 - sigma) * f((n - 1 + k) * dx) + sigma * f(-(d + 1 - k) * dx);
                EXPECT_NEAR(values[static_cast<std::size_t>(n - 1 + k)], expected, 1e-8) << name << ' ' << power;
            }
        }
    }
}

TEST(Mirror, ReflectsOddlyAndEvenly)
{
    const double pi = std::numbers::pi;
    const int n = 21;
    const LineContinuation odd(Mirror(n - 2, false), n);
    const LineContinuation even(Mirror(n - 2, false), n, EndCondition::neumann, EndCondition::neumann);
    const LineContinuation staggeredOdd(Mirror(n, true), n);
    const LineContinuation staggeredEven(Mirror(n, true), n, EndCondition::neumann, EndCondition::neumann);
    const auto check = [&](const LineContinuation& line, double shift, double intervals, auto f)
    {
        std::vector<double> values(static_cast<std::size_t>(line.extendedPoints()));
        for (int i = 0; i < n; ++i) { values[static_cast<std::size_t>(i)] = f(pi * (i + shift) / intervals); }
        line.extend(values);
        for (int i = 0; i < line.extendedPoints(); ++i)
        {
            EXPECT_NEAR(values[static_cast<std::size_t>(i)], f(pi * (i + shift) / intervals), 1e-14) << i;
        }
    };
    const auto sine = [](double x) { return std::sin(x) + std::sin(3 * x); };
    const auto cosine = [](double x) { return 1 + std::cos(x) + std::cos(2 * x); };
    check(odd, 0, n - 1, sine);
    check(even, 0, n - 1, cosine);
    check(staggeredOdd, 0.5, n, sine);
    check(staggeredEven, 0.5, n, cosine);
}

TEST(Mirror, KnowsTheValuesAndSlopesOfStaggeredWalls)
{
    const int n = 10;
    const EndBlock value = Mirror(4, true).end(EndCondition::dirichlet);
    const EndBlock slope = Mirror(4, true).end(EndCondition::neumann);
    // f = 2 + 3x with the wall half a spacing outside, x outward from the wall: f_c = 2 - 3(c + 1/2).
    for (int k = 1; k <= 4; ++k)
    {
        double fromValue = 2 * value.data[static_cast<std::size_t>(k - 1)];
        double fromSlope = 3 * slope.data[static_cast<std::size_t>(k - 1)];
        for (int c = 0; c < value.points; ++c)
        {
            fromValue += value.weight(k, c) * (2 - 3 * (c + 0.5));
            fromSlope += slope.weight(k, c) * (2 - 3 * (c + 0.5));
        }
        const double expected = (1 - smoothStep(16, k / 5.0)) * (2 + 3 * (k - 0.5));
        EXPECT_NEAR(fromValue, expected, 1e-13) << n;
        EXPECT_NEAR(fromSlope, expected, 1e-13) << n;
    }
}

TEST(Continuation, RefusesWhatItCannotDo)
{
    EXPECT_THAT(messageOf([] { SmoothGram(25, 9); }), testing::HasSubstr("degree 9 is not one of 1 ... 8"));
    EXPECT_THAT(messageOf([] { SmoothGram(0); }), testing::HasSubstr("an extension of 0 points is none"));
    EXPECT_THAT(messageOf([] { SmoothGram(25, 4, 61); }), testing::HasSubstr("smoothness 61 is not one of 0 ... 60"));
    EXPECT_THAT(messageOf([] { Polynomial(12, 5, 5); }),
                testing::HasSubstr("5 points do not determine a polynomial of degree 5\n    write at least points 6;"));
    EXPECT_THAT(messageOf([] { Gram(4); }), testing::HasSubstr("an extension of 4 points has no table of FC(Gram)"));
    EXPECT_THAT(messageOf([] { Gram(25).end(EndCondition::neumann); }),
                testing::HasSubstr("not derivatives at the wall"));
    EXPECT_THAT(messageOf([] { LineContinuation(SmoothGram(25), 4); }),
                testing::HasSubstr("the continuation uses 5 points at each end, but the axis has 4"));
}

} // namespace
} // namespace isph
