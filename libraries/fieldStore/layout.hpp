#pragma once

#include "fieldStore/Hdf5Handle.hpp"

#include "lattice/Lattice.hpp"

#include <complex>
#include <vector>

namespace isph::layout
{

// What a file of fields is made of; docs/howto/readFields.md tells users. Internal to fieldStore.

inline constexpr int formatVersion = 1;

// Attributes of the file (its root group).
inline constexpr const char* formatVersionName = "formatVersion";
inline constexpr const char* programName = "program";
inline constexpr const char* originName = "origin";
inline constexpr const char* extentName = "extent";
inline constexpr const char* spacingName = "spacing";
inline constexpr const char* countName = "count";
inline constexpr const char* periodicName = "periodic";
inline constexpr const char* staggeredName = "staggered";

/// Attribute of each field.
inline constexpr const char* unitName = "unit";

/// Group of the marching state.
inline constexpr const char* stateName = "state";

/// A complex number as h5py knows it: a compound of the doubles r and i.
inline Hdf5Handle complexType()
{
    Hdf5Handle type(H5Tcreate(H5T_COMPOUND, sizeof(std::complex<double>)), H5Tclose);
    H5Tinsert(type, "r", 0, H5T_IEEE_F64LE);
    H5Tinsert(type, "i", sizeof(double), H5T_IEEE_F64LE);
    return type;
}

/// [nz][ny][nx], and [3] for a vector.
inline std::vector<hsize_t> extentsOf(const Lattice& lattice, bool vector)
{
    std::vector<hsize_t> extents;
    for (const int direction : {2, 1, 0}) { extents.push_back(static_cast<hsize_t>(lattice.axis(direction).count)); }
    if (vector) { extents.push_back(3); }
    return extents;
}

} // namespace isph::layout
