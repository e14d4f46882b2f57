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

TEST(SmoothCounts, AreProductsOfTheFirstFourPrimes)
{
    for (const long n : {1, 2, 60, 63, 64, 100, 1050}) { EXPECT_TRUE(isSmoothCount(n)) << n; }
    for (const long n : {0, -2, 11, 13, 22, 61, 121}) { EXPECT_FALSE(isSmoothCount(n)) << n; }
    EXPECT_EQ(smoothCountBelow(61), 60);
    EXPECT_EQ(smoothCountAbove(61), 63);
    EXPECT_EQ(smoothCountAbove(22), 24);
    EXPECT_EQ(smoothCountBelow(22), 21);
}

TEST(ContinuedCounts, AreMultiplesOfFourAndLeaveRoom)
{
    for (const auto& [points, newPoints] :
         {std::pair{33L, 27L}, {49L, 31L}, {65L, 31L}, {97L, 31L}, {129L, 31L}, {201L, 39L}, {257L, 31L}, {601L, 39L}})
    {
        EXPECT_EQ(continuedCount(points), points + newPoints) << points;
    }
}

} // namespace
} // namespace isph
