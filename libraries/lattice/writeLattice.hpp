#pragma once

#include "lattice/Lattice.hpp"

#include <filesystem>

namespace isph
{

/// Writes constant/lattice, its folder too if there is none. The file is complete or not there: it is written under
/// another name and renamed.
/// \throws Error(input) naming the file if the machine refuses.
void writeLattice(const Lattice& lattice, const std::filesystem::path& file);

} // namespace isph
