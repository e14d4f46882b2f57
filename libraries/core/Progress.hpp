#pragma once

#include "core/Log.hpp"

#include <chrono>
#include <string>

namespace isph
{

/// One line on a terminal: how much of a run is done, steps per second, time left. Refreshed a few times a second at
/// most; nothing where the log does not go to a terminal. Taken away when the object goes.
class Progress
{
public:
    /// \param from, to the times [s] between which the run goes
    Progress(Log& log, double from, double to);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// To be called every step; costs a look at the clock.
    /// \param time where the run is [s]
    /// \param step steps taken so far, counted from anywhere
    void update(double time, long step);

private:
    using Clock = std::chrono::steady_clock;

    Log& log_;
    bool shown_;
    double from_;
    double to_;
    Clock::time_point last_ = Clock::now();
    double lastTime_;
    long lastStep_ = -1;
    double timePerSecond_ = 0;  ///< simulated seconds per second, smoothed
    double stepsPerSecond_ = 0; ///< smoothed
};

/// The line itself: "Time = 0.25   25 %   1234 steps/s   0:12 left".
/// \param left seconds to go; negative: not known yet
std::string progressText(double time, double fraction, double stepsPerSecond, double left);

} // namespace isph
