#pragma once

#include "case/TimeControl.hpp"
#include "flow/FlowSettings.hpp"
#include "flow/Fluid.hpp"
#include "lattice/Lattice.hpp"
#include "operators/DerivativeSymbol.hpp"
#include "schemes/stabilityLimits.hpp"

#include <optional>

namespace isph
{

/// What the schemes of a scene bear, as the numbers a user knows. Nothing where nothing limits.
struct StableNumbers
{
    /// Largest |u| dt/dx of a flow along an axis; 0 where convection alone has no stable step (firstOrderProjection).
    std::optional<double> courant;

    /// Largest nu dt/dx^2, dx the smallest spacing, where the viscous term is explicit.
    std::optional<double> viscous;
};

/// \param bounds of the modes that are kept (boundsOf)
StableNumbers stableNumbers(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings,
                            const OperatorBounds& bounds);

/// The smallest spacing of the active axes [m].
double smallestSpacing(const Lattice& lattice);

/// Whether `viscous auto` takes the next step of a flow between walls by Crank-Nicolson: where the explicit term does
/// not bear the step that is asked for, or, where the step is free, where convection alone allows a step at least four
/// times as long (Crank-Nicolson is of second order, the explicit term of third). A flow at rest asks for no step:
/// explicit. \param rates with the viscous term explicit \param dt the step, if it is fixed [s]
bool crankNicolsonPays(const TimeScheme& scheme, const StepRates& rates, std::optional<double> dt = std::nullopt);

/// What limits the next step of a flow with these rates.
/// \param meetTime a time that a step has to end at, for functions [s]
StepLimits stepLimits(const Lattice& lattice, const Fluid& fluid, const TimeScheme& scheme, const StepRates& rates,
                      double meetTime = unlimited);

} // namespace isph
