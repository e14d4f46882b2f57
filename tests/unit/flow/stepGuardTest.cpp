#include "flow/StepGuard.hpp"

#include "support/flows.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

using namespace isph;
using namespace isph::test;

namespace
{

StepRates ratesOf(double convective, double viscous = 0)
{
    StepRates rates;
    rates.convective = rates.courant = convective;
    rates.viscous = viscous;
    return rates;
}

} // namespace

TEST(StepGuard, EndsARunWhoseStepsShrinkForEver)
{
    Log log(Log::Report::none);
    StepGuard guard(log, *scheme("RK3"), 100);
    TimeSettings settings;
    settings.endTime = 1000;
    const TimeControl control(settings, TimeState{});

    guard.judge(ratesOf(10), 0.1);
    EXPECT_FALSE(guard.divergence(ratesOf(10), 0.1, control));
    // A thousand times faster: a flow that has got going.
    EXPECT_FALSE(guard.divergence(ratesOf(1e4), 1e-4, control));
    // A step that is short for the sake of output is no sign of anything.
    EXPECT_FALSE(guard.divergence(ratesOf(10), 1e-9, control));

    // Nor is a step far below a limit that has not moved so far.
    EXPECT_FALSE(guard.divergence(ratesOf(1e4), 5e-6, control));

    EXPECT_TRUE(guard.divergence(ratesOf(5e4), 5e-6, control)) << "steps kept to a seventh of the limit, by maxCo";
    const auto diverged = guard.divergence(ratesOf(2e5), 5e-6, control);
    ASSERT_TRUE(diverged);
    EXPECT_NE(std::string(diverged->what()).find("speeds have grown"), std::string::npos);

    settings.maxCo = 0.05; // a fortieth of the limit, which the steps above keep to
    EXPECT_TRUE(guard.divergence(ratesOf(1e4), 5e-6, TimeControl(settings, TimeState{})));
    EXPECT_FALSE(guard.divergence(ratesOf(10), 5e-6, TimeControl(settings, TimeState{})));
}

TEST(StepGuard, ShortensStepsThatFoundTheFlowTooSlow)
{
    Log log(Log::Report::none);
    const StepGuard guard(log, *scheme("RK3"), 100);
    TimeSettings settings;
    settings.endTime = 10;
    const auto shorter = [&](double after, double dt)
    { return guard.shorter(ratesOf(after), dt, TimeControl(settings, TimeState{})); };
    const double borne = largestStableStep(*scheme("RK3"), ratesOf(1)); // [s], and [1/s] for a step of 1 s

    EXPECT_FALSE(shorter(0, 1));
    EXPECT_FALSE(shorter(1.99 * borne, 1));
    EXPECT_NEAR(shorter(2.01 * borne, 1).value(), 0.5, 1e-12) << "at most half";
    EXPECT_NEAR(shorter(16 * borne, 1).value(), std::sqrt(0.8 / 16), 1e-12) << "as a force needs it";
    EXPECT_NEAR(shorter(1e9 * borne, 1).value(), 0.1, 1e-12) << "not by more than ten at once";
    EXPECT_NEAR(shorter(std::numeric_limits<double>::infinity(), 1).value(), 0.1, 1e-12);
    EXPECT_NEAR(shorter(std::numeric_limits<double>::quiet_NaN(), 1).value(), 0.1, 1e-12);
    EXPECT_FALSE(shorter(1e20, 1e-10)) << "no end of it";

    settings.maxCo = 0.1;
    EXPECT_FALSE(shorter(0.19, 1));
    EXPECT_NEAR(shorter(0.8, 1).value(), std::sqrt(0.8 / 8), 1e-12);
    settings.deltaT = 1;
    EXPECT_FALSE(shorter(1e3 * borne, 1)) << "a step that was asked for is taken";
}

TEST(StepGuard, DoesNotMindStepsThatFrictionRuled)
{
    Log log(Log::Report::none);
    StepGuard guard(log, *scheme("RK3"), 100);
    TimeSettings settings;
    settings.endTime = 1000;
    const TimeControl control(settings, TimeState{});
    guard.judge(ratesOf(1e-9, 10), 0.2);
    guard.judge(ratesOf(2e4, 10), 5e-5);
    EXPECT_FALSE(guard.divergence(ratesOf(2e5, 10), 5e-6, control));
}

TEST(StepGuard, EndsAFlowWithoutConvectionThatGrowsInStepsAboveTheLimit)
{
    Log log(Log::Report::none);
    TimeSettings settings;
    settings.endTime = 1000;
    const TimeControl control(settings, TimeState{});
    for (const auto& [dt, member] : {std::pair{0.2, &StepRates::courant},
                                     {0.3, &StepRates::courant},
                                     {0.2, &StepRates::magnitude},
                                     {0.3, &StepRates::magnitude}})
    {
        const auto rates = [member](double size)
        {
            StepRates result = ratesOf(0, 10);
            result.*member = size;
            return result;
        };
        StepGuard guard(log, *scheme("RK3"), 100);
        guard.judge(rates(0), dt); // at rest
        guard.judge(rates(1e-6), dt);
        guard.judge(rates(1e2), dt);
        EXPECT_FALSE(guard.divergence(rates(1e2), dt, control)) << dt;
        EXPECT_EQ(guard.divergence(rates(1e4), dt, control).has_value(), dt > 0.25) << dt;
    }
}

TEST(StepGuard, DoesNotWarnOfATermThatYields)
{
    Log log(Log::Report::none);
    StepGuard guard(log, *scheme("RK3"), 100);
    StepRates rates = ratesOf(1, 1000);
    rates.viscousYields = true;
    testing::internal::CaptureStderr();
    const StabilityMargin margin = guard.judge(rates, 1);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(margin.viscous, 0);
}
