#pragma once

#include "flow/FlowSettings.hpp"
#include "flow/Fluid.hpp"
#include "schemes/amplification.hpp"
#include "stability/LineSpectra.hpp"

#include <array>
#include <vector>

namespace isph
{

/// Every mode that a flow in a periodic box keeps, carried by a uniform velocity (components along the active axes
/// [m/s]) and damped by viscosity: the linear flow, exactly.
std::vector<ModeRate> periodicModes(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings,
                                    const std::array<double, 3>& velocity);

/// Modes between walls without pressure: carried by a uniform velocity along the d-th active axis [m/s]. Empty where
/// lines are too long.
std::vector<ModeRate> carriedModes(const Lattice& lattice, const LineSpectra& spectra, int d, double velocity);

/// The same, damped by an explicit viscous term. Of all sums of eigenvalues along the axes those are taken that lie
/// outermost in one of many directions.
std::vector<ModeRate> dampedModes(const Lattice& lattice, const LineSpectra& spectra, double nu);

} // namespace isph
