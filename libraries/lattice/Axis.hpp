#pragma once

#include <cstddef>

namespace isph
{

/// One direction of a lattice.
struct Axis
{
    enum class Ends
    {
        periodic,
        bounded
    };

    char name = 'x';
    double origin = 0; ///< lower end [m]
    double extent = 0; ///< length [m]; 0 for an axis that is left out
    int count = 1;     ///< points
    Ends ends = Ends::periodic;
    bool staggered = false; ///< bounded axes: points half a spacing inside the walls instead of on both

    /// An axis with extent 0 and one point is left out of the problem: no component, no derivative.
    bool active() const { return extent > 0; }
    bool periodic() const { return ends == Ends::periodic; }

    /// Distance of neighbouring points [m]: extent/count, or extent/(count - 1) for points on both ends.
    double spacing() const
    {
        const int intervals = periodic() || staggered ? count : count - 1;
        return intervals > 0 ? extent / intervals : extent;
    }

    /// Coordinate of point i [m].
    double coordinate(int i) const
    {
        const double offset = !periodic() && staggered ? 0.5 : 0.0;
        return origin + (i + offset) * spacing();
    }

    bool operator==(const Axis&) const = default;
};

} // namespace isph
