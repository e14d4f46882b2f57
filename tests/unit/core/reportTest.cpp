#include "core/Log.hpp"
#include "core/Progress.hpp"
#include "core/Timings.hpp"

#include <gtest/gtest.h>

using namespace isph;

namespace
{

void burn(double seconds)
{
    const Timings clock;
    while (clock.total() < seconds) {}
}

} // namespace

TEST(Log, noneShowsNothingButWarnings)
{
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    {
        Log log(Log::Report::none);
        log.line("report");
        log.stream() << "more";
        log.warning("careful");
        log.closingSummary();
        EXPECT_FALSE(log.shown());
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "warning: careful\n");
}

TEST(Log, aFileGetsNoStatusLine)
{
    testing::internal::CaptureStdout();
    {
        Log log;
        log.status("50 %");
        Progress progress(log, 0, 1);
        progress.update(0.5, 10);
        log.line("done");
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "done\n");
}

TEST(Progress, text)
{
    EXPECT_EQ(progressText(0.25, 0.25, 1234, 12), "Time = 0.25        25.0 %   1.23e+03 steps/s   0:12 left");
    EXPECT_EQ(progressText(0.25, 0.25, 12, 7384), "Time = 0.25        25.0 %   12 steps/s   2:03:04 left");
    EXPECT_EQ(progressText(10, 1.2, 12, -1), "Time = 10         100.0 %");
}

TEST(Timings, nestedScopesAddUp)
{
    Timings timings;
    {
        const auto outer = timings.scope(Phase::pointwise);
        burn(0.01);
        {
            const auto inner = timings.scope(Phase::transforms);
            burn(0.02);
        }
        burn(0.01);
    }
    burn(0.01);
    // Lower bounds only: a busy machine takes longer. Counting anything twice would exceed the total.
    EXPECT_GE(timings.seconds(Phase::pointwise), 0.02);
    EXPECT_GE(timings.seconds(Phase::transforms), 0.02);
    EXPECT_GE(timings.other(), 0.01);
    const double sum = timings.other() + timings.seconds(Phase::pointwise) + timings.seconds(Phase::transforms);
    EXPECT_LE(sum, timings.total() + 1e-9);
}

TEST(Timings, processFigures)
{
    const double before = cpuSeconds();
    burn(0.01);
    EXPECT_GT(cpuSeconds(), before);
    EXPECT_GT(peakMemory(), 1 << 20);
}
