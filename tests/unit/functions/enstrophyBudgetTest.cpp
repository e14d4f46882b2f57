#include "functions/EnstrophyBudget.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

// E = exp(-2 t), so the budget is exp(-2 t)/nu.
double energy(double t) { return std::exp(-2 * t); }

/// Error of the row-th budget (from 0) of that energy, its enstrophy known exactly at the first row only.
double errorAtRow(int row, double distance)
{
    const double nu = 0.1;
    EnstrophyBudget budget(nu);
    double error = 0;
    for (int i = 0; i <= row; ++i)
    {
        const double t = i * distance;
        error = std::abs(budget.next(t, energy(t), 0, i == 0 ? energy(t) / nu : 1e9) - energy(t) / nu);
    }
    return error;
}

TEST(EnstrophyBudget, StartsFromTheEnstrophy)
{
    EnstrophyBudget budget(0.01);
    EXPECT_DOUBLE_EQ(budget.next(0.5, 1, 0.3, 17), 17);
}

TEST(EnstrophyBudget, ReachesFourthOrderWithItsRows)
{
    const auto order = [](int row) { return std::log2(errorAtRow(row, 0.02) / errorAtRow(row, 0.01)); };
    EXPECT_NEAR(order(1), 2, 0.1);
    EXPECT_NEAR(order(2), 3, 0.1);
    EXPECT_NEAR(order(3), 4, 0.1);
    EXPECT_NEAR(std::log2(errorAtRow(10, 0.02) / errorAtRow(20, 0.01)), 4, 0.1);
}

// A polynomial of degree four is met exactly whatever the distances, and so is the power of forces.
TEST(EnstrophyBudget, TakesRowsOfAnyDistance)
{
    const double nu = 0.5;
    const auto quartic = [](double t) { return 5 - 3 * t + t * t - 0.5 * t * t * t + 0.1 * t * t * t * t; };
    const auto slope = [](double t) { return -3 + 2 * t - 1.5 * t * t + 0.4 * t * t * t; };
    const auto power = [](double t) { return 1 + t; };
    EnstrophyBudget budget(nu);
    int row = 0;
    for (const double t : {0.0, 0.1, 0.15, 0.4, 0.41, 0.8, 1.2})
    {
        const double expected = (power(t) - slope(t)) / (2 * nu);
        const double found = budget.next(t, quartic(t), power(t), expected);
        if (row++ > 2) { EXPECT_NEAR(found, expected, 1e-11) << "at " << t; }
    }
}

TEST(EnstrophyBudget, KeepsItsValueWhereNoTimeHasPassed)
{
    EnstrophyBudget budget(0.1);
    budget.next(0, 1, 0, 10);
    const double found = budget.next(0.1, energy(0.1), 0, 0);
    EXPECT_EQ(budget.next(0.1, energy(0.1), 0, 0), found);
}

} // namespace
} // namespace isph
