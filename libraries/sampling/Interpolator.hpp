#pragma once

#include "lattice/Lattice.hpp"
#include "sampling/Interpolation.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace isph
{

/// Coordinates of points, one array a direction [m].
using Points = std::array<std::vector<double>, 3>;

/// Takes values of a lattice to other points, one axis after the other.
///
/// An axis along which the points share their coordinates is summed up only once for all that share one, the axis with
/// the fewest first: n points on a line along an axis of an N x N x N lattice cost N^3 + N^2 + n N operations, n
/// anywhere n N^3 (spectral; linear and cubic n N^2).
class Interpolator
{
public:
    /// \throws Error(input) without origin if a point lies outside of the box along a bounded axis.
    Interpolator(const Lattice& lattice, const Points& points, Interpolation interpolation);

    std::size_t points() const { return order_.size(); }

    /// values[n] becomes the value at point n.
    void operator()(std::span<const double> field, std::span<double> values) const;

private:
    std::array<int, 3> counts_{};
    std::array<int, 3> axes_{0, 1, 2};                 ///< in the order of summing up
    std::array<std::vector<AxisStencil>, 3> stencils_; ///< by direction, one for each distinct coordinate
    std::array<std::vector<std::size_t>, 3> which_;    ///< by direction, the stencil of each point
    std::vector<std::size_t> order_;                   ///< points sorted so that sums are shared
};

} // namespace isph
