#pragma once

#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"
#include "lattice/LatticeFace.hpp"
#include "operators/ContinuedOperators.hpp"

#include <span>
#include <vector>

namespace isph
{

/// Fields that follow from a velocity [m/s] by exact derivatives: those of its Fourier series along periodic axes, of
/// its Fourier continuation (smoothGram, degree 4) along bounded ones, at all points, those on walls included.
///
/// On a lattice with two axes a, b (in the order x y z) the vorticity is its one component normal to them.
class VelocityDerivatives
{
public:
    explicit VelocityDerivatives(const Lattice& lattice);

    /// Derivative of one component of a field along the d-th active axis, overwritten.
    void derivative(int d, std::span<const double> values, std::span<double> result)
    {
        operators_.derivative(d)(values, result, {});
    }

    /// dU_component/dx along the d-th active axis [1/s], overwritten. Along a wall that is not flowed through, zero:
    /// the points it shares with a moving wall are a jump that would ring all along it.
    void derivative(const RealField& U, int component, int d, std::span<double> result);

    /// Components of the vorticity: one in two dimensions, three in three.
    int vorticityComponents() const { return lattice_.dimensions() == 2 ? 1 : 3; }

    /// curl U [1/s], overwritten.
    void vorticity(const RealField& U, RealField& vorticity);
    RealField vorticity(const RealField& U);

    /// div U [1/s].
    RealField divergence(const RealField& U);

    /// Second invariant of the velocity gradient, (div(U)^2 - tr(grad U grad U))/2 [1/s2]: above 0 where rotation
    /// prevails over strain (Hunt, Wray and Moin 1988).
    RealField Q(const RealField& U);

private:
    Lattice lattice_;
    ContinuedOperators operators_;
    std::vector<LatticeFace> faces_; ///< at bounded ends
    RealField scratch_;
};

/// Whether a velocity leads through a face: points that it shares with others, which may belong to a moving wall, do
/// not count.
bool flowsThrough(const LatticeFace& face, std::span<const double> normalVelocity);

/// +1 where the normal of the active axes a, b of a plane completes a, b, n to a right-handed set, -1 for x and z.
double normalSign(const Lattice& lattice);

} // namespace isph
