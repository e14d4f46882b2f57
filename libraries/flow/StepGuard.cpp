#include "flow/StepGuard.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace isph
{

namespace
{

/// Of the velocity, on a scale that stays the same during a run.
double sizeOf(const StepRates& rates) { return rates.magnitude > 0 ? rates.magnitude : rates.courant; }

} // namespace

std::optional<double> StepGuard::shorter(const StepRates& after, double dt, const TimeControl& control) const
{
    constexpr double tooFar = 2;
    const TimeSettings& settings = control.settings();
    // It is not the length of a tiny step that is to blame.
    if (settings.deltaT || dt < 1e-10 * (settings.endTime - control.time())) { return std::nullopt; }
    if (!std::isfinite(after.courant) || !std::isfinite(after.convective)) { return 0.1 * dt; }
    const double over = std::max(stabilityMargin(scheme_, after, dt).convective,
                                 settings.maxCo ? dt * after.courant / *settings.maxCo : 0);
    if (over <= tooFar) { return std::nullopt; }
    // A flow that a force speeds up has a Courant number that goes with the square of the step.
    return dt * std::clamp(std::sqrt(settings.safetyFactor / over), 0.1, 0.5);
}

StabilityMargin StepGuard::judge(const StepRates& rates, double dt)
{
    const StabilityMargin margin = stabilityMargin(scheme_, rates, dt);
    StepRates bearing = rates;
    if (viscousTermYields(scheme_, rates, dt)) { bearing.viscous = 0; }
    const double stable = largestStableStep(scheme_, bearing);
    if (margin.convectionRules()) { longest_ = std::max(longest_, dt); }
    largestMargin_ = std::max(largestMargin_, dt / stable);
    const double size = sizeOf(rates);
    if (size > 0 && (least_ == 0 || size < least_)) { least_ = size; }
    if (dt > stable && !warned_)
    {
        warned_ = true;
        stable_ = stable;
        log_.warning(fmt::format("deltaT {:.6g} is above the largest stable step {:.6g} (the {} term rules): "
                                 "the run may diverge. Write deltaT auto; or a smaller one.",
                                 dt, stable, margin.convectionRules() ? "convective" : "viscous"));
    }
    return margin;
}

std::optional<Error> StepGuard::divergence(const StepRates& rates, double dt, const TimeControl& control) const
{
    const bool finite = std::isfinite(rates.courant) && std::isfinite(rates.convective);
    const double over = finite ? stabilityMargin(scheme_, rates, dt).convective : 0;
    // Ruled by convection, be it far below its limit by maxCo, and not short for the sake of output.
    const double maxCo = control.settings().maxCo.value_or(std::numeric_limits<double>::infinity());
    const double ruled = std::min(largestStableStep(scheme_, rates), maxCo / rates.courant);
    const bool collapsed = dt < 1e-4 * longest_ && control.settings().endTime - control.time() > 1e5 * dt &&
                           rates.convective > 0 && ruled < 10 * dt;
    const bool grown = rates.convective == 0 && largestMargin_ > 1 && sizeOf(rates) > 1e9 * least_ && least_ > 0;
    if (finite && over <= divergedCo_ && !collapsed && !grown) { return std::nullopt; }

    const std::string what =
        collapsed
            ? fmt::format("the solution diverged before time {}: speeds have grown until the stable step is {:.3g} s, "
                          "{:.1g} of the longest one",
                          control.timeName(), dt, dt / longest_)
        : finite && grown
            ? fmt::format(
                  "the solution diverged in the step after time {}: speeds have grown {:.1g}-fold in steps above "
                  "the stable one",
                  control.timeName(), sizeOf(rates) / least_)
        : finite
            ? fmt::format("the solution diverged in the step after time {}: the Courant number reached {:.3g}, {:.3g} "
                          "times the stable one",
                          control.timeName(), dt * rates.courant, over)
            : fmt::format("the solution diverged in the step after time {}: the velocity is no longer finite",
                          control.timeName());
    return diverged(what,
                    "the flow is under-resolved or the scheme is not robust for it; try more points, "
                    "filter { type exponential; }, between walls another continuation, in periodic boxes convection "
                    "divergence; dealiasing twoThirds");
}

Error StepGuard::diverged(const std::string& what, const std::string& advice) const
{
    const std::string first =
        largestMargin_ > 1
            ? fmt::format("steps were up to {:.3g} times the stable one; take deltaT auto; or at most {:.4g}",
                          largestMargin_, 0.8 * stable_)
            : "steps kept to the limit: " + advice;
    return Error(Fault::diverged, what, first + "; the last good state is on disk");
}

} // namespace isph
