#pragma once

#include "lattice/Lattice.hpp"

#include <array>
#include <vector>

namespace isph
{

/// Offsets, in points along each active axis, of all lattice points within a support radius of a point, itself
/// included.
///
/// Distances are scaled per axis, q = |x_j/h_j|; the rim belongs to the support (q <= radius (1 + 1e-12)), because
/// lattice points lie exactly on it at integer ratios and a Gaussian's weight there is not zero. A support larger than
/// the box reaches periodic images, each an offset of its own. \param smoothingLength h/dx \param supportRadius in h
/// \throws Error(input) without origin when the support holds more points than memory has room for.
std::vector<std::array<int, 3>> latticeStencil(const Lattice& lattice, double smoothingLength, double supportRadius);

} // namespace isph
