#pragma once

#include "fieldStore/FieldWriter.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <unistd.h>

namespace isph::test
{

/// A folder of one test, gone with it.
class Scratch
{
public:
    Scratch()
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "fieldStoreXXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) { throw std::runtime_error("no temporary folder"); }
        folder_ = pattern;
    }
    ~Scratch() { std::filesystem::remove_all(folder_); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

private:
    std::filesystem::path folder_;
};

inline std::string bytesOf(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline void putBytes(const std::filesystem::path& file, const std::string& bytes)
{
    std::ofstream(file, std::ios::binary) << bytes;
}

inline Lattice lattice2D()
{
    return Lattice({Axis{'x', -0.5, 1, 6, Axis::Ends::periodic}, Axis{'y', 0.1, 1.0 / 3, 5, Axis::Ends::bounded, true},
                    Axis{'z', 0.25, 0, 1}},
                   {});
}

inline Lattice lattice3D(int nx, int ny, int nz)
{
    return Lattice({Axis{'x', 0, 1, nx}, Axis{'y', -1, 2, ny, Axis::Ends::bounded}, Axis{'z', 0, 3, nz}}, {});
}

/// Any bits at all, signalling NaN, infinities and denormals among them.
inline RealField anyBits(int components, std::size_t size, unsigned seed)
{
    std::mt19937_64 random(seed);
    RealField field(components, size);
    for (int c = 0; c < components; ++c)
    {
        for (double& value : field[c]) { value = std::bit_cast<double>(random()); }
    }
    return field;
}

inline bool sameBits(std::span<const double> a, std::span<const double> b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](double x, double y)
                      { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); });
}

/// A small file with everything in it.
inline void writeSmall(const std::filesystem::path& file)
{
    const Lattice lattice = lattice2D();
    FieldWriter writer(file, lattice);
    writer.write("U", "m/s", anyBits(2, lattice.points(), 1));
    writer.write("p", "m2/s2", anyBits(1, lattice.points(), 2));
    SpectralField modes(2, 20);
    for (int c = 0; c < 2; ++c)
    {
        for (std::size_t n = 0; n < modes.size(); ++n) { modes[c][n] = {0.1 * static_cast<double>(n), -1.0 / (c + 3)}; }
    }
    writer.writeState("U", modes);
    writer.writeState("pressure", anyBits(1, 7, 3));
    writer.close();
}

} // namespace isph::test
