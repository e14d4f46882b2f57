#pragma once

#include "case/Case.hpp"
#include "Sweep.hpp"

namespace isph
{

/// Reads system/workPrecisionDict of a case into runs, lines, quantities and pictures.
/// \param reduced lay its dictionary `reduced` over the rest
/// \throws Error(input) for anything that is wrong with the dictionary itself.
Sweep readSweep(const Case& theCase, bool reduced);

/// The pictures of `plot`, or one for each error against the processor time.
/// \throws Error(input) if one names a column that the table will not have.
void readPictures(const Dictionary& dictionary, Sweep& sweep);

/// The results of `external`.
/// \throws Error(input) if a file or a column is missing.
void readExternals(const Case& theCase, const Dictionary& dictionary, Sweep& sweep);

/// A quantity of `error` or `collect`.
/// \throws Error(input) if it names no source, or several.
Quantity readQuantity(const std::string& name, const Dictionary& dictionary);

} // namespace isph
