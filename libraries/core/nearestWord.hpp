#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace isph
{

/// Number of insertions, deletions, substitutions and swaps of neighbours that turn one word into the other.
int editDistance(std::string_view a, std::string_view b);

/// The known word nearest to what was written, if it is near enough to be a slip (two edits, or a third of its
/// length for long words; letter case does not count).
std::optional<std::string> nearestWord(std::string_view written, std::span<const std::string> known);

/// "a, b, c", the nearest to what was written first when there is one.
std::string listOfWords(std::string_view written, std::span<const std::string> known);

} // namespace isph
