#include "fields/reductions.hpp"

#include "fields/threads.hpp"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>
#include <omp.h>
#include <random>
#include <vector>

namespace isph
{
namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<double> noise(std::size_t size)
{
    std::mt19937_64 engine(1);
    std::normal_distribution<double> normal;
    std::vector<double> values(size);
    for (double& value : values) { value = normal(engine); }
    return values;
}

TEST(Reductions, OfNothingAreZero)
{
    EXPECT_EQ(sum({}), 0);
    EXPECT_EQ(sumOfSquares({}), 0);
    EXPECT_EQ(sumOfProducts({}, {}), 0);
    EXPECT_EQ(largestMagnitude({}), 0);
    EXPECT_TRUE(allFinite({}));
}

TEST(Reductions, AreExactWhereNothingIsRounded)
{
    std::vector<double> values;
    for (int i = 1; i <= 1000; ++i) { values.push_back(i); }
    EXPECT_EQ(sum(values), 500500);
    EXPECT_EQ(sumOfSquares(values), 333833500);
    EXPECT_EQ(sumOfProducts(values, std::vector<double>(1000, 2)), 1001000);
    values[3] = -1e6;
    EXPECT_EQ(largestMagnitude(values), 1e6);
}

TEST(Reductions, StayAccurateForManyValues)
{
    const auto values = noise(1'000'003);
    long double exact = 0;
    long double squares = 0;
    for (const double value : values)
    {
        exact += value;
        squares += static_cast<long double>(value) * value;
    }
    // Blocks of 256 are summed plainly: 256 half units at worst, of partial sums near 16; the blocks' sum is
    // compensated.
    EXPECT_NEAR(sum(values), static_cast<double>(exact), 1e-16 * 16 * std::sqrt(1e6));
    EXPECT_NEAR(sumOfSquares(values) / static_cast<double>(squares), 1, 1e-16 * 16);

    // What a plain sum loses: many small values beside two large ones that cancel.
    std::vector<double> cancelling(100'000, 1e-3);
    cancelling.insert(cancelling.begin(), 1e16);
    cancelling.push_back(-1e16);
    // Only the values that share a block with a large one, 255 at most on either side, drown in it.
    EXPECT_NEAR(sum(cancelling), 100, 2 * 255e-3 + 2 * 2);
}

TEST(Reductions, HaveTheSameBitsForAnyNumberOfThreads)
{
    const auto values = noise(100'000);
    const double expected = sum(values);
    const double expectedSquares = sumOfSquares(values);
    const int before = omp_get_max_threads();
    for (const int threads : {1, 2, 3, 7})
    {
        omp_set_num_threads(threads);
        EXPECT_EQ(sum(values), expected);
        EXPECT_EQ(sumOfSquares(values), expectedSquares);
    }
    omp_set_num_threads(before);
}

TEST(Reductions, PassOnWhatIsNoNumber)
{
    for (const std::size_t place : {0U, 255U, 256U, 999U})
    {
        std::vector<double> values(1000, 1);
        values[place] = nan;
        EXPECT_TRUE(std::isnan(sum(values)));
        EXPECT_TRUE(std::isnan(sumOfSquares(values)));
        EXPECT_TRUE(std::isnan(largestMagnitude(values)));
        EXPECT_FALSE(allFinite(values));
        for (const double infinite : {infinity, -infinity})
        {
            values[place] = infinite;
            EXPECT_EQ(sum(values), infinite);
            EXPECT_EQ(sumOfSquares(values), infinity);
            EXPECT_EQ(largestMagnitude(values), infinity);
            EXPECT_FALSE(allFinite(values));
        }
        values[place] = std::numeric_limits<double>::max();
        EXPECT_TRUE(allFinite(values)) << "large, but a number";
    }
    // A NaN after an infinity, and before.
    EXPECT_TRUE(std::isnan(largestMagnitude(std::vector<double>{infinity, nan, 1})));
    EXPECT_TRUE(std::isnan(largestMagnitude(std::vector<double>{nan, infinity})));
    EXPECT_TRUE(std::isnan(sum(std::vector<double>{infinity, -infinity})));
}

TEST(Reductions, OverflowToInfinityAndNotToNan)
{
    EXPECT_EQ(sumOfSquares(std::vector<double>(1000, 1e200)), infinity);
    EXPECT_EQ(sum(std::vector<double>(1000, 1e308)), infinity);
    EXPECT_EQ(sum(std::vector<double>(1000, -1e308)), -infinity);
    EXPECT_EQ(largestMagnitude(std::vector<double>{-1e308}), 1e308);
}

TEST(Reductions, OfTinyValuesDoNotVanish)
{
    EXPECT_NEAR(sumOfSquares(std::vector<double>(1000, 1e-150)) / 1e-297, 1, 256 * 1e-16); // a block's additions
    EXPECT_EQ(largestMagnitude(std::vector<double>{1e-320}), 1e-320);
}

TEST(Threads, AreThoseAskedForAndElseOne)
{
    const char* set = std::getenv("OMP_NUM_THREADS");
    const std::string before = set == nullptr ? "" : set;
    const int threads = omp_get_max_threads();
    ::unsetenv("OMP_NUM_THREADS");
    EXPECT_EQ(useRequestedThreads(), 1);
    EXPECT_EQ(omp_get_max_threads(), 1);
    omp_set_num_threads(3); // as the runtime does by itself for OMP_NUM_THREADS=3
    ::setenv("OMP_NUM_THREADS", "3", 1);
    EXPECT_EQ(useRequestedThreads(), 3);
    ::setenv("OMP_NUM_THREADS", "", 1);
    EXPECT_EQ(useRequestedThreads(), 1) << "set to nothing says nothing";
    set == nullptr ? ::unsetenv("OMP_NUM_THREADS") : ::setenv("OMP_NUM_THREADS", before.c_str(), 1);
    omp_set_num_threads(threads);
}

} // namespace
} // namespace isph
