#pragma once

#include "caseFields/VelocityDerivatives.hpp"
#include "lattice/LatticeFace.hpp"

#include <span>
#include <vector>

namespace isph
{

/// Gradients of a velocity on faces of the box, by exact derivatives of the continued lines; on staggered axes carried
/// on to the face.
class FaceGradients
{
public:
    FaceGradients(const Lattice& lattice, std::vector<LatticeFace> faces);

    const std::vector<LatticeFace>& faces() const { return faces_; }

    /// Differentiates a velocity; what follows is of it.
    void differentiate(const RealField& U);

    /// Components of the vorticity [1/s] on a face, as VelocityDerivatives has them.
    RealField vorticity(std::size_t face) const;

    /// (grad U + grad U^T) n [1/s], n outwards, along the active axes: times nu the viscous traction on the fluid.
    RealField tractionRate(std::size_t face) const;

private:
    std::span<const double> gradient(std::size_t face, int component, int along) const
    {
        return gradients_[face][component * lattice_.dimensions() + along];
    }

    Lattice lattice_;
    std::vector<LatticeFace> faces_;
    VelocityDerivatives derivatives_;
    RealField scratch_;
    std::vector<RealField> gradients_; ///< of each face: dU_i/dx_j as component i*dimensions + j
};

} // namespace isph
