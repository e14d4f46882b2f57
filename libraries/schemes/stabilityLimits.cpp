#include "schemes/stabilityLimits.hpp"

#include <cmath>
#include <limits>

namespace isph
{

namespace
{

/// Forward Euler: dt (|u|^2 max(D^2/L)/nu)/2 <= 1 for convection and dt nu max(L)/2 <= 1 for viscosity.
StabilityMargin explicitMargin(const TimeScheme& scheme, const StepRates& rates)
{
    const double convective =
        scheme.imaginaryLimit > 0 ? rates.convective / scheme.imaginaryLimit : 0.5 * rates.unbalancedConvection;
    return {convective, rates.viscous / scheme.realLimit};
}

double together(const TimeScheme& scheme, const StabilityMargin& margin)
{
    return scheme.imaginaryLimit > 0 ? std::hypot(margin.convective, margin.viscous)
                                     : margin.convective + margin.viscous;
}

} // namespace

bool viscousTermYields(const TimeScheme& scheme, const StepRates& rates, double dt)
{
    return rates.viscousYields && dt * together(scheme, explicitMargin(scheme, rates)) > 1;
}

StabilityMargin stabilityMargin(const TimeScheme& scheme, const StepRates& rates, double dt)
{
    const StabilityMargin perUnit = explicitMargin(scheme, rates);
    return {dt * perUnit.convective, viscousTermYields(scheme, rates, dt) ? 0 : dt * perUnit.viscous};
}

double largestStableStep(const TimeScheme& scheme, const StepRates& rates)
{
    const double rate = together(scheme, explicitMargin(scheme, rates));
    return rate > 0 ? 1 / rate : std::numeric_limits<double>::infinity();
}

} // namespace isph
