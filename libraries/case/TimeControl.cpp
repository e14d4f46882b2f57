#include "case/TimeControl.hpp"

#include "core/Error.hpp"
#include "core/signals.hpp"
#include "core/Timings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace isph
{

namespace
{

/// Of a fixed step: a rest of the run that is smaller than this is no step of its own.
constexpr double sliver = 1e-3;

/// Two step lengths that differ by round-off only.
bool alike(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(a, b); }

} // namespace

std::string_view toString(Ending ending)
{
    switch (ending)
    {
    case Ending::endTime:
        return "endTime";
    case Ending::stopAt:
        return "stopAt";
    case Ending::steady:
        return "steady";
    case Ending::signal:
        return "signal";
    case Ending::diverged:
        break;
    }
    return "diverged";
}

TimeControl::TimeControl(const TimeSettings& settings, const TimeState& start)
    : settings_(settings),
      state_(start),
      output_(settings.writeControl, settings.writeInterval),
      startTime_(start.time),
      startIndex_(start.index)
{
    output_.due(event());
}

void TimeControl::change(const TimeSettings& settings)
{
    settings_ = settings;
    output_ = OutputControl(settings.writeControl, settings.writeInterval);
    StepEvent present = event();
    present.start = true; // intervals that have passed are not made up for
    output_.due(present);
    if (atEnd() && !ending_) { ending_ = Ending::endTime; }
}

double TimeControl::until(double time) const { return (time - state_.time) - state_.carry; }

double TimeControl::slack(double step) const
{
    // The step is a rounded number itself, and N of them are off by N of its last bits: as much as the times' own last
    // bits amount to.
    const double largest = std::max(std::abs(settings_.endTime), std::abs(state_.origin));
    return std::max(1e-9 * step, 4 * std::numeric_limits<double>::epsilon() * largest);
}

bool TimeControl::atEnd() const { return until(settings_.endTime) <= 1e-9 * state_.deltaT; }

bool TimeControl::running()
{
    // Later on, advance() decides, so that what stops the run is known when the fields are written.
    if (!ending_ && steps() == 0)
    {
        if (atEnd()) { ending_ = Ending::endTime; }
        else if (caughtSignal() != 0) { ending_ = Ending::signal; }
    }
    return !ending_;
}

double TimeControl::nominalStep(const StepLimits& limits) const
{
    const bool automatic = !settings_.deltaT;
    if (!automatic && !settings_.adjustTimeStep) { return *settings_.deltaT; }

    const double maxCo = settings_.maxCo.value_or(automatic ? unlimited : 1.0);
    const auto perRate = [](double number, double rate) { return rate > 0 ? number / rate : unlimited; };
    const double largest = std::min({automatic ? settings_.safetyFactor * limits.largestStable : limits.largestStable,
                                     perRate(maxCo, limits.convectiveRate),
                                     perRate(settings_.maxViscousNumber, limits.viscousRate), settings_.maxDeltaT});
    if (!(largest > 1e-12 * (settings_.endTime - state_.origin)))
    {
        throw Error(Fault::diverged,
                    fmt::format("the largest stable step has become {} s at time {}", largest, timeName()),
                    "the flow has grown beyond all bounds: refine the lattice or filter the flow");
    }
    if (automatic)
    {
        // A flow that nothing limits, at rest say, has no step of its own.
        return std::isfinite(largest) ? largest : (settings_.endTime - state_.origin) / 100;
    }

    // OpenFOAM's way to the limit: down at once, up by no more than a fifth a step.
    if (state_.nominal == 0) { return std::min(*settings_.deltaT, largest); }
    const double factor = largest / state_.nominal;
    return std::min(largest, std::min(1 + 0.1 * factor, 1.2) * state_.nominal);
}

double TimeControl::timeStep(const StepLimits& limits)
{
    const bool fixed = settings_.deltaT && !settings_.adjustTimeStep;
    nextNominal_ = nominalStep(limits);
    arrival_.reset();
    double step = nextNominal_;

    const double end = settings_.endTime;
    const auto ahead = [&](double time) { return until(time) > slack(step) ? time : unlimited; };
    const double target = std::min(ahead(output_.nextTime()), ahead(limits.meetTime));
    const double left = until(target < end - slack(step) ? target : end);
    const double count = std::max(1.0, std::ceil((left - slack(step)) / step));
    if (target <= end + slack(step)) // equal steps up to the target
    {
        step = left / count;
        if (count == 1) { arrival_ = target < end - slack(step) ? target : end; }
    }
    else if (left <= step * (fixed ? 1 + sliver : 1) + slack(step))
    {
        step = left;
        arrival_ = end;
    }
    else if (!fixed && count == 2) { step = left / 2; } // two like steps rather than one and a sliver

    // The same bits while the step is the same, so that what was prepared for its length remains of use.
    if (alike(step, nextNominal_)) { step = nextNominal_; }
    else if (alike(step, state_.deltaT)) { step = state_.deltaT; }
    return nextStep_ = step;
}

void TimeControl::advance()
{
    // Knuth's exact sum of two numbers; what the first cannot hold is carried along.
    const double sum = state_.time + nextStep_;
    const double added = sum - state_.time;
    const double lost = (state_.time - (sum - added)) + (nextStep_ - added);
    const double carry = state_.carry + lost;
    // A run that is extended later goes on from the sum, not from the endTime that it was rounded to.
    state_.time = arrival_.value_or(sum + carry);
    state_.carry = carry - (state_.time - sum);
    ++state_.index;
    state_.deltaT = nextStep_;
    state_.nominal = nextNominal_;

    if (settings_.stopAt == StopAt::writeNow || settings_.stopAt == StopAt::noWriteNow) { ending_ = Ending::stopAt; }
    else if (atEnd()) { ending_ = Ending::endTime; }
    else if (caughtSignal() != 0) { ending_ = Ending::signal; }

    outputDue_ = output_.due(event());
    if (outputDue_ && !ending_ && settings_.stopAt == StopAt::nextWrite) { ending_ = Ending::stopAt; }
}

void TimeControl::noteAcceleration(double largest)
{
    if (settings_.steadyTolerance && largest < *settings_.steadyTolerance) { end(Ending::steady); }
}

void TimeControl::end(Ending ending)
{
    if (!ending_) { ending_ = ending; }
}

std::string TimeControl::timeName() const
{
    return isph::timeName(state_.time, state_.deltaT, settings_.timeFormat, settings_.timePrecision);
}

StepEvent TimeControl::event() const
{
    StepEvent event;
    event.time = state_.time;
    event.origin = state_.origin;
    event.dt = state_.deltaT;
    event.index = state_.index;
    event.cpuTime = cpuSeconds();
    event.clockTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - startClock_).count();
    event.start = steps() == 0;
    event.writes = writesNow();
    event.end = ending_.has_value();
    return event;
}

bool TimeControl::writesNow() const
{
    if (ending_ == Ending::stopAt && settings_.stopAt == StopAt::noWriteNow) { return false; }
    return steps() > 0 && (outputDue_ || ending_);
}

TimeState TimeControl::state() const
{
    TimeState state = state_;
    const StepEvent now = event();
    state.cpuTime += now.cpuTime;
    state.wallTime += now.clockTime;
    return state;
}

} // namespace isph
