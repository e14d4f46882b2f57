#pragma once

#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"
#include "spectral/FourierTransform.hpp"
#include "spectral/Wavenumbers.hpp"

#include <array>
#include <complex>

namespace isph
{

/// Fields that follow from a velocity on a periodic lattice, with the exact derivatives of its Fourier series.
///
/// On a lattice with two axes a, b (in the order x y z) the vorticity is its one component normal to them.
class VelocityDerivatives
{
public:
    /// Transforms U [m/s].
    /// \throws Error(input) if the lattice is not periodic along every axis.
    VelocityDerivatives(const RealField& U, const Lattice& lattice);

    /// curl U [1/s]: one component in two dimensions, three in three.
    RealField vorticity();

    /// div U [1/s].
    RealField divergence();

    /// Second invariant of the velocity gradient, (div(U)^2 - tr(grad U grad U))/2 [1/s2]: above 0 where rotation
    /// prevails over strain (Hunt, Wray and Moin 1988).
    RealField Q();

    /// psi with U_a = dpsi/db, U_b = -dpsi/da [m2/s], 0 on average but for the part of a mean flow, which is 0 at the
    /// first point. Only in two dimensions.
    RealField streamFunction();

    /// What one period along x, y and z adds to the stream function: not 0 where there is a mean flow.
    std::array<double, 3> streamFunctionGain() const;

private:
    using Mode = std::complex<double>;

    /// The field whose modes are coefficient(index of the mode, wavenumbers along the active axes).
    template<class Coefficient>
    RealField field(Coefficient coefficient);

    const Lattice lattice_;
    const Wavenumbers wavenumbers_;
    FourierTransform transform_; ///< of one component
    SpectralField modes_;        ///< of U, normalised
    SpectralField scratch_;
};

} // namespace isph
