#include "case/TimeControl.hpp"

#include "core/Error.hpp"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <vector>

using namespace isph;

namespace
{

/// A step that was taken.
struct Step
{
    double time;
    double dt;
    bool writes;

    bool operator==(const Step&) const = default;
};

using Limits = std::function<StepLimits(double time)>;

StepLimits none(double) { return {}; }

/// A flow whose limits go up and down: smooth, but never the same twice.
StepLimits varying(double time)
{
    StepLimits limits;
    limits.largestStable = 0.013 * (1.3 + std::sin(9 * time));
    limits.convectiveRate = 40 * (1.2 + std::cos(7 * time));
    return limits;
}

TimeState from(double time)
{
    TimeState state;
    state.time = state.origin = time;
    return state;
}

TimeSettings fixedSteps(double dt, double end)
{
    TimeSettings settings;
    settings.deltaT = dt;
    settings.endTime = end;
    return settings;
}

std::vector<Step> march(TimeControl& control, const Limits& limits = none)
{
    std::vector<Step> steps;
    while (control.running())
    {
        const double dt = control.timeStep(limits(control.time()));
        control.advance();
        steps.push_back({control.time(), dt, control.writesNow()});
    }
    return steps;
}

std::vector<Step> march(const TimeSettings& settings, const TimeState& start = {}, const Limits& limits = none)
{
    TimeControl control(settings, start);
    return march(control, limits);
}

std::vector<double> writeTimes(const std::vector<Step>& steps)
{
    std::vector<double> times;
    for (const Step& step : steps)
    {
        if (step.writes) { times.push_back(step.time); }
    }
    return times;
}

TimeSettings automaticSteps(double end)
{
    TimeSettings settings;
    settings.endTime = end;
    return settings;
}

} // namespace

TEST(TimeControl, fixedStepsEndExactly)
{
    for (const double dt : {0.1, 0.01, 0.001, 1.0 / 3, 1.0 / 7, 0.0125})
    {
        const std::vector<Step> steps = march(fixedSteps(dt, 1));
        EXPECT_EQ(steps.size(), static_cast<std::size_t>(std::lround(1 / dt))) << dt;
        EXPECT_EQ(steps.back().time, 1.0);
        for (const Step& step : steps) { EXPECT_EQ(step.dt, dt); }
    }
}

TEST(TimeControl, aMillionFixedStepsEndExactly)
{
    for (const double start : {0.0, 0.3, -2.0, 1000.0})
    {
        TimeControl control(fixedSteps(1e-6, start + 1), from(start));
        long count = 0;
        double worst = 0;
        while (control.running())
        {
            EXPECT_EQ(control.timeStep({}), 1e-6);
            control.advance();
            ++count;
            const long double exact = start + static_cast<long double>(count) * 1e-6;
            const double error = std::abs(static_cast<double>(control.time() - exact));
            worst = std::max(worst, error / std::max(std::abs(control.time()), 1e-6));
        }
        EXPECT_EQ(count, 1000000);
        EXPECT_EQ(control.time(), start + 1);
        EXPECT_LE(worst, 1.2e-16) << "each time is the nearest double";
    }
}

TEST(TimeControl, theLastStepIsCut)
{
    const std::vector<Step> steps = march(fixedSteps(0.3, 1));
    ASSERT_EQ(steps.size(), 4U);
    EXPECT_EQ(steps[2].dt, 0.3);
    EXPECT_NEAR(steps[3].dt, 0.1, 1e-15);
    EXPECT_EQ(steps[3].time, 1.0);
}

TEST(TimeControl, noSliverAtTheEnd)
{
    // 3 * 0.333333 leaves 1e-6: the third step is that much longer instead.
    const std::vector<Step> steps = march(fixedSteps(0.333333, 1));
    ASSERT_EQ(steps.size(), 3U);
    EXPECT_EQ(steps.back().time, 1.0);

    StepLimits limits;
    limits.largestStable = 0.333 / 0.8;
    const std::vector<Step> variable = march(automaticSteps(1), {}, [&](double) { return limits; });
    ASSERT_EQ(variable.size(), 4U);
    EXPECT_NEAR(variable[2].dt, variable[3].dt, 1e-15);
    EXPECT_GT(variable[3].dt, 0.1);
}

