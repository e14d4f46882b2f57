#include "core/FlushDenormals.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <thread>

namespace isph
{
namespace
{

/// A product that the compiler cannot know.
double product(double a, double b)
{
    volatile double x = a;
    volatile double y = b;
    return x * y;
}

constexpr double least = std::numeric_limits<double>::min();

TEST(FlushDenormals, TakesNumbersBelowTheLeastNormalOneForZeroWhileItLives)
{
    EXPECT_GT(product(least, 0.5), 0);
    {
        const FlushDenormals flush;
        EXPECT_EQ(product(least, 0.5), 0);
        EXPECT_EQ(product(least, 1), least);
        EXPECT_EQ(product(std::numeric_limits<double>::denorm_min(), 1e300), 0) << "as an operand too";
    }
    EXPECT_GT(product(least, 0.5), 0);
}

TEST(FlushDenormals, HoldsInThreadsStartedMeanwhile)
{
    const FlushDenormals flush;
    double found = 1;
    std::thread([&found] { found = product(least, 0.5); }).join();
    EXPECT_EQ(found, 0);
}

} // namespace
} // namespace isph
