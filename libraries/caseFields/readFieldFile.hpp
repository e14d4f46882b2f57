#pragma once

#include "case/Case.hpp"
#include "dictionary/Dictionary.hpp"
#include "lattice/Lattice.hpp"

#include <string>

namespace isph
{

/// Reads the dictionary of a field in a time folder, e.g. 0/U: dimensions, internalField and boundaryField. Every patch
/// of the lattice has a condition, and every condition a patch; what the conditions say is for the caller to judge.
/// \throws Error(input) with file and line: an unknown patch, a patch without condition, one that is periodic only in
/// the lattice, ...
Dictionary readFieldFile(const Case& theCase, const std::string& time, const std::string& name, const Lattice& lattice);

} // namespace isph
