#include "core/signals.hpp"

#include <csignal>
#include <ctime>

namespace isph
{

namespace
{

// A signal handler can reach nothing but statics.
volatile std::sig_atomic_t caught = 0;
timespec caughtAt{};

double secondsSinceCaught()
{
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec - caughtAt.tv_sec) +
           1e-9 * static_cast<double>(now.tv_nsec - caughtAt.tv_nsec);
}

void takeNote(int signal)
{
    if (caught == 0)
    {
        clock_gettime(CLOCK_MONOTONIC, &caughtAt);
        caught = signal;
        return;
    }
    // timeout(1) and some shells signal both the process and its group: that is one wish, not two.
    if (secondsSinceCaught() < 0.5) { return; }
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

} // namespace

void catchSignals()
{
    caught = 0;
    struct sigaction action = {};
    action.sa_handler = takeNote;
    action.sa_flags = SA_RESTART; // reading and writing go on
    sigemptyset(&action.sa_mask);
    // While one is being noted the other waits.
    sigaddset(&action.sa_mask, SIGINT);
    sigaddset(&action.sa_mask, SIGTERM);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

int caughtSignal() { return caught; }

} // namespace isph
