#pragma once

#include "core/Selection.hpp"
#include "lattice/Axis.hpp"

#include <vector>

namespace isph
{

/// How values between lattice points are found.
enum class Interpolation
{
    spectral, ///< the Fourier series of the values, on bounded axes that of their continuation
    linear,   ///< two points an axis: order 2
    cubic,    ///< four points an axis (Lagrange), moved inwards at bounded ends: order 4
};

const Selection<Interpolation>& interpolations();

/// Weights of the points first, first + 1, ... of an axis (counted on around a periodic one).
struct AxisStencil
{
    int first = 0;
    std::vector<double> weights;
};

/// The weights that give the value at a coordinate; a lattice point has the weight 1 alone, and so its very value.
///
/// The Fourier series is Lagrange's form of the trigonometric interpolant (Berrut & Trefethen 2004, section 5): of all
/// interpolants the one with the lowest wavenumbers, with the Nyquist mode of an even count as a cosine. Along a
/// bounded axis it is that of the line with its new points (smoothGram, degree 4), order 5; up to the walls, half a
/// spacing outside of the points of a staggered axis. \param coordinate [m]; wrapped on a periodic axis, on a bounded
/// one within the box; any on an axis left out
AxisStencil axisStencil(const Axis& axis, double coordinate, Interpolation interpolation);

/// Whether a coordinate lies in the box, up to round-off; always on periodic axes and those left out.
bool inside(const Axis& axis, double coordinate);

} // namespace isph
