#pragma once

#include "fields/AlignedAllocator.hpp"
#include "lattice/Axis.hpp"
#include "spectral/RealTransform.hpp"

#include <array>
#include <cstddef>
#include <functional>

namespace isph
{

/// What is known of the unknown at an end of an axis.
enum class End
{
    periodic,
    neumann,  ///< its derivative along the axis
    dirichlet ///< its value
};

struct AxisEnds
{
    End low = End::periodic;
    End high = End::periodic;
};

/// Minus the eigenvalue [1/m^2] of a second derivative along an axis: of wavenumber k [rad/m] and spacing [m].
using AxisSymbol = std::function<double(double k, double spacing)>;

/// The modes of one axis of a lattice under the conditions at its ends: cosines, sines, or a Fourier series.
struct BoundedAxis
{
    /// \throws std::logic_error if the ends do not suit the axis; Error(input) if it has too few points
    BoundedAxis(const Axis& axis, AxisEnds ends, const AxisSymbol& symbol);

    AxisEnds ends;
    bool staggered;
    double extent;      ///< [m]
    double spacing;     ///< [m]
    RealBasis basis;    ///< of the forward transform
    std::size_t points; ///< of the axis
    std::size_t first;  ///< first point that is unknown; modes are stored from there on
    std::size_t count;  ///< unknown points

    /// By point index; 0 where there is no mode.
    AlignedVector<double> k2;         ///< squared wavenumber [1/m^2]
    AlignedVector<double> eigenvalue; ///< minus that of the operator to be inverted [1/m^2]
    AlignedVector<double> sine2;      ///< squared sine of half the phase from point to point
    AlignedVector<double> low;        ///< how unit data at the low end enter, see WallResponse
    AlignedVector<double> high;

    bool bounded() const { return ends.low != End::periodic; }
    bool constantMode() const; ///< whether the constant satisfies the conditions

    /// Whether the low (high) end is a lattice point where the value is given.
    bool fixedLow() const { return ends.low == End::dirichlet && !staggered; }
    bool fixedHigh() const { return ends.high == End::dirichlet && !staggered; }
};

} // namespace isph
