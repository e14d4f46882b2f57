#pragma once

#include "case/Case.hpp"
#include "dictionary/Schema.hpp"
#include "flow/Fluid.hpp"
#include "lattice/Lattice.hpp"

namespace isph
{

const Schema& transportPropertiesSchema();

/// Reads constant/transportProperties. The body force becomes a function of time at the points of the lattice.
/// \throws Error(input), e.g. for a negative viscosity.
Fluid readFluid(const Case& flowCase, const Lattice& lattice);

} // namespace isph
