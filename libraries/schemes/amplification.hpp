#pragma once

#include "schemes/TimeScheme.hpp"

#include <complex>
#include <span>

namespace isph
{

/// A mode of a linear flow: its rate of change is explicitRate - integratedRate times itself.
struct ModeRate
{
    std::complex<double> explicitRate = 0; ///< what the scheme steps [1/s]
    double integratedRate = 0;             ///< what an integrating factor takes away exactly [1/s]

    double filter = 1; ///< what a filter leaves of it at the end of a step

    /// How fast it grows in exact time, without a filter [1/s].
    double growth() const { return explicitRate.real() - integratedRate; }
};

/// The factor that a step of dt multiplies a mode by.
std::complex<double> amplification(const TimeScheme& scheme, const ModeRate& mode, double dt);

/// Largest growth of a step over modes, as the logarithm of the factor. \param modes at least one
double largestGrowth(const TimeScheme& scheme, std::span<const ModeRate> modes, double dt);

/// How fast the fastest mode grows in exact time, whatever the step [1/s]; 0 if none does.
double exactGrowth(std::span<const ModeRate> modes);

/// The largest dt whose steps make no mode grow but those that grow in exact time, and those hardly faster; found by
/// bisection. Infinity where no step does; 0 where every step does.
double largestStableStep(const TimeScheme& scheme, std::span<const ModeRate> modes);

} // namespace isph
