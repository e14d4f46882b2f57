#pragma once

#include "poisson/BoundedAxis.hpp"

namespace isph
{

/// How data on the walls of an axis enter the modes of that axis, in closed form.
///
/// A function u'' = kappa^2 u with data d at an end obeys u(y-h) + u(y+h) = 2 cosh(kappa h) u(y) on the lattice, so its
/// discrete transform along the axis is exactly
///
///     d weight f(x) / (sinh^2 x + s^2),     x = kappa h/2,   s^2 = BoundedAxis::sine2,   weight = BoundedAxis::low,
///     high
///
/// with f = sinh x cosh x/x (Neumann) or 1 (Dirichlet), on staggered points sinh x/x or cosh x. Numerator and
/// denominator are multiplied by exp(-2x): nothing overflows, and kappa = 0 (where u'' is a constant that only the mean
/// mode sees) is the limit. All arrays run over the tangential modes.
///
/// The source's slope at Neumann walls and its value at Dirichlet ones make its series converge slowly. closure is what
/// solving for them in closed form changes: with B the polynomial that carries them, the modes of the solution for B
/// less the modes of B over the eigenvalues.
class WallResponse
{
public:
    /// \param kappa2 squared tangential wavenumbers [1/m^2]
    WallResponse(const BoundedAxis& axis, AlignedVector<double> kappa2);

    /// Multiplies the tangential modes of the data at an end by f exp(-2x).
    void scale(AlignedVector<double>& low, AlignedVector<double>& high) const;

    /// (sinh^2 x + s^2) exp(-2x) of tangential mode t.
    double denominator(std::size_t t, double sine2) const { return quarter_[t] + decay_[t] * sine2; }

    /// Factor of weight and of the source's slope or value at the low (high) end; mode i of the axis.
    double closureLow(std::size_t t, std::size_t i) const { return closure(t, i, low_); }
    double closureHigh(std::size_t t, std::size_t i) const { return closure(t, i, high_); }

private:
    struct OfEnd
    {
        AlignedVector<double> f;     ///< f exp(-2x)
        AlignedVector<double> slope; ///< (f - 1)/x^2 exp(-2x)
        AlignedVector<double> mean;  ///< closure for s = 0
    };

    OfEnd ofEnd(End end) const;
    double closure(std::size_t t, std::size_t i, const OfEnd& end) const;

    double spacing_;
    bool staggered_;
    AlignedVector<double> kappa2_;
    AlignedVector<double> decay_;     ///< exp(-2x)
    AlignedVector<double> quarter_;   ///< sinh^2 x exp(-2x)
    AlignedVector<double> relative2_; ///< (sinh x/x)^2 exp(-2x)
    AlignedVector<double> axisK2_;
    AlignedVector<double> axisSine2_;
    OfEnd low_;
    OfEnd high_;
};

} // namespace isph
