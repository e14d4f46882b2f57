#pragma once

#include "dictionary/Dictionary.hpp"

#include <string>

namespace isph
{

/// The text of a field's dictionary whose values lie in fields.h5: the dimensions, the boundary conditions and the
/// constants that their expressions use. Formulas of the start, which no reader would know any more, are left out.
/// \param components 1 or 3, as dictionaries count them
std::string storedFieldText(const Dictionary& field, const std::string& name, int components);

} // namespace isph
