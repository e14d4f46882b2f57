#include "flow/stableNumbers.hpp"

#include <gtest/gtest.h>

namespace isph
{
namespace
{

const TimeScheme& rk3() { return *timeSchemes()[Word{"RK3", {}}]; }

/// A flow that an explicit viscous term allows steps of 1 ms, and convection alone of that many ms.
StepRates rates(double convectiveStep)
{
    StepRates rates;
    rates.viscous = rk3().realLimit / 1e-3;
    rates.convective = convectiveStep > 0 ? rk3().imaginaryLimit / (1e-3 * convectiveStep) : 0;
    return rates;
}

TEST(CrankNicolsonPays, WhereItAllowsFourTimesTheStep)
{
    EXPECT_FALSE(crankNicolsonPays(rk3(), rates(1)));
    EXPECT_FALSE(crankNicolsonPays(rk3(), rates(3.5)));
    EXPECT_TRUE(crankNicolsonPays(rk3(), rates(4.5)));
    EXPECT_TRUE(crankNicolsonPays(rk3(), rates(1000)));
}

TEST(CrankNicolsonPays, WhereTheExplicitTermDoesNotBearTheStepAskedFor)
{
    EXPECT_FALSE(crankNicolsonPays(rk3(), rates(1000), 0.99e-3));
    EXPECT_TRUE(crankNicolsonPays(rk3(), rates(1000), 1.01e-3));
    EXPECT_TRUE(crankNicolsonPays(rk3(), rates(0), 1));
}

TEST(CrankNicolsonPays, NotForAFlowAtRestThatAsksForNoStep) { EXPECT_FALSE(crankNicolsonPays(rk3(), rates(0))); }

} // namespace
} // namespace isph
