#pragma once

#include "lattice/Lattice.hpp"

#include <span>
#include <vector>

namespace isph
{

/// Weights [m] of the points of an axis in the integral over its extent; 1 for an axis that is left out.
///
/// Periodic axes: the spacing (spectral accuracy). Points on both ends: Gregory's end corrections up to the sixth
/// difference, all weights positive, order 8; with fewer than seven points the closed Newton-Cotes rule they leave.
/// A spike exp(-y/d) at a wall is off by 1e-5 for d of two spacings (trapezoidal rule: 2e-2). Staggered: the midpoint
/// rule, order 2.
std::vector<double> quadratureWeights(const Axis& axis);

/// The integral from the lower end of an axis to each of its points, and last to its upper end: of the polynomials
/// through the six points next to each interval, order 6 [m]. Along a periodic axis from its first point, once around.
std::vector<double> runningIntegral(const Axis& axis, std::span<const double> values);

/// Integrals over the box of values at its points, with the product of the weights of its axes [m^dimensions]. The same
/// bits every time.
class Quadrature
{
public:
    explicit Quadrature(const Lattice& lattice);

    double of(std::span<const double> values) const;
    double ofSquares(std::span<const double> values) const { return ofProducts(values, values); }
    double ofProducts(std::span<const double> a, std::span<const double> b) const;

private:
    template<class RowSum>
    double weighted(RowSum rowSum) const;

    bool uniform_;       ///< every point weighs the same
    double pointVolume_; ///< [m^dimensions]
    std::size_t points_;
    std::vector<double> alongRow_;  ///< weights along x
    std::vector<double> rowWeight_; ///< products of those along y and z
};

} // namespace isph
