#pragma once

#include <cstdint>
#include <span>

namespace isph
{

/// CRC-32 as zlib, gzip and PNG use it (polynomial 0x04C11DB7, reflected), in blocks of 16 bytes.
///
/// Detects every change confined to 32 neighbouring bits, so every single byte.
/// \param before checksum of what came earlier, to go through a file piece by piece
std::uint32_t crc32(std::span<const char> bytes, std::uint32_t before = 0);

} // namespace isph
