#include "flow/stableNumbers.hpp"

#include <algorithm>
#include <cmath>

namespace isph
{

double smallestSpacing(const Lattice& lattice)
{
    double least = lattice.activeAxis(0).spacing();
    for (int d = 1; d < lattice.dimensions(); ++d) { least = std::min(least, lattice.activeAxis(d).spacing()); }
    return least;
}

StableNumbers stableNumbers(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings,
                            const OperatorBounds& bounds)
{
    StableNumbers numbers;
    double derivative = 0; // largest max|D_j| dx_j
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        derivative =
            std::max(derivative, bounds.derivative[static_cast<std::size_t>(d)] * lattice.activeAxis(d).spacing());
    }
    if (settings.convection != ConvectionForm::none && derivative > 0)
    {
        numbers.courant = settings.time->imaginaryLimit / derivative;
    }
    if (fluid.nu > 0 && !settings.integratingFactor && !settings.crankNicolson && bounds.laplacian > 0)
    {
        const double dx = smallestSpacing(lattice);
        numbers.viscous = settings.time->realLimit / (dx * dx * bounds.laplacian);
    }
    return numbers;
}

bool crankNicolsonPays(const TimeScheme& scheme, const StepRates& rates, std::optional<double> dt)
{
    constexpr double leastGain = 4;
    const double explicitStep = largestStableStep(scheme, rates);
    if (dt) { return *dt > explicitStep; }
    StepRates implicit = rates;
    implicit.viscous = 0;
    const double implicitStep = largestStableStep(scheme, implicit);
    return std::isfinite(implicitStep) && implicitStep >= leastGain * explicitStep;
}

StepLimits stepLimits(const Lattice& lattice, const Fluid& fluid, const TimeScheme& scheme, const StepRates& rates,
                      double meetTime)
{
    const double dx = smallestSpacing(lattice);
    return {.largestStable = largestStableStep(scheme, rates),
            .convectiveRate = rates.courant,
            .viscousRate = rates.viscous > 0 ? fluid.nu / (dx * dx) : 0,
            .meetTime = meetTime};
}

} // namespace isph
