#include "lattice/Lattice.hpp"
#include "core/Error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

using testing::ElementsAre;

TEST(Axis, PeriodicLeavesOutItsEndPoint)
{
    const Axis axis{'x', -1, 2, 8, Axis::Ends::periodic, false};
    EXPECT_EQ(axis.spacing(), 0.25);
    EXPECT_EQ(axis.coordinate(0), -1);
    EXPECT_EQ(axis.coordinate(7), 0.75);
}

TEST(Axis, CollocatedHasPointsOnBothEnds)
{
    const Axis axis{'y', 1, 2, 9, Axis::Ends::bounded, false};
    EXPECT_EQ(axis.spacing(), 0.25);
    EXPECT_EQ(axis.coordinate(0), 1);
    EXPECT_EQ(axis.coordinate(8), 3);
}

TEST(Axis, StaggeredIsHalfASpacingInside)
{
    const Axis axis{'y', 0, 2, 8, Axis::Ends::bounded, true};
    EXPECT_EQ(axis.spacing(), 0.25);
    EXPECT_EQ(axis.coordinate(0), 0.125);
    EXPECT_EQ(axis.coordinate(7), 1.875);
}

TEST(Lattice, LeavesOutAnAxisWithoutExtent)
{
    const Lattice lattice({Axis{'x', 0, 1, 4}, Axis{'y'}, Axis{'z', 0, 3, 6}}, {});
    EXPECT_EQ(lattice.dimensions(), 2);
    EXPECT_EQ(lattice.direction(0), 0);
    EXPECT_EQ(lattice.direction(1), 2);
    EXPECT_EQ(lattice.points(), 24U);
    EXPECT_EQ(lattice.pointVolume(), 0.125);
    EXPECT_TRUE(lattice.periodic());
}

TEST(Lattice, IsNotPeriodicWithABoundedAxis)
{
    const Lattice lattice({Axis{'x', 0, 1, 4}, Axis{'y', 0, 1, 5, Axis::Ends::bounded}, Axis{'z'}}, {});
    EXPECT_FALSE(lattice.periodic());
}

TEST(Lattice, RunsAlongXFastest)
{
    const auto [x, y, z] = Lattice({Axis{'x', 0, 2, 2}, Axis{'y', 5, 3, 3}, Axis{'z', 7}}, {}).coordinates();
    EXPECT_THAT(x, ElementsAre(0, 1, 0, 1, 0, 1));
    EXPECT_THAT(y, ElementsAre(5, 5, 6, 6, 7, 7));
    EXPECT_THAT(z, ElementsAre(7, 7, 7, 7, 7, 7));
}

TEST(Lattice, NeedsTwoAxes) { EXPECT_THROW(Lattice({Axis{'x', 0, 1, 4}, Axis{'y'}, Axis{'z'}}, {}), Error); }

} // namespace
} // namespace isph
