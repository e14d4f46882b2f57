#pragma once

#include "linear/KrylovSolver.hpp"

namespace isph
{

/// Preconditioned conjugate gradients (Hestenes & Stiefel 1952): for operators that are self-adjoint in the inner
/// product of the space and positive, but for constants. One product with the matrix an iteration.
class ConjugateGradient : public KrylovSolver
{
public:
    ConjugateGradient(std::size_t size, KrylovSettings settings, KrylovSpace space = {});

private:
    int iterate(const System& system, std::span<double> x, std::span<double> residual) override;

    AlignedVector<double> direction_;
    AlignedVector<double> image_; ///< of the direction
    AlignedVector<double> preconditioned_;
};

} // namespace isph
