#pragma once

#include "core/Origin.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <tuple>

namespace isph
{

/// The seal of a file of fields: its first 512 bytes (an HDF5 user block, which HDF5 itself never looks at). It says in
/// plain text what the file is, how many bytes follow, and their CRC-32.
///
/// HDF5 checks the values (Fletcher-32) but not what says where they are, and a damaged file can crash the library: so
/// the seal is verified before HDF5 sees the file.
using Seal = std::array<char, 512>;

inline constexpr std::size_t sealSize = std::tuple_size_v<Seal>;

/// The seal of contents (all bytes from sealSize on).
Seal sealOf(std::span<const char> contents);

/// \throws Error(input) at origin if the file is missing, unreadable, no file of fields, or differs from its seal in
///         any byte, those of the seal included.
void verifySeal(const std::filesystem::path& file, const Origin& origin);

} // namespace isph
