#include "lattice/memoryEstimate.hpp"
#include "core/Error.hpp"

#include <gtest/gtest.h>
#include <string>

namespace isph
{
namespace
{

Axis periodicAxis(char name, int count) { return {name, 0, 1, count, Axis::Ends::periodic, false}; }

TEST(MemoryEstimate, CountsEveryArray)
{
    // 10 points, 6 modes; 2-D: (5*2 + 2 + 3) complex and 6 real per mode, (2 + 2 + 7) real per point.
    EXPECT_EQ(solverMemory(10, 6, periodicSolverStorage(2)), programMemory + 8 * (6 * (2 * 15 + 6) + 10 * 11));
    // 3-D: (5*3 + 5 + 3) complex and 6 real per mode, (3 + 5 + 7) real per point.
    EXPECT_EQ(solverMemory(10, 6, periodicSolverStorage(3)), programMemory + 8 * (6 * (2 * 23 + 6) + 10 * 15));
}

TEST(MemoryEstimate, HalvesTheModesOfTheFirstActiveAxis)
{
    const Lattice lattice({periodicAxis('x', 16), periodicAxis('y', 10), Axis{'z'}}, {});
    EXPECT_EQ(solverMemory(lattice), solverMemory(160, 90, periodicSolverStorage(2)));
}

TEST(MemoryEstimate, DoesNotOverflow)
{
    const int many = 2147483646;
    const Lattice lattice({periodicAxis('x', many), periodicAxis('y', many), periodicAxis('z', many)}, {});
    EXPECT_GT(solverMemory(lattice), 1e30);
}

TEST(MemoryEstimate, IsReadable)
{
    EXPECT_EQ(memoryText(0), "0 bytes");
    EXPECT_EQ(memoryText(999), "999 bytes");
    EXPECT_EQ(memoryText(999.7), "1 kB");
    EXPECT_EQ(memoryText(1234567), "1.23 MB");
    EXPECT_EQ(memoryText(999.6e9), "1 TB");
    EXPECT_EQ(memoryText(3e21), "3e+03 EB");
}

TEST(MemoryEstimate, IsRefusedWithBothSizes)
{
    EXPECT_NO_THROW(requireMemory(8e9, 8e9, {}));
    try
    {
        requireMemory(231e9, 25.3e9, {"system/latticeDict", 0, ""});
        FAIL() << "accepted";
    }
    catch (const Error& error)
    {
        EXPECT_STREQ(error.what(), "system/latticeDict: memory refused before allocation: the solver needs 231 GB but "
                                   "this machine has 25.3 GB\n"
                                   "    take fewer points, or a machine with more memory");
    }
}

TEST(MemoryEstimate, KnowsTheMachine) { EXPECT_GT(machineMemory(), 1e8); }

} // namespace
} // namespace isph
