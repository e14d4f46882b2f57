#pragma once

#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"
#include "sampling/Interpolator.hpp"

#include <random>

namespace isph::test
{

/// Periodic in x, bounded in y, and z as asked for; spacings that differ.
inline Lattice mixedLattice(int nx, int ny, int nz, bool staggered = false)
{
    const Axis z = nz == 1 ? Axis{'z', 0, 0, 1} : Axis{'z', 2, 0.5, nz};
    return Lattice({Axis{'x', -1, 2, nx}, Axis{'y', 0.25, 1, ny, Axis::Ends::bounded, staggered}, z}, {});
}

inline Lattice periodicLattice(int nx, int ny, int nz)
{
    const Axis z = nz == 1 ? Axis{'z', 0, 0, 1} : Axis{'z', 2, 0.5, nz};
    return Lattice({Axis{'x', -1, 2, nx}, Axis{'y', 0.25, 1, ny}, z}, {});
}

template<class Function>
RealField fieldOf(const Lattice& lattice, Function f)
{
    RealField field(1, lattice.points());
    const Points points = lattice.coordinates();
    for (std::size_t n = 0; n < field.size(); ++n) { field[0][n] = f(points[0][n], points[1][n], points[2][n]); }
    return field;
}

/// Points anywhere in the box, and beyond it along periodic axes.
inline Points randomPoints(const Lattice& lattice, std::size_t count, unsigned seed)
{
    std::mt19937 random(seed);
    Points points;
    for (std::size_t d = 0; d < 3; ++d)
    {
        const Axis& axis = lattice.axis(static_cast<int>(d));
        const double beyond = axis.periodic() ? 2 * axis.extent : 0;
        std::uniform_real_distribution<double> anywhere(axis.origin - beyond, axis.origin + axis.extent + beyond);
        for (std::size_t n = 0; n < count; ++n) { points[d].push_back(anywhere(random)); }
    }
    return points;
}

inline std::vector<double> interpolated(const Lattice& lattice, const RealField& field, const Points& points,
                                        Interpolation interpolation)
{
    const Interpolator interpolator(lattice, points, interpolation);
    std::vector<double> values(interpolator.points());
    interpolator(field[0], values);
    return values;
}

} // namespace isph::test
