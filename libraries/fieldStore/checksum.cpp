#include "fieldStore/checksum.hpp"

#include <array>
#include <cstddef>
#include <cstring>

namespace isph
{

namespace
{

constexpr std::size_t stride = 16; ///< bytes taken at a time

using Table = std::array<std::array<std::uint32_t, 256>, stride>;

/// table[k][b]: what byte b adds to the checksum when k bytes of its stride follow it.
constexpr Table makeTable()
{
    Table table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte)
    {
        std::uint32_t value = byte;
        for (int bit = 0; bit < 8; ++bit) { value = (value >> 1) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U); }
        table[0][byte] = value;
    }
    for (std::size_t k = 1; k < stride; ++k)
    {
        for (std::size_t byte = 0; byte < 256; ++byte)
        {
            const std::uint32_t value = table[k - 1][byte];
            table[k][byte] = (value >> 8) ^ table[0][value & 0xFFU];
        }
    }
    return table;
}

constexpr Table table = makeTable();

} // namespace

std::uint32_t crc32(std::span<const char> bytes, std::uint32_t before)
{
    std::uint32_t value = ~before;
    const char* next = bytes.data();
    const char* const end = next + bytes.size();
    std::array<unsigned char, stride> block{};
    for (; static_cast<std::size_t>(end - next) >= stride; next += stride)
    {
        std::memcpy(block.data(), next, stride);
        // The first four bytes meet the checksum so far, lowest byte first.
        for (std::size_t i = 0; i < 4; ++i) { block[i] ^= static_cast<unsigned char>(value >> (8 * i)); }
        value = 0;
        for (std::size_t i = 0; i < stride; ++i) { value ^= table[stride - 1 - i][block[i]]; }
    }
    for (; next != end; ++next)
    {
        value = (value >> 8) ^ table[0][(value ^ static_cast<unsigned char>(*next)) & 0xFFU];
    }
    return ~value;
}

} // namespace isph
