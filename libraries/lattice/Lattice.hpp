#pragma once

#include "lattice/Axis.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace isph
{

/// A named part of the boundary: one or more faces of the box.
struct Patch
{
    enum class Type
    {
        periodic,
        wall,
        patch
    };

    std::string name;
    Type type = Type::periodic;
    std::vector<std::string> faces; ///< any of xMin xMax yMin yMax zMin zMax

    bool operator==(const Patch&) const = default;
};

/// The points of a problem: a uniform lattice in a box, x fastest (n = ix + nx*(iy + ny*iz)). A regular value type.
class Lattice
{
public:
    Lattice() = default;

    /// \param axes x, y, z in this order
    /// \throws Error(input) unless at least two axes are active.
    Lattice(std::array<Axis, 3> axes, std::vector<Patch> patches);

    /// x, y or z (0, 1, 2).
    const Axis& axis(int direction) const { return axes_[static_cast<std::size_t>(direction)]; }

    /// Number of active axes, 2 or 3: as many components has a velocity.
    int dimensions() const { return dimensions_; }

    /// The direction (0, 1, 2) of the d-th active axis.
    int direction(int d) const { return directions_[static_cast<std::size_t>(d)]; }
    const Axis& activeAxis(int d) const { return axis(direction(d)); }

    std::size_t points() const;

    /// Volume of a point: product of the spacings of the active axes [m^dimensions].
    double pointVolume() const;

    bool periodic() const;  ///< in every active direction
    bool staggered() const; ///< the points of a bounded axis lie half a spacing inside

    const std::vector<Patch>& patches() const { return patches_; }

    /// Coordinates of all points in storage order, one array a direction (three, also for axes left out).
    std::array<std::vector<double>, 3> coordinates() const;

    bool operator==(const Lattice&) const = default;

private:
    std::array<Axis, 3> axes_{};
    std::array<int, 3> directions_{};
    int dimensions_ = 0;
    std::vector<Patch> patches_;
};

} // namespace isph
