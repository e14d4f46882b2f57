#include "neighbours/LatticeStencil.hpp"

#include "support/messageOf.hpp"
#include "support/periodicBox.hpp"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <set>

namespace isph
{
namespace
{

using test::periodicBox;
using test::unitCube;
using test::unitSquare;

std::size_t neighbours(const Lattice& lattice, double smoothingLength, double supportRadius)
{
    return latticeStencil(lattice, smoothingLength, supportRadius).size();
}

TEST(LatticeStencil, CountsThoseOfThePapersSupports)
{
    // docs/theory/periodic.md: the closed disc, self included. Fourtakas et al. 2021 print 98 and 161.
    const Lattice square = unitSquare(32);
    EXPECT_EQ(neighbours(square, 2, 3), 113U) << "quintic spline, h/dx = 2";
    EXPECT_EQ(neighbours(square, 2, 4), 197U) << "G4 4h, h/dx = 2";
    EXPECT_EQ(neighbours(square, 2, 3 * (1 - 1e-9)), 109U) << "the open disc";
    EXPECT_EQ(neighbours(square, 2, 4 * (1 - 1e-9)), 193U);
    EXPECT_EQ(neighbours(square, 1.8, 3), 97U) << "the printed counts are those of 1.8, but for the symmetry of 98";
    EXPECT_EQ(neighbours(square, 1.8, 4), 161U);

    const Lattice cube = unitCube(32);
    EXPECT_EQ(neighbours(cube, 2, 3), 925U);
    EXPECT_EQ(neighbours(cube, 2, 4), 2109U);
    EXPECT_EQ(neighbours(cube, 2, 3 * (1 - 1e-9)), 895U);
    EXPECT_EQ(neighbours(cube, 2, 4 * (1 - 1e-9)), 2103U);
}

TEST(LatticeStencil, IsAllThatBruteForceFinds)
{
    for (const double smoothingLength : {0.4, 1.0, 1.3, 1.8, 2.0, 2.6})
    {
        for (const double radius : {1.0, 2.5, 3.0, 4.0, 5.0})
        {
            // In exact arithmetic, for hundredths: (100 offsets)^2 <= (100 h/dx radius)^2.
            const long limit = std::lround(100 * smoothingLength * radius);
            const int reach = static_cast<int>(limit / 100) + 2;
            std::set<std::array<int, 3>> plane;
            std::set<std::array<int, 3>> space;
            for (int i = -reach; i <= reach; ++i)
            {
                for (int j = -reach; j <= reach; ++j)
                {
                    for (int k = -reach; k <= reach; ++k)
                    {
                        const long distance2 = 10000L * (i * i + j * j + k * k);
                        if (distance2 > limit * limit) { continue; }
                        space.insert({i, j, k});
                        if (k == 0) { plane.insert({i, j, 0}); }
                    }
                }
            }
            const auto found2 = latticeStencil(unitSquare(8), smoothingLength, radius);
            const auto found3 = latticeStencil(unitCube(8), smoothingLength, radius);
            EXPECT_EQ(std::set(found2.begin(), found2.end()), plane) << smoothingLength << ' ' << radius;
            EXPECT_EQ(std::set(found3.begin(), found3.end()), space) << smoothingLength << ' ' << radius;
            EXPECT_EQ(found2.size(), plane.size()) << "none twice";
            EXPECT_EQ(found3.size(), space.size()) << "none twice";
        }
    }
}

TEST(LatticeStencil, IsSymmetricAndHoldsThePointItself)
{
    const auto offsets = latticeStencil(unitCube(6), 1.3, 3);
    const std::set all(offsets.begin(), offsets.end());
    EXPECT_TRUE(all.contains({0, 0, 0}));
    for (const auto& [i, j, k] : offsets)
    {
        EXPECT_TRUE(all.contains({-i, -j, -k}));
        EXPECT_TRUE(all.contains({j, k, i}));
        EXPECT_TRUE(all.contains({-i, j, k}));
    }
}

TEST(LatticeStencil, DependsOnNeitherSpacingNorBox)
{
    // Distances count in smoothing lengths, and each axis has its own.
    const auto square = latticeStencil(unitSquare(64), 1.5, 4);
    EXPECT_EQ(latticeStencil(periodicBox({64, 16, 1}, {1, 1000, 0}), 1.5, 4), square);
    EXPECT_EQ(latticeStencil(periodicBox({1, 5, 3}, {0, 1, 1}), 1.5, 4), square) << "reaches images of a small box";
    EXPECT_EQ(latticeStencil(periodicBox({1, 2, 1}, {1, 1, 0}), 1.5, 4), square);
}

TEST(LatticeStencil, OfAPointAlone)
{
    EXPECT_EQ(neighbours(unitSquare(8), 0.3, 3), 1U);
    EXPECT_EQ(neighbours(unitSquare(8), 0.5, 2), 5U) << "the rim belongs to it";
}

TEST(LatticeStencil, RefusesWhatMemoryCouldNotHold)
{
    EXPECT_THAT(messageOf([] { latticeStencil(unitCube(8), 50, 7); }),
                AllOf(testing::HasSubstr("20 million neighbours"), testing::HasSubstr("supportRadius")));
    EXPECT_THAT(messageOf([] { latticeStencil(unitSquare(8), 100, 100); }), testing::HasSubstr("20 million"));
    EXPECT_THAT(messageOf([] { latticeStencil(unitSquare(8), 1e200, 1e200); }), testing::HasSubstr("20 million"));
}

} // namespace
} // namespace isph