TEST(TimeControl, nothingToDoAtTheEnd)
{
    TimeControl control(fixedSteps(0.1, 1), from(1));
    EXPECT_FALSE(control.running());
    EXPECT_EQ(control.ending(), Ending::endTime);
    EXPECT_EQ(control.steps(), 0);
    EXPECT_FALSE(control.writesNow());
}

TEST(TimeControl, automaticStepIsTheStableOneTimesSafety)
{
    TimeSettings settings = automaticSteps(10);
    StepLimits limits;
    limits.largestStable = 0.1;
    limits.convectiveRate = 20;
    EXPECT_EQ(TimeControl(settings, {}).timeStep(limits), 0.8 * 0.1);

    settings.maxCo = 0.5;
    EXPECT_EQ(TimeControl(settings, {}).timeStep(limits), 0.025);
    settings.maxDeltaT = 0.01;
    EXPECT_EQ(TimeControl(settings, {}).timeStep(limits), 0.01);

    limits.viscousRate = 100;
    settings.maxViscousNumber = 0.25;
    EXPECT_EQ(TimeControl(settings, {}).timeStep(limits), 0.0025);
}

TEST(TimeControl, anUnlimitedFlowTakesAHundredthOfTheRun)
{
    EXPECT_EQ(TimeControl(automaticSteps(3), from(1)).timeStep({}), 0.02);
}

TEST(TimeControl, adjustedStepsGrowSlowlyAndShrinkAtOnce)
{
    TimeSettings settings = fixedSteps(0.001, 10);
    settings.adjustTimeStep = true;
    settings.maxCo = 0.5;
    TimeControl control(settings, {});
    const auto step = [&](double rate)
    {
        StepLimits limits;
        limits.convectiveRate = rate;
        const double dt = control.timeStep(limits);
        control.advance();
        return dt;
    };
    EXPECT_EQ(step(0), 0.001) << "deltaT is where it starts";
    EXPECT_DOUBLE_EQ(step(0), 0.0012);
    EXPECT_DOUBLE_EQ(step(100), 0.00144);
    EXPECT_DOUBLE_EQ(step(1000), 0.0005);
    EXPECT_DOUBLE_EQ(step(500), 0.0006);
}

TEST(TimeControl, fixedStepsHeedNoLimit)
{
    StepLimits limits;
    limits.largestStable = 1e-5;
    limits.convectiveRate = 1e5;
    EXPECT_EQ(TimeControl(fixedSteps(0.1, 1), {}).timeStep(limits), 0.1);
}

TEST(TimeControl, aFlowThatLeavesNoStepHasDiverged)
{
    for (const double largest : {0.0, 1e-14, std::nan("")})
    {
        StepLimits limits;
        limits.largestStable = largest;
        try
        {
            TimeControl(automaticSteps(1), {}).timeStep(limits);
            FAIL();
        }
        catch (const Error& error)
        {
            EXPECT_EQ(error.fault(), Fault::diverged);
        }
    }
}

TEST(TimeControl, adjustableWritesAreMetExactly)
{
    TimeSettings settings = automaticSteps(1);
    settings.writeControl = WriteControl::adjustableRunTime;
    settings.writeInterval = 0.1;
    const std::vector<Step> steps = march(settings, {}, varying);
    std::vector<double> expected;
    for (int k = 1; k < 10; ++k) { expected.push_back(k * 0.1); }
    expected.push_back(1);
    EXPECT_EQ(writeTimes(steps), expected);

    // Equal steps, and no more of them than it takes.
    settings.deltaT = 0.03;
    const std::vector<Step> equal = march(settings);
    EXPECT_EQ(equal.size(), 40U);
    for (const Step& step : equal) { EXPECT_NEAR(step.dt, 0.025, 1e-12); }
}

