#pragma once

#include "core/CommandLine.hpp"

#include <span>
#include <string>
#include <vector>

namespace isph
{

/// The fields that -fields '(U p)' chooses, in its order; all that are available without the option.
/// \throws Error(usage) if it names none; Error(input) for a field that is not available, listing those that are.
std::vector<std::string> selectFields(std::span<const std::string> available, const CommandLine& line);

} // namespace isph
