#include "spectral/RealTransform.hpp"

#include "core/Error.hpp"
#include "fields/AlignedAllocator.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace isph::test
{

namespace
{

constexpr std::array allBases{RealBasis::fourier, RealBasis::cosine1, RealBasis::cosine2,
                              RealBasis::cosine3, RealBasis::cosine4, RealBasis::sine1,
                              RealBasis::sine2,   RealBasis::sine3,   RealBasis::sine4};

/// The forward matrix, as RealBasis documents it.
long double element(RealBasis basis, int n, int k, int j)
{
    const auto wave = [](auto function, int twice, int times, int period)
    {
        // pi twice times/(4 period): the angle is reduced in integers.
        return function(std::numbers::pi_v<long double> * static_cast<long double>(twice * times % (8 * period)) /
                        static_cast<long double>(4 * period));
    };
    const auto cosine = [&](int a, int b, int period)
    { return wave([](long double x) { return std::cos(x); }, a, b, period); };
    const auto sine = [&](int a, int b, int period)
    { return wave([](long double x) { return std::sin(x); }, a, b, period); };
    const long double sign = k % 2 == 0 ? 1 : -1;
    switch (basis)
    {
    case RealBasis::fourier:
        return 2 * k <= n ? cosine(4 * j, 2 * k, n) : -sine(4 * j, 2 * (n - k), n);
    case RealBasis::cosine1:
        return j == 0 ? 1 : j == n - 1 ? sign : 2 * cosine(2 * j, 2 * k, n - 1);
    case RealBasis::cosine2:
        return 2 * cosine(2 * j + 1, 2 * k, n);
    case RealBasis::cosine3:
        return j == 0 ? 1 : 2 * cosine(2 * j, 2 * k + 1, n);
    case RealBasis::cosine4:
        return 2 * cosine(2 * j + 1, 2 * k + 1, n);
    case RealBasis::sine1:
        return 2 * sine(2 * j + 2, 2 * k + 2, n + 1);
    case RealBasis::sine2:
        return 2 * sine(2 * j + 1, 2 * k + 2, n);
    case RealBasis::sine3:
        return j == n - 1 ? sign : 2 * sine(2 * j + 2, 2 * k + 1, n);
    case RealBasis::sine4:
        return 2 * sine(2 * j + 1, 2 * k + 1, n);
    }
    return 0;
}

AlignedVector<double> noiseOf(std::size_t size, unsigned seed)
{
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    AlignedVector<double> values(size);
    for (double& value : values) { value = uniform(engine); }
    return values;
}

/// What RealTransform should do, by the dense matrix.
AlignedVector<double> denseForward(const Lines& lines, RealBasis basis, const AlignedVector<double>& values)
{
    std::size_t stride = 1;
    for (int d = 0; d < lines.axis; ++d)
    {
        stride *= static_cast<std::size_t>(lines.extents[static_cast<std::size_t>(d)]);
    }
    const auto extent = static_cast<std::size_t>(lines.extents[static_cast<std::size_t>(lines.axis)]);
    AlignedVector<double> result = values;
    for (std::size_t start = 0; start < values.size(); ++start)
    {
        if (start / stride % extent != static_cast<std::size_t>(lines.first)) { continue; }
        for (int k = 0; k < lines.count; ++k)
        {
            long double sum = 0;
            for (int j = 0; j < lines.count; ++j)
            {
                sum += element(basis, lines.count, k, j) * values[start + static_cast<std::size_t>(j) * stride];
            }
            result[start + static_cast<std::size_t>(k) * stride] = static_cast<double>(sum);
        }
    }
    return result;
}

double largestDifference(const AlignedVector<double>& a, const AlignedVector<double>& b, double factor = 1)
{
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) { largest = std::max(largest, std::abs(a[i] - factor * b[i])); }
    return largest;
}

/// Compares both directions, also outside the lines, on values of size 1.
void expectRight(const Lines& lines, RealBasis basis, unsigned seed)
{
    SCOPED_TRACE(testing::Message() << "basis " << static_cast<int>(basis) << ", axis " << lines.axis << ", count "
                                    << lines.count);
    const RealTransform transform(lines, basis);
    const std::size_t size = static_cast<std::size_t>(lines.extents[0]) * static_cast<std::size_t>(lines.extents[1]) *
                             static_cast<std::size_t>(lines.extents[2]);
    const AlignedVector<double> values = noiseOf(size, seed);
    AlignedVector<double> modes = values;
    transform.forward(modes);
    // Sums of n values of size 1 by a fast transform: a few eps sqrt(n), and n < 100.
    EXPECT_LT(largestDifference(modes, denseForward(lines, basis, values)), 2e-14);

    transform.backward(modes);
    // Values outside the lines are as they were.
    AlignedVector<double> expected = values;
    std::size_t stride = 1;
    for (int d = 0; d < lines.axis; ++d)
    {
        stride *= static_cast<std::size_t>(lines.extents[static_cast<std::size_t>(d)]);
    }
    const auto extent = static_cast<std::size_t>(lines.extents[static_cast<std::size_t>(lines.axis)]);
    for (std::size_t i = 0; i < size; ++i)
    {
        const int at = static_cast<int>(i / stride % extent);
        if (at >= lines.first && at < lines.first + lines.count) { expected[i] *= transform.factor(); }
    }
    EXPECT_LT(largestDifference(modes, expected), 2e-15 * transform.factor());
}

} // namespace

