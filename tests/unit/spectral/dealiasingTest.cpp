#include "spectral/dealiasing.hpp"
#include "spectral/SpectralFilter.hpp"
#include "support/periodicBox.hpp"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

TEST(RetainedModes, TwoThirdsKeepsExactlyTheModesBelowAThird)
{
    for (int n = 1; n <= 40; ++n)
    {
        const RetainedModes modes(test::periodicBox({n, n, n}, {1, 1, 1}), Dealiasing::twoThirds);
        std::size_t kept = 0;
        for (int m = 0; m <= n / 2; ++m) { kept += 3 * m < n ? 1U : 0U; }
        EXPECT_EQ(modes.length(), kept) << "count " << n;
        for (int d = 1; d <= 2; ++d)
        {
            for (int i = 0; i < n; ++i)
            {
                const int m = std::min(i, n - i);
                EXPECT_EQ(modes.index(d, static_cast<std::size_t>(i)), 3 * m < n) << "count " << n << ", index " << i;
            }
        }
    }
}

TEST(RetainedModes, ProductsOfTwoAliasOntoNoneOfThem)
{
    for (int n = 1; n <= 40; ++n)
    {
        const RetainedModes modes(test::unitSquare(n), Dealiasing::twoThirds);
        const int largest = static_cast<int>(modes.length()) - 1;
        const int alias = 2 * largest - n; // of the product's largest mode, if that is not on the lattice
        if (2 * largest > n / 2) { EXPECT_LT(alias, -largest) << "count " << n; }
    }
}

TEST(RetainedModes, NoneKeepsThemAll)
{
    for (int n = 1; n <= 9; ++n)
    {
        const RetainedModes modes(test::periodicBox({n, n + 1, 1}, {1, 1, 0}), Dealiasing::none);
        EXPECT_EQ(modes.length(), static_cast<std::size_t>(n / 2 + 1));
        for (std::size_t i = 0; i <= static_cast<std::size_t>(n); ++i) { EXPECT_TRUE(modes.index(1, i)); }
        EXPECT_TRUE(modes.index(2, 0)) << "an axis that is not there drops nothing";
    }
}

TEST(FilterFactors, ExponentialIsOneAtRestAndRoundOffAtNyquist)
{
    const FilterSettings settings{.type = FilterSettings::Type::exponential};
    const auto factors = filterFactors(test::periodicBox({16, 12, 1}, {1, 1, 0}), settings);
    ASSERT_EQ(factors[0].size(), 9U);
    ASSERT_EQ(factors[1].size(), 12U);
    EXPECT_TRUE(factors[2].empty());
    EXPECT_EQ(factors[0][0], 1);
    EXPECT_DOUBLE_EQ(factors[0][4], std::exp(-36 * std::pow(0.5, 16)));
    EXPECT_DOUBLE_EQ(factors[0][8], std::exp(-36));
    EXPECT_DOUBLE_EQ(factors[1][6], std::exp(-36));
    EXPECT_EQ(factors[1][2], factors[1][10]) << "the same for a wavenumber and its negative";
    EXPECT_TRUE(std::ranges::is_sorted(factors[0], std::greater<>()));
}

TEST(FilterFactors, OddCountsReachAlmostToNyquist)
{
    const auto factors =
        filterFactors(test::unitSquare(5), {.type = FilterSettings::Type::exponential, .strength = 2, .order = 4});
    EXPECT_DOUBLE_EQ(factors[0][2], std::exp(-2 * std::pow(0.8, 4)));
    EXPECT_DOUBLE_EQ(factors[1][3], std::exp(-2 * std::pow(0.8, 4)));
}

TEST(FilterFactors, CutoffDropsWhatIsAboveItsFraction)
{
    const auto factors = filterFactors(test::unitSquare(12), {.type = FilterSettings::Type::cutoff, .fraction = 0.5});
    EXPECT_THAT(factors[0], testing::ElementsAre(1, 1, 1, 1, 0, 0, 0)) << "the fraction itself stays";
    EXPECT_THAT(factors[1], testing::ElementsAre(1, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1));
}

TEST(FilterFactors, NoneLeavesEverything)
{
    const auto factors = filterFactors(test::unitSquare(4), {});
    EXPECT_THAT(factors[1], testing::ElementsAre(1, 1, 1, 1));
}

} // namespace
} // namespace isph
