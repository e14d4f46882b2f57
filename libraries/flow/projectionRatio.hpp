#pragma once

#include "flow/FlowSettings.hpp"
#include "lattice/Lattice.hpp"

#include <string>

namespace isph
{

/// The largest ratio of -|D|^2, the divergence of a flow's gradient, to the Morris Laplacian of its sampled kernel,
/// over all waves that the flow keeps; infinite where that Laplacian is not negative.
///
/// A projection leaves 1 - ratio of a wave's divergence: beyond 2 it amplifies what it should take away. Kernels of
/// high order need wide enough a smoothing length, or their samples lose the Laplacian of short waves: 4.7 for order 20
/// at h/dx = 1.5 and a closed symbol, 1.0 at 2.
double largestProjectionRatio(const Lattice& lattice, const FlowSettings& settings);

/// What to say of a Laplacian that mirrors its neighbours at walls where gradients do not; empty where all is well.
std::string mirrorCaution(const Lattice& lattice, const FlowSettings& settings);

} // namespace isph
