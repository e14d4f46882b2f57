#pragma once

#include "case/TimeControl.hpp"
#include "fields/Field.hpp"
#include "flow/FlowSettings.hpp"
#include "flow/Fluid.hpp"
#include "flow/stableNumbers.hpp"
#include "lattice/Lattice.hpp"
#include "operators/DerivativeSymbol.hpp"
#include "schemes/stabilityLimits.hpp"

namespace isph
{

/// What limits the steps of a run, and the step it will begin with.
struct StepForecast
{
    OperatorBounds bounds;
    StableNumbers numbers;
    StepRates rates;                  ///< of the velocity at the start
    double largestStable = unlimited; ///< step at the start [s]
    double step = 0;                  ///< the first step [s]; 0 if the run is at its end
    StabilityMargin margin;           ///< of the first step
    double viscousNumber = 0;         ///< nu dt/dx^2 of the first step, where the viscous term is explicit
    bool crankNicolson = false;       ///< `viscous auto` begins with it
    double steps = 0;                 ///< to endTime if all are like the first

    std::string_view ruling = "none"; ///< "convective", "viscous", or "none" where nothing limits the step
};

/// \param bounds of the operators that the solver has
/// \param control at the start of the run
/// \param velocity at the points, as written: the projection of the start is not made
/// \throws Error(diverged) if no step would ever reach the end.
StepForecast forecastSteps(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings,
                           const OperatorBounds& bounds, const TimeControl& control, const RealField& velocity);

} // namespace isph
