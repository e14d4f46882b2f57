#pragma once

#include "case/Case.hpp"
#include "core/Log.hpp"
#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"

#include <optional>
#include <string>
#include <vector>

namespace isph
{

/// system/fcExtendDict, completed; defaults where there is none.
Dictionary readFcExtendDict(const Case& theCase);

/// The scalar field that the exact derivatives belong to: exact.field, or the only one there is. Empty: none are given.
/// \throws Error(input) if it is none of the fields, or not told and not the only one.
std::string fieldOfExact(const Dictionary& fcExtendDict, const std::vector<std::string>& fields);

/// Differences of a gradient and a Laplacian from the exact ones of fcExtendDict: printed, and as errors.csv. L1 and L2
/// are means over points, of the gradient by magnitude; then its components alone.
void reportErrors(const Case& theCase, const std::string& timeName, double time, const Dictionary& fcExtendDict,
                  const Lattice& lattice, const RealField& gradient, const RealField& laplacian,
                  const std::string& unit, Log& log);

} // namespace isph
