#include "fieldStore/checksum.hpp"

#include <array>
#include <cstddef>

namespace isph
{

namespace
{

using Table = std::array<std::array<std::uint32_t, 256>, 8>;

/// table[k][b]: what byte b adds to the checksum when k bytes follow it.
constexpr Table makeTable()
{
    Table table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte)
    {
        std::uint32_t value = byte;
        for (int bit = 0; bit < 8; ++bit) { value = (value >> 1) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U); }
        table[0][byte] = value;
    }
    for (std::size_t k = 1; k < 8; ++k)
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

std::uint32_t byteAt(std::span<const char> bytes, std::size_t i) { return static_cast<unsigned char>(bytes[i]); }

} // namespace

std::uint32_t crc32(std::span<const char> bytes, std::uint32_t before)
{
    std::uint32_t value = ~before;
    std::size_t i = 0;
    for (; i + 8 <= bytes.size(); i += 8)
    {
        const std::uint32_t low = value ^ (byteAt(bytes, i) | byteAt(bytes, i + 1) << 8 | byteAt(bytes, i + 2) << 16 |
                                           byteAt(bytes, i + 3) << 24);
        value = table[7][low & 0xFFU] ^ table[6][low >> 8 & 0xFFU] ^ table[5][low >> 16 & 0xFFU] ^ table[4][low >> 24] ^
                table[3][byteAt(bytes, i + 4)] ^ table[2][byteAt(bytes, i + 5)] ^ table[1][byteAt(bytes, i + 6)] ^
                table[0][byteAt(bytes, i + 7)];
    }
    for (; i < bytes.size(); ++i) { value = (value >> 8) ^ table[0][(value ^ byteAt(bytes, i)) & 0xFFU]; }
    return ~value;
}

} // namespace isph
