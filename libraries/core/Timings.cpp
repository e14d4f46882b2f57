#include "core/Timings.hpp"

#include <ctime>
#include <numeric>
#include <sys/resource.h>

namespace isph
{

double Timings::total() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

double Timings::other() const { return total() - std::accumulate(seconds_.begin(), seconds_.end(), 0.0); }

int Timings::switchTo(int phase)
{
    const Clock::time_point now = Clock::now();
    if (current_ >= 0)
    {
        seconds_[static_cast<std::size_t>(current_)] += std::chrono::duration<double>(now - last_).count();
    }
    last_ = now;
    const int previous = current_;
    current_ = phase;
    return previous;
}

double cpuSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

long peakMemory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss * 1024; // Linux counts kilobytes
}

} // namespace isph
