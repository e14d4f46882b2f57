#include "schemes/amplification.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace isph
{

namespace
{

const TimeScheme& rungeKutta() { return *timeSchemes()[Word{"RK3", {}}]; }
const TimeScheme& euler() { return *timeSchemes()[Word{"firstOrderProjection", {}}]; }

} // namespace

TEST(Amplification, IsThePolynomialOfTheScheme)
{
    for (const std::complex<double> z : {std::complex<double>(-0.7, 0.4), {0, 1.5}, {-2, 0}})
    {
        const auto cubic = 1.0 + z + z * z / 2.0 + z * z * z / 6.0;
        EXPECT_NEAR(std::abs(amplification(rungeKutta(), {.explicitRate = z / 0.2}, 0.2) - cubic), 0, 1e-14);
        EXPECT_NEAR(std::abs(amplification(euler(), {.explicitRate = z / 0.2}, 0.2) - (1.0 + z)), 0, 1e-14);
    }
}

TEST(Amplification, AnIntegratingFactorIsExact)
{
    EXPECT_NEAR(std::abs(amplification(rungeKutta(), {.integratedRate = 3}, 0.5)), std::exp(-1.5), 1e-14);
    // A filter comes at the end of the step.
    EXPECT_NEAR(std::abs(amplification(rungeKutta(), {.integratedRate = 3, .filter = 0.5}, 0.5)), 0.5 * std::exp(-1.5),
                1e-14);
}

TEST(Amplification, LimitsAreThoseOfTheTable)
{
    const std::vector<ModeRate> carried{{.explicitRate = {0, 2}}, {.explicitRate = {0, -2}}};
    EXPECT_NEAR(largestStableStep(rungeKutta(), carried), rungeKutta().imaginaryLimit / 2, 1e-9);
    EXPECT_EQ(largestStableStep(euler(), carried), 0);
    const std::vector<ModeRate> damped{{.explicitRate = -5}, {.explicitRate = 0}};
    EXPECT_NEAR(largestStableStep(rungeKutta(), damped), rungeKutta().realLimit / 5, 1e-9);
    EXPECT_NEAR(largestStableStep(euler(), damped), euler().realLimit / 5, 1e-9);
    EXPECT_TRUE(std::isinf(largestStableStep(euler(), std::vector<ModeRate>{{.integratedRate = 7}})));
}

TEST(Amplification, EulerBearsConvectionWithViscosity)
{
    // |1 - nu L dt + i u k dt| = 1 at dt = 2 nu L/((nu L)^2 + (u k)^2)
    const std::vector<ModeRate> modes{{.explicitRate = {-0.3, 2}}};
    EXPECT_NEAR(largestStableStep(euler(), modes), 2 * 0.3 / (0.09 + 4), 1e-9);
}

TEST(Amplification, GrowthInExactTimeIsNotTheStepsFault)
{
    const std::vector<ModeRate> modes{{.explicitRate = {0.1, 0.5}}, {.explicitRate = {0, 2}}};
    EXPECT_NEAR(exactGrowth(modes), 0.1, 1e-15);
    EXPECT_NEAR(largestStableStep(rungeKutta(), modes), rungeKutta().imaginaryLimit / 2, 1e-6);
    EXPECT_NEAR(largestGrowth(rungeKutta(), modes, 0.1), 0.01, 1e-5);
}

} // namespace isph
