#pragma once

#include "flow/IncompressibleFlow.hpp"
#include "operators/DerivativeSymbol.hpp"

namespace isph
{

/// Fourier coefficients (normalised: a constant is its own mean) of a velocity made fit to march: dealiased, without
/// checkerboard modes, and, if asked for, projected onto fields whose divergence vanishes.
StartReport startVelocity(const Lattice& lattice, const DerivativeSymbol& derivative, const RetainedModes& retained,
                          const RealField& velocity, bool project, SpectralField& coefficients);

} // namespace isph
