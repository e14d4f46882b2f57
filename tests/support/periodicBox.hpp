#pragma once

#include "lattice/Lattice.hpp"

#include <array>

namespace isph::test
{

/// A periodic box with corner at origin; an extent of 0 leaves the axis out.
inline Lattice periodicBox(std::array<int, 3> counts, std::array<double, 3> extents,
                           std::array<double, 3> origin = {0, 0, 0})
{
    std::array<Axis, 3> axes;
    constexpr std::array<char, 3> names{'x', 'y', 'z'};
    for (std::size_t d = 0; d < 3; ++d)
    {
        axes[d] = {.name = names[d], .origin = origin[d], .extent = extents[d], .count = counts[d]};
    }
    return Lattice(axes, {});
}

inline Lattice unitSquare(int n) { return periodicBox({n, n, 1}, {1, 1, 0}); }
inline Lattice unitCube(int n) { return periodicBox({n, n, n}, {1, 1, 1}); }

} // namespace isph::test
