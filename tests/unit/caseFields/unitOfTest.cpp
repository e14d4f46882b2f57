#include "caseFields/unitOf.hpp"

#include <gtest/gtest.h>

namespace isph
{
namespace
{

TEST(UnitOf, WritesWhatPeopleWrite)
{
    EXPECT_EQ(unitOf({0, 1, -1, 0, 0, 0, 0}), "m/s");
    EXPECT_EQ(unitOf({0, 2, -2, 0, 0, 0, 0}), "m2/s2");
    EXPECT_EQ(unitOf({1, -1, -2, 0, 0, 0, 0}), "Pa");
    EXPECT_EQ(unitOf({1, -3, 0, 0, 0, 0, 0}), "kg/m3");
    EXPECT_EQ(unitOf({0, 0, -1, 0, 0, 0, 0}), "1/s");
    EXPECT_EQ(unitOf({1, 1, -2, 0, 0, 0, 0}), "kg m/s2");
    EXPECT_EQ(unitOf({1, 0, -3, -1, 0, 0, 0}), "kg/s3/K");
    EXPECT_EQ(unitOf({0, 0, 0, 0, 0, 0, 0}), "1");
}

} // namespace
} // namespace isph
