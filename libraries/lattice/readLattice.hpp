#pragma once

#include "dictionary/Dictionary.hpp"
#include "dictionary/Schema.hpp"
#include "lattice/Lattice.hpp"

#include <string>
#include <string_view>

namespace isph
{

/// The lattice that constant/lattice describes (written by makeLattice).
/// \throws Error(input) where the file contradicts itself.
Lattice readLattice(const Dictionary& dictionary);

/// The lattice that system/latticeDict asks for (contract, section 2).
/// \throws Error(input): a face in no patch or in two, a periodic patch with one face, an extent that is no multiple of
///         the spacing, counts out of range, ...
Lattice makeLattice(const Dictionary& latticeDict);

/// The dictionary constant/lattice: the resolved facts plus spacings. Its numbers read back exactly.
std::string latticeText(const Lattice& lattice);

/// "periodic", "bounded" or "leftOut".
std::string toString(const Axis& axis);

/// "periodic", "wall" or "patch".
std::string_view toString(Patch::Type type);

const Schema& latticeSchema();     ///< of constant/lattice
const Schema& latticeDictSchema(); ///< of system/latticeDict

} // namespace isph
