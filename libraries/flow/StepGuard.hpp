#pragma once

#include "case/TimeControl.hpp"
#include "core/Error.hpp"
#include "core/Log.hpp"
#include "schemes/stabilityLimits.hpp"

#include <optional>
#include <string>

namespace isph
{

/// Watches that steps stay below what the scheme bears, and that the solution stays a solution.
class StepGuard
{
public:
    StepGuard(Log& log, const TimeScheme& scheme, double divergedCo)
        : log_(log), scheme_(scheme), divergedCo_(divergedCo)
    {
    }

    /// What a step of dt that was chosen by itself (deltaT auto) should have been where it is more than twice what the
    /// flow bears that it led to, or than maxCo: a flow at rest, or nearly so, does not know how fast a force or a wall
    /// is about to make it.
    /// \return [s], at most half of dt
    std::optional<double> shorter(const StepRates& after, double dt, const TimeControl& control) const;

    /// Margin of a step; warns, once a run, of a step above the limit.
    StabilityMargin judge(const StepRates& rates, double dt);

    /// The error if the state after a step of dt has diverged: anything not finite, a Courant number divergedCo times
    /// the stable one, or steps that have shrunk, as speeds grew, until the run would not end: 1e-4 of the longest one
    /// that convection ruled, with 1e5 of them to go; without convection, which no Courant number limits, speeds that
    /// have grown 1e9-fold in steps above the stable one.
    std::optional<Error> divergence(const StepRates& rates, double dt, const TimeControl& control) const;

    /// The error of a run that has diverged.
    /// \param what happened, and when
    /// \param advice for a run whose steps were stable; of others the step is to blame
    Error diverged(const std::string& what, const std::string& advice) const;

private:
    Log& log_;
    const TimeScheme& scheme_;
    double divergedCo_;
    bool warned_ = false;
    double largestMargin_ = 0;
    double longest_ = 0; ///< step that convection ruled [s]
    double stable_ = 0;  ///< step at the time of the warning [s]
    double least_ = 0;   ///< least size of the velocity that was not zero
};

} // namespace isph