TEST(TimeControl, adjustableWritesBeyondTheEnd)
{
    TimeSettings settings = fixedSteps(0.25, 1);
    settings.writeControl = WriteControl::adjustableRunTime;
    settings.writeInterval = 0.8;
    EXPECT_EQ(writeTimes(march(settings)), (std::vector{0.8, 1.0}));
}

TEST(TimeControl, aFunctionMayAskForATime)
{
    const std::vector<Step> steps = march(fixedSteps(0.1, 1), {},
                                          [](double time)
                                          {
                                              StepLimits limits;
                                              limits.meetTime = time < 0.25 ? 0.25 : unlimited;
                                              return limits;
                                          });
    EXPECT_EQ(steps[2].time, 0.25);
    EXPECT_EQ(steps.back().time, 1.0);
}

TEST(TimeControl, writeTimesOfEachControl)
{
    TimeSettings settings = fixedSteps(0.1, 1);
    EXPECT_EQ(writeTimes(march(settings)), std::vector{1.0}) << "by default the end alone";

    settings.writeInterval = 4;
    const auto byStep = writeTimes(march(settings));
    ASSERT_EQ(byStep.size(), 3U);
    EXPECT_DOUBLE_EQ(byStep[0], 0.4);
    EXPECT_DOUBLE_EQ(byStep[1], 0.8);

    settings.writeControl = WriteControl::runTime;
    settings.writeInterval = 0.32;
    const auto byTime = writeTimes(march(settings));
    ASSERT_EQ(byTime.size(), 3U) << "the nearest steps to 0.32, 0.64, 0.96";
    EXPECT_DOUBLE_EQ(byTime[0], 0.3);
    EXPECT_DOUBLE_EQ(byTime[1], 0.6);
    EXPECT_EQ(byTime[2], 1.0);
}

TEST(TimeControl, stopAt)
{
    TimeSettings settings = fixedSteps(0.1, 1);
    settings.stopAt = StopAt::writeNow;
    EXPECT_EQ(march(settings), (std::vector<Step>{{0.1, 0.1, true}}));
    settings.stopAt = StopAt::noWriteNow;
    EXPECT_EQ(march(settings), (std::vector<Step>{{0.1, 0.1, false}}));

    settings.stopAt = StopAt::nextWrite;
    settings.writeInterval = 3;
    TimeControl control(settings, {});
    EXPECT_EQ(march(control).size(), 3U);
    EXPECT_EQ(control.ending(), Ending::stopAt);
    EXPECT_TRUE(control.writesNow());
}

TEST(TimeControl, steadyFlowsEndAndAreWritten)
{
    TimeSettings settings = fixedSteps(0.1, 1);
    settings.steadyTolerance = 1e-3;
    TimeControl control(settings, {});
    control.timeStep({});
    control.advance();
    control.noteAcceleration(2e-3);
    EXPECT_TRUE(control.running());
    EXPECT_FALSE(control.writesNow());
    control.noteAcceleration(5e-4);
    EXPECT_FALSE(control.running());
    EXPECT_TRUE(control.writesNow());
    EXPECT_EQ(toString(*control.ending()), "steady");
}

TEST(TimeControl, changesDuringARun)
{
    TimeControl control(fixedSteps(0.1, 1), {});
    for (int step = 0; step < 3; ++step)
    {
        control.timeStep({});
        control.advance();
    }
    TimeSettings changed = fixedSteps(0.05, 0.5);
    changed.writeInterval = 2;
    control.change(changed);
    const std::vector<Step> steps = march(control);
    EXPECT_EQ(steps.size(), 4U);
    EXPECT_EQ(steps.front().dt, 0.05);
    EXPECT_TRUE(steps.front().writes) << "step 4 of the run";

    control.change(fixedSteps(0.05, 0.2));
    EXPECT_FALSE(control.running());
}

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
