#include "boundary/readBoundary.hpp"
#include "countedAllocations.hpp"

#include <gtest/gtest.h>

using namespace isph;
using namespace isph::test;

namespace
{

TEST(Allocations, noneWhereBoundaryDataChange)
{
    Axis x{.name = 'x', .origin = 0, .extent = 1, .count = 9, .ends = Axis::Ends::bounded};
    Axis y = x;
    Axis z{.name = 'z', .origin = 0, .extent = 0, .count = 1};
    y.name = 'y';
    const Lattice lattice({x, y, z}, {{"lid", Patch::Type::wall, {"yMax"}},
                                      {"walls", Patch::Type::wall, {"xMin", "xMax"}},
                                      {"floor", Patch::Type::wall, {"yMin"}}});
    const Dictionary U = Dictionary::parse("boundaryField { lid { type fixedValue; value expression (\"cos(t)\" \"0\" "
                                           "\"0\"); } walls { type noSlip; } floor { type slip; } }",
                                           "U");
    const Dictionary p =
        Dictionary::parse("boundaryField { lid { type fixedGradient; gradient expression \"x*sin(t)\"; } "
                          "\"walls|floor\" { type zeroGradient; } }",
                          "p");
    FlowBoundary boundary = readBoundary(U, p, lattice, {});
    RealField velocity(2, lattice.points());

    const CountedAllocations counted;
    for (const double t : {0.1, 0.2, 0.3})
    {
        boundary.update(t);
        boundary.impose(velocity);
        EXPECT_EQ(boundary.velocity(0, Side::low, 0).size(), 9);
        EXPECT_EQ(boundary.flux().in, 0);
    }
    EXPECT_EQ(counted.count(), 0);
}

} // namespace