TEST(RealTransforms, equalTheirDenseMatrices)
{
    unsigned seed = 1;
    for (const RealBasis basis : allBases)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            for (const int count : {2, 3, 4, 7, 8, 9})
            {
                std::array<int, 3> extents{5, 3, 4};
                extents[static_cast<std::size_t>(axis)] = count + 2;
                expectRight({.extents = extents, .axis = axis, .first = 1, .count = count}, basis, seed++);
            }
        }
    }
}

TEST(RealTransforms, longerLinesEqualTheirDenseMatrices)
{
    // Intervals that are split never, once, several times, and down to an odd number; more and fewer lines than lanes.
    unsigned seed = 100;
    for (const int intervals : {1, 2, 27, 32, 36, 50, 64, 72, 81, 96})
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            std::array<int, 3> extents{11, 2, 9};
            extents[static_cast<std::size_t>(axis)] = intervals + 1;
            expectRight({.extents = extents, .axis = axis, .count = intervals + 1}, RealBasis::cosine1, seed++);
            if (intervals < 2) { continue; }
            expectRight({.extents = extents, .axis = axis, .first = 1, .count = intervals - 1}, RealBasis::sine1,
                        seed++);
        }
    }
}

TEST(RealTransforms, longLinesLoseNoDigits)
{
    for (const RealBasis basis : {RealBasis::cosine1, RealBasis::sine1})
    {
        for (const int intervals : {1024, 1920, 4096})
        {
            const int count = basis == RealBasis::cosine1 ? intervals + 1 : intervals - 1;
            const Lines lines{.extents = {3, count, 1}, .axis = 1, .count = count};
            const RealTransform transform(lines, basis);
            const auto values = noiseOf(3 * static_cast<std::size_t>(count), 7);
            AlignedVector<double> modes = values;
            transform.forward(modes);
            transform.backward(modes);
            EXPECT_LT(largestDifference(modes, values, transform.factor()), 2e-15 * transform.factor());

            // One mode alone: the others stay at round-off.
            const int mode = intervals / 3;
            AlignedVector<double> wave(values.size());
            for (std::size_t i = 0; i < wave.size(); ++i)
            {
                wave[i] = static_cast<double>(element(basis, count, mode, static_cast<int>(i / 3)));
                if (basis == RealBasis::cosine1 && (i < 3 || i >= wave.size() - 3)) { wave[i] *= 2; }
            }
            transform.forward(wave);
            double largest = 0;
            for (std::size_t i = 0; i < wave.size(); ++i)
            {
                if (static_cast<int>(i / 3) != mode) { largest = std::max(largest, std::abs(wave[i])); }
            }
            EXPECT_LT(largest, 1e-15 * transform.factor());
        }
    }
}

TEST(RealTransforms, undoThemselvesOnArraysLargeEnoughToBeShared)
{
    for (const RealBasis basis : allBases)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            std::array<int, 3> extents{30, 31, 36};
            extents[static_cast<std::size_t>(axis)] = 48;
            const Lines lines{.extents = extents, .axis = axis, .count = 48};
            const RealTransform transform(lines, basis);
            const auto values = noiseOf(static_cast<std::size_t>(extents[0] * extents[1] * extents[2]), 9);
            AlignedVector<double> modes = values;
            transform.forward(modes);
            transform.backward(modes);
            EXPECT_LT(largestDifference(modes, values, transform.factor()), 2e-15 * transform.factor());
        }
    }
}

TEST(RealTransforms, refuseALineThatIsTooShort)
{
    EXPECT_THROW(RealTransform({.extents = {4, 1, 1}, .axis = 1, .count = 1}, RealBasis::cosine1), Error);
    EXPECT_THROW(RealTransform({.extents = {4, 1, 1}, .axis = 1, .count = 0}, RealBasis::sine1), Error);
}

} // namespace isph::test
