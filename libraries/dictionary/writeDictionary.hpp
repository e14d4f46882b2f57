#pragma once

#include "dictionary/Dictionary.hpp"

#include <string>

namespace isph
{

/// The header that every file of a case begins with, OpenFOAM's FoamFile.
/// \param foamClass dictionary, latticeScalarField, latticeVectorField
/// \param object name of the file
std::string foamHeader(const std::string& foamClass, const std::string& object);

/// A dictionary as text, without a header (its own FoamFile entry is left out): reads back equal, numbers in all bits.
/// \throws Error(input) for what no text can hold (a keyword with blanks, say), at the entry's origin.
std::string dictionaryText(const Dictionary& dictionary);

/// The value of an entry as text, "(1 0 0)" or "{ ... }", without its keyword and semicolon.
std::string valueText(const Entry& entry);

} // namespace isph
