#pragma once

#include "case/Case.hpp"
#include "core/Selection.hpp"
#include "lattice/Lattice.hpp"
#include "transport/ScalarFunctions.hpp"

#include <string>
#include <vector>

namespace isph
{

/// One line for each type of function that a scalar has.
std::vector<ListedWord> scalarFunctionTypes();

/// The functions of system/controlDict on a scalar.
/// \param startTime name of the time folder they begin at
/// \param unit of T
/// \throws Error(input) with every slip in them, at its line: a type that a scalar does not have, ...
ScalarFunctions readScalarFunctions(const Case& theCase, const Lattice& lattice, const std::string& startTime,
                                    const std::string& unit);

} // namespace isph
