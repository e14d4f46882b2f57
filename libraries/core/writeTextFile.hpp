#pragma once

#include <filesystem>
#include <string_view>

namespace isph
{

/// Writes a whole file under a temporary name beside it, syncs it to disk and renames it: the file is either the old
/// one or complete. Missing parent folders are made.
/// \throws Error(input) naming the file and the machine's reason (disk full, no permission).
void writeTextFile(const std::filesystem::path& file, std::string_view text);

} // namespace isph
