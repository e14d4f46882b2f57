#include "core/Error.hpp"
#include "march.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

using namespace isph;

namespace
{

std::vector<double> writeTimes(const std::vector<Step>& steps)
{
    std::vector<double> times;
    for (const Step& step : steps)
    {
        if (step.writes) { times.push_back(step.time); }
    }
    return times;
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
