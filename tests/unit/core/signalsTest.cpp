#include "core/signals.hpp"

#include "support/inChild.hpp"

#include <chrono>
#include <csignal>
#include <gtest/gtest.h>
#include <thread>

using namespace isph;

TEST(signals, theFirstIsNoted)
{
    const int status = inChild(
        []
        {
            catchSignals();
            if (caughtSignal() != 0) { return 1; }
            std::raise(SIGTERM);
            return caughtSignal() == SIGTERM ? 7 : 2;
        });
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 7);
}

TEST(signals, twoAtOnceAreOneWish)
{
    const int status = inChild(
        []
        {
            catchSignals();
            std::raise(SIGTERM);
            std::raise(SIGTERM);
            return caughtSignal() == SIGTERM ? 7 : 2;
        });
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 7);
}

TEST(signals, aLaterSecondEndsTheProgram)
{
    const int status = inChild(
        []
        {
            catchSignals();
            std::raise(SIGTERM);
            std::this_thread::sleep_for(std::chrono::milliseconds(600));
            std::raise(SIGINT);
            return 0;
        });
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), SIGINT);
}
