#pragma once

#include "lattice/Axis.hpp"
#include "poisson/BoundedAxis.hpp"

namespace isph
{

/// The value at a place on an axis, points on and beyond its ends included, by those at its points and the data at its
/// ends (WallData):
///
///     sign phi(point) + lowPoint phi(first) + highPoint phi(last) + lowData data(low) + highData data(high)
struct MirrorImage
{
    int point = 0;
    double sign = 1;
    double lowPoint = 0; ///< where the end's value is that of a point
    double highPoint = 0;
    double lowData = 0;
    double highData = 0;
};

/// An axis continued by mirror particles: evenly about Neumann ends, plus the slope times the distance of both; oddly
/// about the value of Dirichlet ends. About the points of the ends (whole sample), or, staggered, half a spacing off
/// (half sample). Periodic axes repeat.
struct MirroredAxis
{
    /// \throws std::logic_error if the ends do not suit the axis; Error(input) without origin if there is no point
    /// between its walls
    MirroredAxis(const Axis& axis, AxisEnds ends);

    MirrorImage image(int place) const;

    /// Whether a point lies on an end where the value is given.
    bool fixed(int point) const;

    int count;
    double spacing; ///< [m]
    bool staggered;
    AxisEnds ends;
};

} // namespace isph
