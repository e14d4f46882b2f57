#include "schemes/stabilityLimits.hpp"

#include <cmath>
#include <limits>

namespace isph
{

StabilityMargin stabilityMargin(const TimeScheme& scheme, const StepRates& rates, double dt)
{
    // Forward Euler: dt (|u|^2 max(D^2/L)/nu)/2 <= 1 for convection and dt nu max(L)/2 <= 1 for viscosity.
    const double convective =
        scheme.imaginaryLimit > 0 ? rates.convective / scheme.imaginaryLimit : 0.5 * rates.unbalancedConvection;
    return {dt * convective, dt * rates.viscous / scheme.realLimit};
}

double largestStableStep(const TimeScheme& scheme, const StepRates& rates)
{
    const StabilityMargin perUnit = stabilityMargin(scheme, rates, 1);
    const double together = scheme.imaginaryLimit > 0 ? std::hypot(perUnit.convective, perUnit.viscous)
                                                      : perUnit.convective + perUnit.viscous;
    return together > 0 ? 1 / together : std::numeric_limits<double>::infinity();
}

} // namespace isph
