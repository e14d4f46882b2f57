#pragma once

#include "poisson/MorrisSystem.hpp"
#include "poisson/pressureSolvers.hpp"

#include <memory>

namespace isph
{

/// Solves lap phi = source as classical ISPH does: the matrix of the Morris Laplacian (MorrisSystem), iteratively, from
/// the phi that is given. The independent check of the solvers by transforms, and what their speed is measured against.
///
/// \see docs/theory/iterativePressure.md
class IterativePoisson
{
public:
    /// \param samples with LaplacianForm::morris \throws Error(input) without origin, see MorrisSystem
    IterativePoisson(const Lattice& lattice, const KernelSamples& samples, const std::array<AxisEnds, 3>& ends,
                     const IterationSettings& settings);

    /// \param phi start value (the last solution, say), then the solution; without a Dirichlet end its mean (half
    /// weight on walls) is zero
    /// \return by how much the mean of the source exceeds what flows through the walls, which no phi can balance and
    /// which is taken from the source; 0 with a Dirichlet end
    double solve(const RealField& source, const WallData& walls, RealField& phi);
    void solve(const RealField& source, RealField& phi) { solve(source, {}, phi); }

    /// Of the last solve.
    const KrylovResult& result() const { return result_; }

private:
    std::unique_ptr<MorrisSystem> system_; ///< where its weights stay when this moves
    std::unique_ptr<KrylovSolver> solver_;
    std::unique_ptr<Preconditioner> preconditioner_;
    AlignedVector<double> rhs_;
    KrylovResult result_;
};

} // namespace isph
