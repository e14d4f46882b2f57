#pragma once

#include "linear/KrylovSolver.hpp"

namespace isph
{

/// Stabilised biconjugate gradients (van der Vorst 1992), preconditioned from the right, as Fourtakas et al. 2021 use
/// them: for any operator. Two products with the matrix an iteration, one where the half step already suffices.
class BiCGStab : public KrylovSolver
{
public:
    BiCGStab(std::size_t size, KrylovSettings settings, KrylovSpace space = {});

private:
    int iterate(const System& system, std::span<double> x, std::span<double> residual) override;

    AlignedVector<double> shadow_; ///< the first residual
    AlignedVector<double> direction_;
    AlignedVector<double> image_; ///< of the preconditioned direction
    AlignedVector<double> residualImage_;
    AlignedVector<double> preconditioned_;
    AlignedVector<double> preconditionedResidual_;
};

} // namespace isph
