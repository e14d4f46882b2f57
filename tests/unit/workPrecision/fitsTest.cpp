#include "fits.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace isph
{

namespace
{

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Errors that fall by 10^-order while the cost rises tenfold.
CostCurve curve(const char* title, double firstError, double order)
{
    return {title, {1, 10, 100}, {firstError, firstError * std::pow(10, -order), firstError * std::pow(100, -order)}};
}

} // namespace

TEST(FitSlope, FindsThePowerThatMadeTheNumbers)
{
    const auto fit = fitSlope(
        {20, 40, 80, 160}, {3 * std::pow(20, -4), 3 * std::pow(40, -4), 3 * std::pow(80, -4), 3 * std::pow(160, -4)});
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->slope, -4, 1e-12);
    EXPECT_EQ(fit->points, 4U);
}

TEST(FitSlope, LeavesOutWhatHasNoLogarithm)
{
    const auto fit = fitSlope({10, 20, 40, 80, none}, {0.01, none, 0, 0.01 / 64, 5});
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->slope, -2, 1e-12);
    EXPECT_EQ(fit->points, 2U);
}

TEST(FitSlope, NeedsTwoDifferentPlaces)
{
    EXPECT_FALSE(fitSlope({10}, {1}));
    EXPECT_FALSE(fitSlope({}, {}));
    EXPECT_FALSE(fitSlope({10, 10}, {1, 2}));
    EXPECT_FALSE(fitSlope({10, 20}, {1, none}));
}

TEST(CostOf, LiesOnTheLineBetweenTwoRuns)
{
    const auto cost = costOf(curve("", 1e-2, 1), std::sqrt(1e-2 * 1e-3));
    ASSERT_TRUE(cost);
    EXPECT_NEAR(cost->cost, std::sqrt(10), 1e-12);
    EXPECT_FALSE(cost->atMost);
}

TEST(CostOf, IsABoundWhereTheCoarsestRunIsBetter)
{
    const auto cost = costOf(curve("", 1e-2, 1), 0.5);
    ASSERT_TRUE(cost);
    EXPECT_EQ(cost->cost, 1);
    EXPECT_TRUE(cost->atMost);
}

TEST(CostOf, IsNothingWhereNoRunGets)
{
    EXPECT_FALSE(costOf(curve("", 1e-2, 1), 1e-5));
    EXPECT_FALSE(costOf({"", {1, 2}, {none, none}}, 1));
}

TEST(CostOf, CountsARunWithoutAnyError)
{
    const CostCurve curve{"", {1, 10, 5}, {1e-1, 0, 1e-3}};
    EXPECT_EQ(costOf(curve, 1e-2)->cost, 5); // there is no line to or from the run between the others
    EXPECT_EQ(costOf(curve, 1e-6)->cost, 10);
    EXPECT_FALSE(costOf(curve, 1e-6)->atMost);
}

TEST(CostOf, TakesTheFirstCrossingOfACurveThatRises)
{
    const auto cost = costOf({"", {1, 10, 100, 1000}, {1e-1, 1e-3, 1e-1, 1e-4}}, 1e-2);
    ASSERT_TRUE(cost);
    EXPECT_NEAR(cost->cost, std::sqrt(10), 1e-12);
}

TEST(CostOf, TakesCurvesFromEitherEnd)
{
    const CostCurve fineFirst{"", {100, 10, 1}, {1e-4, 1e-3, 1e-2}};
    for (const double error : {std::sqrt(1e-5), 2e-3})
    {
        const auto cost = costOf(fineFirst, error);
        ASSERT_TRUE(cost);
        EXPECT_NEAR(cost->cost, costOf(curve("", 1e-2, 1), error)->cost, 1e-12);
        EXPECT_FALSE(cost->atMost);
    }
    EXPECT_EQ(costOf(fineFirst, 0.5)->cost, 1);
    EXPECT_TRUE(costOf(fineFirst, 0.5)->atMost);
}

TEST(CheapestTable, ChangesHandsWhereTheCurvesCross)
{
    // Both cost 10 at an error of 1e-3: before, the low order is the cheaper one, behind, the high order.
    const std::vector<Cheapest> table = cheapest({curve("low", 1e-2, 1), curve("high", 1e-1, 2)});
    ASSERT_EQ(table.size(), 5U);
    EXPECT_DOUBLE_EQ(table[0].error, 1e-1);
    EXPECT_EQ(table[0].curve, 0U);
    EXPECT_TRUE(table[0].cost.atMost);
    EXPECT_DOUBLE_EQ(table[1].error, 1e-2);
    EXPECT_EQ(table[1].curve, 0U);
    EXPECT_EQ(table[1].second, 1U);
    EXPECT_NEAR(table[1].secondCost->cost, std::sqrt(10), 1e-12);
    EXPECT_DOUBLE_EQ(table[3].error, 1e-4);
    EXPECT_EQ(table[3].curve, 1U);
    EXPECT_NEAR(table[3].cost.cost, std::pow(10, 1.5), 1e-9);
    EXPECT_EQ(table[3].second, 0U);
    EXPECT_EQ(table[4].curve, 1U);
    EXPECT_FALSE(table[4].second);
}

TEST(CheapestTable, HasFinerStepsWhereThereAreNoTwoDecades)
{
    const std::vector<Cheapest> table = cheapest({{"", {1, 2}, {0.06, 0.015}}});
    ASSERT_EQ(table.size(), 2U);
    EXPECT_DOUBLE_EQ(table[0].error, 0.05);
    EXPECT_DOUBLE_EQ(table[1].error, 0.02);
}

TEST(CheapestTable, IsEmptyWithoutErrors)
{
    EXPECT_TRUE(cheapest({}).empty());
    EXPECT_TRUE(cheapest({{"", {1}, {none}}}).empty());
}

} // namespace isph
