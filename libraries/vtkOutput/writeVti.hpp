#pragma once

#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"

#include <array>
#include <filesystem>
#include <span>
#include <string>

namespace isph
{

/// A field as ParaView shall see it. The values must outlive it.
struct ImageArray
{
    std::string name;
    const RealField* values = nullptr; ///< one component, or one for each active axis (written as three)

    /// What one period along each axis adds to a scalar; not 0 for the stream function of a mean flow.
    std::array<double, 3> periodGain{};
};

struct VtiFormat
{
    bool compressed = false;      ///< zlib
    bool singlePrecision = false; ///< float32
};

/// Writes an image (.vti, appended raw data) of point arrays on a lattice. The first plane of a periodic axis is
/// repeated at its end, so that there is no gap; an axis left out gets one plane. The file is complete or not there: it
/// is written under another name and renamed. \param time stored as TimeValue [s] \throws Error(input) naming the file
/// if the machine refuses.
void writeVti(const std::filesystem::path& file, const Lattice& lattice, double time,
              std::span<const ImageArray> arrays, const VtiFormat& format = {});

} // namespace isph
