#include "core/Progress.hpp"

#include "core/numberText.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace isph
{

namespace
{

constexpr double refreshSeconds = 0.25;

std::string duration(double seconds)
{
    const auto total = static_cast<long>(std::ceil(seconds));
    if (total >= 86400) { return fmt::format("{} d {} h", total / 86400, total % 86400 / 3600); }
    if (total >= 3600) { return fmt::format("{}:{:02}:{:02}", total / 3600, total % 3600 / 60, total % 60); }
    return fmt::format("{}:{:02}", total / 60, total % 60);
}

} // namespace

Progress::Progress(Log& log, double from, double to)
    : log_(log), shown_(log.onTerminal() && to > from), from_(from), to_(to), lastTime_(from)
{
}

Progress::~Progress() { log_.status(""); }

void Progress::update(double time, long step)
{
    if (!shown_) { return; }
    const Clock::time_point now = Clock::now();
    const double passed = std::chrono::duration<double>(now - last_).count();
    if (lastStep_ >= 0 && passed < refreshSeconds) { return; }

    if (lastStep_ >= 0)
    {
        // Smoothed over some ten refreshes, so that the time left does not flicker.
        const double weight = stepsPerSecond_ == 0 ? 1 : 0.1;
        stepsPerSecond_ += weight * (static_cast<double>(step - lastStep_) / passed - stepsPerSecond_);
        timePerSecond_ += weight * ((time - lastTime_) / passed - timePerSecond_);
    }
    const double left = timePerSecond_ > 0 ? (to_ - time) / timePerSecond_ : -1;
    log_.status(progressText(time, (time - from_) / (to_ - from_), stepsPerSecond_, left));
    last_ = now;
    lastTime_ = time;
    lastStep_ = step;
}

std::string progressText(double time, double fraction, double stepsPerSecond, double left)
{
    std::string text = fmt::format("Time = {:<10.6g} {:5.1f} %", time, 100 * std::clamp(fraction, 0.0, 1.0));
    if (left >= 0) { text += fmt::format("   {:.3g} steps/s   {} left", stepsPerSecond, duration(left)); }
    return text;
}

} // namespace isph
