#pragma once

#include "case/TimeControl.hpp"

#include <cmath>
#include <functional>
#include <vector>

namespace isph
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

inline StepLimits none(double) { return {}; }

/// A flow whose limits go up and down: smooth, but never the same twice.
inline StepLimits varying(double time)
{
    StepLimits limits;
    limits.largestStable = 0.013 * (1.3 + std::sin(9 * time));
    limits.convectiveRate = 40 * (1.2 + std::cos(7 * time));
    return limits;
}

inline TimeState from(double time)
{
    TimeState state;
    state.time = state.origin = time;
    return state;
}

inline TimeSettings fixedSteps(double dt, double end)
{
    TimeSettings settings;
    settings.deltaT = dt;
    settings.endTime = end;
    return settings;
}

inline std::vector<Step> march(TimeControl& control, const Limits& limits = none)
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

inline std::vector<Step> march(const TimeSettings& settings, const TimeState& start = {}, const Limits& limits = none)
{
    TimeControl control(settings, start);
    return march(control, limits);
}

inline TimeSettings automaticSteps(double end)
{
    TimeSettings settings;
    settings.endTime = end;
    return settings;
}

} // namespace isph
