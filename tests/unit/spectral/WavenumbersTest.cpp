#include "spectral/Wavenumbers.hpp"

#include "spectral/ModeRows.hpp"
#include "support/periodicBox.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

namespace isph
{
namespace
{

using std::numbers::pi;
using test::periodicBox;

/// k extent/(2 pi) by mode.
std::vector<double> modeNumbers(const std::vector<double>& k, double extent)
{
    std::vector<double> modes;
    for (const double value : k) { modes.push_back(value * extent / (2 * pi)); }
    return modes;
}

using testing::ElementsAre;
using testing::Pointwise;

MATCHER(IsNear, "")
{
    return std::abs(std::get<0>(arg) - std::get<1>(arg)) <= 1e-14; // round-off of 2 pi/extent and back
}

TEST(Wavenumbers, OfEvenCountsEndAtNyquist)
{
    const Wavenumbers numbers(periodicBox({6, 4, 1}, {2, 5, 0}));
    EXPECT_THAT(modeNumbers(numbers.k[0], 2), Pointwise(IsNear(), std::vector<double>{0, 1, 2, 3}));
    EXPECT_THAT(modeNumbers(numbers.k[1], 5), Pointwise(IsNear(), std::vector<double>{0, 1, 2, -1}));
    EXPECT_THAT(modeNumbers(numbers.derivative[0], 2), Pointwise(IsNear(), std::vector<double>{0, 1, 2, 0}));
    EXPECT_THAT(modeNumbers(numbers.derivative[1], 5), Pointwise(IsNear(), std::vector<double>{0, 1, 0, -1}));
    EXPECT_EQ(numbers.derivative[0].back(), 0) << "exactly";
    EXPECT_EQ(numbers.derivative[1][2], 0) << "exactly";
    EXPECT_DOUBLE_EQ(numbers.k[0].back(), pi / (2.0 / 6)) << "pi/dx";
    EXPECT_TRUE(numbers.k[2].empty());
}

TEST(Wavenumbers, OfOddCountsHaveNoNyquist)
{
    const Wavenumbers numbers(periodicBox({5, 3, 7}, {1, 1, 1}));
    EXPECT_THAT(modeNumbers(numbers.k[0], 1), Pointwise(IsNear(), std::vector<double>{0, 1, 2}));
    EXPECT_THAT(modeNumbers(numbers.k[1], 1), Pointwise(IsNear(), std::vector<double>{0, 1, -1}));
    EXPECT_THAT(modeNumbers(numbers.k[2], 1), Pointwise(IsNear(), std::vector<double>{0, 1, 2, 3, -3, -2, -1}));
    for (std::size_t d = 0; d < 3; ++d) { EXPECT_EQ(numbers.k[d], numbers.derivative[d]); }
}

TEST(Wavenumbers, OfTheShortestAxes)
{
    const Wavenumbers one(periodicBox({1, 2, 1}, {1, 1, 0}));
    EXPECT_THAT(one.k[0], ElementsAre(0));
    EXPECT_THAT(one.k[1], ElementsAre(0, 2 * pi));
    EXPECT_THAT(one.derivative[1], ElementsAre(0, 0));
}

TEST(ModeRows, WalksTheModesInStorageOrder)
{
    const ModeRows rows(periodicBox({4, 3, 5}, {1, 2, 3}));
    EXPECT_EQ(rows.dimensions(), 3);
    EXPECT_EQ(rows.length(), 3U);
    EXPECT_EQ(rows.count(), 15U);
    EXPECT_EQ(rows.modes(), 45U);
    EXPECT_EQ(rows.offset(7), 21U);
    EXPECT_EQ(rows.index(7, 1), 1U);
    EXPECT_EQ(rows.index(7, 2), 2U);
    EXPECT_EQ(rows.k(7, 1), pi); // 2 pi 1/2
    EXPECT_DOUBLE_EQ(rows.k(7, 2), 2 * pi * 2 / 3);
    EXPECT_DOUBLE_EQ(rows.k(14, 2), -2 * pi / 3);
    EXPECT_DOUBLE_EQ(rows.k2OfRow(7), pi * pi * (1 + 16.0 / 9));
}

TEST(ModeRows, MultiplicitiesAddUpToThePoints)
{
    for (const int n : {1, 2, 3, 4, 5, 8, 9, 31})
    {
        const ModeRows rows(periodicBox({n, 3, 1}, {1, 1, 0}));
        double total = 0;
        for (std::size_t i = 0; i < rows.length(); ++i) { total += rows.multiplicity(i); }
        EXPECT_EQ(total, n);
    }
}

} // namespace
} // namespace isph
