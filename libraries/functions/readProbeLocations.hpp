#pragma once

#include "dictionary/Dictionary.hpp"
#include "dictionary/Schema.hpp"
#include "lattice/Lattice.hpp"
#include "sampling/Interpolator.hpp"

#include <string>
#include <vector>

namespace isph
{

/// The keys of probes.
/// \param fields what is probed where nothing is said, e.g. "(U p)"
/// \param known the meaning of that key
std::vector<Key> probeKeys(const std::string& fields, const std::string& known);

/// The points of probeLocations, interpolated as the dictionary says.
/// \throws Error(input) at what is no point, or lies outside of the box.
Interpolator readProbeLocations(const Dictionary& dictionary, const Lattice& lattice);

} // namespace isph
