#pragma once

#include "flow/FlowSettings.hpp"
#include "flow/Fluid.hpp"
#include "lattice/Lattice.hpp"
#include "operators/DerivativeSymbol.hpp"

namespace isph
{

/// The first derivative of a kernel by mode, from its samples where it is sampled.
DerivativeSymbol derivativeOf(const Lattice& lattice, const KernelSettings& kernel);

/// Minus the symbol of a Laplacian by mode, in the same way.
AlignedVector<double> laplacianOf(const Lattice& lattice, const KernelSettings& kernel, LaplacianForm form);

/// The largest symbols of a scene's operators over the modes it keeps, without building its flow. Those of the
/// Laplacian are zero for an inviscid fluid.
OperatorBounds boundsOf(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings);

} // namespace isph
