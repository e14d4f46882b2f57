#pragma once

#include "core/Origin.hpp"

#include <filesystem>
#include <string>

namespace isph
{

/// More bytes than any dictionary or table has.
inline constexpr std::size_t largestText = 4'000'000;

/// Reads a whole file.
/// \throws Error(input) at origin if it is no file, cannot be read, or is larger than largestText.
std::string readText(const std::filesystem::path& file, const Origin& origin);

/// The file of the suite's etc/ with this name: in $CONTINUA_ETC, else beside the programs, else where the suite was
/// built or installed. Empty if there is none.
std::filesystem::path findEtcFile(const std::string& name);

} // namespace isph
