#pragma once

#include "continuation/Continuation.hpp"
#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"

#include <array>
#include <memory>

namespace isph
{

/// The continuations of a lattice, one for each bounded direction (0, 1, 2), null for the others.
using Continuations = std::array<std::unique_ptr<Continuation>, 3>;

/// The lattice with its new points: periodic along every axis, with the same spacings, points first.
Lattice extendedLattice(const Lattice& lattice, const Continuations& continuations);

/// Every component of a field, continued along one bounded axis after the other.
/// \throws Error(input) without origin where an axis has too few points.
RealField continuedField(const RealField& field, const Lattice& lattice, const Continuations& continuations);

} // namespace isph
