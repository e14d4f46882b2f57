#include "lattice/fastCounts.hpp"

#include <gtest/gtest.h>

namespace isph
{
namespace
{

TEST(FastCounts, AreProductsOfSmallPrimes)
{
    for (const long n : {1, 2, 3, 5, 7, 11, 13, 160, 243, 625, 1000, 1024, 11 * 64, 13 * 49})
    {
        EXPECT_TRUE(isFastCount(n)) << n;
    }
    for (const long n : {0, -4, 17, 19, 121, 143, 169, 161, 1021}) { EXPECT_FALSE(isFastCount(n)) << n; }
}

TEST(FastCounts, NearestOnesFrameTheCount)
{
    EXPECT_EQ(fastCountBelow(161), 160);
    EXPECT_EQ(fastCountAbove(161), 162);
    EXPECT_EQ(fastCountBelow(160), 160);
    EXPECT_EQ(fastCountAbove(160), 160);
    EXPECT_EQ(fastCountAbove(1021), 1024);
    EXPECT_EQ(fastCountBelow(17), 16);
}

} // namespace
} // namespace isph
