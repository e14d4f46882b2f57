#include "stability/schemeTable.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <string>

namespace isph
{

namespace
{

const PeriodicLimits& rowOf(const std::vector<PeriodicLimits>& table, const std::string& kernel, double h)
{
    const auto row =
        std::ranges::find_if(table, [&](const PeriodicLimits& limits)
                             { return limits.kernel == kernel && limits.smoothingLength.value_or(h) == h; });
    if (row == table.end()) { throw std::out_of_range(kernel); }
    return *row;
}

} // namespace

TEST(SchemeTable, GaussiansBearWhatTheirClosedFormsSay)
{
    // max |D| = c/h with c the largest 2 sqrt(s) Q(s), and max L = 4 n/h^2 for order 2 n, where both lie below the
    // lattice's own waves.
    const std::map<int, double> largest{{2, 0.8578}, {4, 1.4715}, {6, 1.9825}, {8, 2.4314}, {10, 2.8371}};
    const auto table = periodicLimits();
    for (const auto& [order, c] : largest)
    {
        for (const double h : {1.3, 1.5, 2.0})
        {
            const PeriodicLimits& row = rowOf(table, "gaussian " + std::to_string(order), h);
            EXPECT_NEAR(row.axis, std::sqrt(3.0) * h / c, 0.01 * row.axis) << row.kernel << ' ' << h;
            EXPECT_NEAR(row.diagonal, row.axis, 0.01 * row.axis);
            const double n = order / 2.0;
            const double cap = 0.23; // where the lattice ends before the symbol's maximum
            if (row.viscous < cap) { continue; }
            EXPECT_NEAR(row.viscous, 2.5127 * h * h / (4 * n), 0.015 * row.viscous) << row.kernel << ' ' << h;
            EXPECT_NEAR(row.viscousFirstOrder, h * h / (2 * n), 0.015 * row.viscousFirstOrder);
        }
    }
}

TEST(SchemeTable, TheQuinticSplineAndTheExactDerivative)
{
    const auto table = periodicLimits();
    const PeriodicLimits& spline = rowOf(table, "quinticSpline", 1.5);
    EXPECT_NEAR(spline.axis, 3.0, 0.02);
    EXPECT_NEAR(spline.viscous, 1.46, 0.02);
    EXPECT_NEAR(spline.viscousFirstOrder, 1.16, 0.02);
    const PeriodicLimits& exact = rowOf(table, "exact", 1.5);
    EXPECT_FALSE(exact.smoothingLength);
    EXPECT_NEAR(exact.axis, std::sqrt(3.0) / (M_PI * 31 / 32), 1e-6);
    EXPECT_NEAR(exact.diagonal, exact.axis / std::sqrt(2.0), 1e-6);
}

TEST(SchemeTable, BetweenWallsTheDefaultGrowsInNothingButAnOpenFlow)
{
    const auto table = wallLimits();
    const auto row = [&](const std::string& kernel, double h, const std::string& continuation)
    {
        return *std::ranges::find_if(table,
                                     [&](const WallLimits& limits) {
                                         return limits.kernel == kernel && limits.smoothingLength.value_or(h) == h &&
                                                limits.continuation == continuation;
                                     });
    };
    const WallLimits standard = row("gaussian 20", 1.5, "smoothGram 4");
    EXPECT_LT(standard.viscousGrowth, 0);
    EXPECT_LT(standard.flowGrowth, 2e-3);
    EXPECT_LE(standard.atRest, 1.003);
    EXPECT_TRUE(standard.realModes);

    EXPECT_LT(row("gaussian 4", 1.3, "smoothGram 3").flowGrowth, 1e-4);
    EXPECT_NEAR(row("gaussian 4", 1.3, "smoothGram 4").flowGrowth, 1.0e-2, 2e-3);
    EXPECT_NEAR(row("exact", 1.5, "smoothGram 5").flowGrowth, 1.8e-2, 3e-3);
    EXPECT_NEAR(row("gaussian 4", 1.3, "smoothGram 5").flowGrowth, 8e-2, 1e-2);
    EXPECT_GT(row("gaussian 4", 2, "polynomial 5, 8 points").viscousGrowth, 1);
    EXPECT_LE(row("gaussian 4", 2, "mirror").atRest, 1.003);
}

} // namespace isph
