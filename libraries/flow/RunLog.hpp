#pragma once

#include "case/TimeControl.hpp"
#include "core/Log.hpp"
#include "core/Progress.hpp"
#include "flow/RunReport.hpp"

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace isph
{

/// The log of a run, in OpenFOAM's shape: what is active, a block per reported step, where the time went.
///
/// On a terminal a progress line stands for the blocks. Elsewhere a step is reported when it is the first, writes, ends
/// the run, or a second has passed; -verbose reports every step.
class RunLog
{
public:
    /// \param notes on the start, a line each
    RunLog(Log& log, bool verbose, const TimeControl& control, const RunReport& report,
           const std::vector<std::string>& notes);

    /// After a step of dt.
    /// \param rates of the state after it
    /// \param state a line on the state, asked for only where the step is reported
    void step(const StepRates& rates, double dt, const std::function<std::string()>& state);

    /// The closing table.
    void close(const RunReport& report, const Timings& timings);

private:
    using Clock = std::chrono::steady_clock;

    Log& log_;
    bool everyStep_;
    const TimeControl& control_;
    std::optional<Progress> progress_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point lastBlock_ = Clock::time_point::min();
};

} // namespace isph
