#pragma once

#include "case/OutputControl.hpp"
#include "functions/FunctionObject.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace isph
{

/// When a function runs.
struct FunctionSchedule
{
    OutputControl control;
    std::optional<OutputControl> sampling;                       ///< executeControl, of functions that gather over time
    double timeStart = -std::numeric_limits<double>::infinity(); ///< [s], of the window the function runs in
    double timeEnd = std::numeric_limits<double>::infinity();    ///< [s]

    /// Earliest time a step has to end at [s]; infinity if there is none.
    double nextTime() const
    {
        constexpr double never = std::numeric_limits<double>::infinity();
        const double next = std::min(control.nextTime(), sampling ? sampling->nextTime() : never);
        return next <= timeEnd ? next : never;
    }
};

/// Functions with their schedules.
template<class Now>
class ScheduledFunctions
{
public:
    void add(FunctionSchedule schedule, std::unique_ptr<FunctionOn<Now>> function)
    {
        functions_.emplace_back(std::move(schedule), std::move(function));
    }

    /// Runs those that are due at this event.
    void execute(const StepEvent& event, const Now& now)
    {
        const double slack = 1e-9 * event.dt;
        for (auto& [schedule, function] : functions_)
        {
            // Controls count every event, also those outside of the window.
            const bool samples = schedule.sampling && schedule.sampling->due(event);
            const bool executes = schedule.control.due(event);
            if (event.time < schedule.timeStart - slack || event.time > schedule.timeEnd + slack) { continue; }
            if (samples) { function->accumulate(now); }
            if (executes) { function->execute(now); }
        }
    }

    /// Runs them, whatever their output control says (-postProcess): all but those that gather over a run, of which the
    /// times that were written hold too little.
    void executeAll(const Now& now)
    {
        for (auto& [schedule, function] : functions_)
        {
            if (!schedule.sampling) { function->execute(now); }
        }
    }

    /// Earliest time a step has to end at for one of them (adjustableRunTime); infinity if there is none.
    double nextTime() const
    {
        double next = std::numeric_limits<double>::infinity();
        for (const auto& [schedule, function] : functions_) { next = std::min(next, schedule.nextTime()); }
        return next;
    }

    bool empty() const { return functions_.empty(); }

    /// Last norms of every errorNorms, for report.json.
    std::vector<ErrorNorm> errors() const
    {
        std::vector<ErrorNorm> norms;
        for (const auto& [schedule, function] : functions_)
        {
            std::ranges::move(function->errors(), std::back_inserter(norms));
        }
        return norms;
    }

private:
    std::vector<std::pair<FunctionSchedule, std::unique_ptr<FunctionOn<Now>>>> functions_;
};

} // namespace isph
