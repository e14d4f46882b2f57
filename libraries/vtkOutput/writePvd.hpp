#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace isph
{

/// A file of a collection and the time it shows.
struct PvdEntry
{
    double time = 0;  ///< [s]
    std::string file; ///< relative to the collection
};

/// The text of a ParaView collection.
std::string pvdText(std::span<const PvdEntry> entries);

/// Writes a collection (.pvd): complete, under another name, then renamed, so that ParaView never reads half of it.
/// \throws Error(input) naming the file if the machine refuses.
void writePvd(const std::filesystem::path& file, std::span<const PvdEntry> entries);

} // namespace isph
