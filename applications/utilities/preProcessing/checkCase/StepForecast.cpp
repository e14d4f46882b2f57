#include "StepForecast.hpp"

#include "fields/reductions.hpp"
#include "flow/convectiveRates.hpp"

#include <algorithm>
#include <cmath>

namespace isph
{

namespace
{

/// The rates that the flow itself will find at its start.
StepRates ratesAtStart(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings,
                       const OperatorBounds& bounds, const RealField& velocity)
{
    StepRates rates;
    if (fluid.nu > 0 && !settings.integratingFactor && !settings.crankNicolson)
    {
        rates.viscous = fluid.nu * bounds.laplacian;
    }
    if (settings.convection == ConvectionForm::none) { return rates; }
    if (!settings.exactMeanFlow)
    {
        addConvectiveRates(lattice, velocity, bounds, fluid.nu, rates);
        return rates;
    }
    RealField fluctuation = copyOf(velocity);
    for (int c = 0; c < fluctuation.components(); ++c)
    {
        const double mean = sum(velocity[c]) / static_cast<double>(lattice.points());
        for (double& u : fluctuation[c]) { u -= mean; }
    }
    addConvectiveRates(lattice, fluctuation, bounds, fluid.nu, rates);
    return rates;
}

} // namespace

StepForecast forecastSteps(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings,
                           const OperatorBounds& bounds, const TimeControl& control, const RealField& velocity)
{
    StepForecast forecast;
    forecast.bounds = bounds;
    forecast.numbers = stableNumbers(lattice, fluid, settings, forecast.bounds);
    forecast.rates = ratesAtStart(lattice, fluid, settings, forecast.bounds, velocity);
    if (settings.automaticViscous && fluid.nu > 0)
    {
        const bool fixed = control.settings().deltaT && !control.settings().adjustTimeStep;
        forecast.crankNicolson =
            crankNicolsonPays(*settings.time, forecast.rates, fixed ? control.settings().deltaT : std::nullopt);
        if (forecast.crankNicolson) { forecast.rates.viscous = 0; }
    }
    const StepLimits limits = stepLimits(lattice, fluid, *settings.time, forecast.rates);
    forecast.largestStable = limits.largestStable;
    if (std::isfinite(forecast.largestStable))
    {
        const bool convective = stabilityMargin(*settings.time, forecast.rates, 1).convectionRules();
        forecast.ruling = convective ? "convective" : "viscous";
    }

    TimeControl march = control;
    if (!march.running()) { return forecast; }
    forecast.step = march.timeStep(limits);
    forecast.margin = stabilityMargin(*settings.time, forecast.rates, forecast.step);
    forecast.viscousNumber = forecast.step * limits.viscousRate;
    forecast.steps = std::max(1.0, std::ceil((march.settings().endTime - march.time()) / forecast.step - 1e-6));
    return forecast;
}

} // namespace isph
