#pragma once

#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"
#include "operators/DerivativeSymbol.hpp"
#include "schemes/stabilityLimits.hpp"

namespace isph
{

/// Adds to rates what a velocity at the points asks of a step: the Courant number per unit of time (largest and mean)
/// and the largest convective symbol max_k |u . D(k)|.
///
/// The latter is bounded at every point by the smaller of |u| max|D| (sharp for isotropic kernels below the Nyquist
/// wavenumber) and sum |u_j| max|D_j| (sharp for the exact derivative, and along any axis).
void addConvectiveRates(const Lattice& lattice, const RealField& velocity, const OperatorBounds& bounds, double nu,
                        StepRates& rates);

} // namespace isph
