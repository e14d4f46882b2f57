#pragma once

#include "lattice/Lattice.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace isph
{

/// One face of the box, at a bounded axis: where it is, what its points weigh, and the values of fields on it.
///
/// Its points are the lattice's own where these lie on both ends. On a staggered axis they are the feet of the points
/// next to the face, and values there those of the polynomial through the next four points (order 4).
class LatticeFace
{
public:
    /// \param direction x, y, z: 0, 1, 2
    /// \param upper whether it is the face at the upper end
    LatticeFace(const Lattice& lattice, int direction, bool upper);

    int direction() const { return direction_; }
    double outward() const { return upper_ ? 1 : -1; } ///< component of the outward normal along the direction
    std::size_t points() const { return points_.size(); }

    /// Coordinates of its points, one array a direction [m].
    const std::array<std::vector<double>, 3>& coordinates() const { return coordinates_; }

    /// What each point weighs in an integral over the face [m^(dimensions - 1)].
    const std::vector<double>& weights() const { return weights_; }

    /// Indices in a field of its points that are on no other face; none on a staggered axis, whose points are inside.
    const std::vector<std::size_t>& innerPoints() const { return innerPoints_; }

    /// Values on the face of one component of a field.
    void values(std::span<const double> field, std::span<double> onFace) const;

private:
    int direction_;
    bool upper_;
    std::vector<std::size_t> points_; ///< of the lattice, on the face or next to it
    std::vector<std::size_t> innerPoints_;
    std::ptrdiff_t inward_;             ///< from a point to the next one inside
    std::vector<double> extrapolation_; ///< weights of the points from the face inwards
    std::array<std::vector<double>, 3> coordinates_;
    std::vector<double> weights_;
};

/// The faces of a patch.
std::vector<LatticeFace> facesOf(const Patch& patch, const Lattice& lattice);

/// The faces at all bounded ends.
std::vector<LatticeFace> boundedFaces(const Lattice& lattice);

} // namespace isph
