#include "fieldStore/seal.hpp"

#include "core/Error.hpp"
#include "fieldStore/checksum.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <fmt/format.h>
#include <fstream>
#include <string_view>
#include <system_error>
#include <vector>

namespace isph
{

namespace
{

constexpr std::string_view title = "Continua fields\n";
constexpr std::string_view hdf5Signature = "\x89HDF\r\n\x1a\n";

Seal makeSeal(std::uint64_t bytes, std::uint32_t checksum)
{
    Seal seal{};
    fmt::format_to_n(seal.data(), seal.size(), "{}bytes {}\ncrc32 {:08x} of the bytes behind the first {}\n", title,
                     bytes, checksum, sealSize);
    return seal;
}

bool startsWith(const Seal& seal, std::string_view text)
{
    return std::string_view(seal.data(), seal.size()).starts_with(text);
}

} // namespace

Seal sealOf(std::span<const char> contents) { return makeSeal(contents.size(), crc32(contents)); }

void verifySeal(const std::filesystem::path& file, const Origin& origin)
{
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    Seal seal{};
    in.read(seal.data(), sealSize);
    if (const int reason = errno; reason != 0 && in.gcount() == 0)
    {
        throw Error(Fault::input, origin, "cannot be read: " + std::generic_category().message(reason));
    }
    if (!startsWith(seal, title))
    {
        throw Error(Fault::input, origin,
                    startsWith(seal, hdf5Signature) ? "is an HDF5 file, but not one that this suite wrote"
                                                    : "is no file of fields, or its first bytes are damaged",
                    "files of fields are written by the solver, by mapFields and by fcExtend");
    }

    std::vector<char> piece(std::size_t{1} << 16);
    std::uint64_t bytes = 0;
    std::uint32_t checksum = 0;
    while (in)
    {
        in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
        const auto count = static_cast<std::size_t>(in.gcount());
        checksum = crc32(std::span(piece).first(count), checksum);
        bytes += count;
    }
    if (in.bad()) { throw Error(Fault::input, origin, "cannot be read to its end"); }
    if (seal != makeSeal(bytes, checksum))
    {
        throw Error(Fault::input, origin, "is damaged: it is not what was written (length or checksum differ)",
                    "take an earlier time, or a copy of this one");
    }
}

} // namespace isph
