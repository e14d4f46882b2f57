#pragma once

#include "poisson/MorrisSystem.hpp"
#include "spectral/RealTransform.hpp"

#include <vector>

namespace isph
{

/// Solves the system of IterativePoisson by real transforms. Mirror particles make the modes of a box, cosines, sines
/// and Fourier series, eigenvectors of the Morris Laplacian, with the eigenvalues sum_b w_b prod_d cos(k_d x_bd): one
/// table for all axes together, as the kernel is round.
class MirroredPoisson
{
public:
    /// \param samples with LaplacianForm::morris \throws Error(input) without origin if an axis has too few points
    MirroredPoisson(const Lattice& lattice, const KernelSamples& samples, const std::array<AxisEnds, 3>& ends,
                    PlanEffort effort = PlanEffort::estimated);

    /// As IterativePoisson::solve; phi is not read.
    double solve(const RealField& source, const WallData& walls, RealField& phi);

private:
    MirrorData data_;
    std::vector<RealTransform> transforms_;
    AlignedVector<double> inverse_; ///< 1/eigenvalue by mode, transforms normalised; 0 where there is no mode
    std::vector<double> given_;     ///< at the points whose value is
};

} // namespace isph
