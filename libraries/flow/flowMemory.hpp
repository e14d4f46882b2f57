#pragma once

#include "flow/FlowSettings.hpp"
#include "flow/Fluid.hpp"
#include "lattice/Lattice.hpp"

namespace isph
{

/// Memory that a flow with these settings will need at most [bytes], without the functions of controlDict: its state,
/// tables, and what it takes to write it. Measured needs lie within a quarter of it.
double flowMemory(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings);

} // namespace isph
