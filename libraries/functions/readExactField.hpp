#pragma once

#include "dictionary/Dictionary.hpp"
#include "functions/ErrorNorms.hpp"
#include "lattice/Lattice.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isph
{

/// The field that a key of `exact` describes: uniform, expression or table.
/// \param constants names that expressions know besides the dictionary's
/// \param folder where tables are looked for (the case)
/// \throws Error(input) at the entry.
std::unique_ptr<const ExactField> readExactField(const Dictionary& exact, std::string_view key, int components,
                                                 const std::vector<std::pair<std::string, double>>& constants,
                                                 const std::filesystem::path& folder, const Lattice& lattice);

} // namespace isph
