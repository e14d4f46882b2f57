#include "march.hpp"

#include <gtest/gtest.h>
#include <utility>

using namespace isph;

/// A run restarted after any step goes on with the same times, steps and writes, bit for bit.
class Restart : public testing::TestWithParam<std::pair<const char*, TimeSettings>>
{
};

TEST_P(Restart, goesOnInTheSameBits)
{
    const TimeSettings& settings = GetParam().second;
    const TimeState start = from(0.2);
    const std::vector<Step> whole = march(settings, start, varying);
    ASSERT_GT(whole.size(), 30U);
    EXPECT_EQ(whole.back().time, settings.endTime);

    TimeControl control(settings, start);
    for (std::size_t taken = 1; taken < whole.size(); ++taken)
    {
        control.timeStep(varying(control.time()));
        control.advance();
        const std::vector<Step> rest = march(settings, control.state(), varying);
        ASSERT_EQ(rest, std::vector<Step>(whole.begin() + static_cast<long>(taken), whole.end())) << taken;
    }
}

TEST(TimeControl, anExtendedRunGoesOnInTheSameBits)
{
    for (const double dt : {0.001, 0.002, 0.0125, 1.0 / 128, 0.00625})
    {
        const std::vector<Step> whole = march(fixedSteps(dt, 2));
        for (const double stop : {0.25, 0.5, 0.75, 1.0, 1.5})
        {
            TimeControl first(fixedSteps(dt, stop), {});
            std::vector<Step> steps = march(first);
            EXPECT_EQ(steps.back().time, stop);
            const std::vector<Step> rest = march(fixedSteps(dt, 2), first.state());
            steps.insert(steps.end(), rest.begin(), rest.end());
            ASSERT_EQ(steps.size(), whole.size());
            for (std::size_t i = 0; i < steps.size(); ++i)
            {
                EXPECT_EQ(steps[i].dt, whole[i].dt);
                if (steps[i].time != stop) { EXPECT_EQ(steps[i].time, whole[i].time); }
            }
        }
    }
}

namespace
{

TimeSettings with(TimeSettings settings, WriteControl control, double interval)
{
    settings.writeControl = control;
    settings.writeInterval = interval;
    return settings;
}

TimeSettings adjusted()
{
    TimeSettings settings = fixedSteps(0.002, 1.7);
    settings.adjustTimeStep = true;
    settings.maxCo = 0.7;
    return settings;
}

} // namespace

INSTANTIATE_TEST_SUITE_P(
    TimeControl, Restart,
    testing::Values(std::pair{"fixed", with(fixedSteps(0.0071, 1.7), WriteControl::timeStep, 7)},
                    std::pair{"fixedRunTime", with(fixedSteps(0.01, 1.7), WriteControl::runTime, 0.123)},
                    std::pair{"fixedAdjustable", with(fixedSteps(0.01, 1.7), WriteControl::adjustableRunTime, 0.123)},
                    std::pair{"auto", with(automaticSteps(1.7), WriteControl::runTime, 0.1)},
                    std::pair{"autoAdjustable", with(automaticSteps(1.7), WriteControl::adjustableRunTime, 0.13)},
                    std::pair{"adjusted", with(adjusted(), WriteControl::timeStep, 3)},
                    std::pair{"adjustedAdjustable", with(adjusted(), WriteControl::adjustableRunTime, 0.17)}),
    [](const auto& test) { return test.param.first; });
