#include "poisson/IterativePoisson.hpp"

#include "linear/BiCGStab.hpp"
#include "linear/ConjugateGradient.hpp"

#include <stdexcept>

namespace isph
{

IterativePoisson::IterativePoisson(const Lattice& lattice, const KernelSamples& samples,
                                   const std::array<AxisEnds, 3>& ends, const IterationSettings& settings)
    : system_(std::make_unique<MorrisSystem>(lattice, samples, ends)), rhs_(lattice.points())
{
    if (!iterative(settings.solver)) { throw std::logic_error("IterativePoisson: not an iterative solver"); }
    const std::size_t points = lattice.points();
    const KrylovSpace space{system_->weights(), system_->constantMode()};
    if (settings.solver == PressureSolver::cg)
    {
        solver_ = std::make_unique<ConjugateGradient>(points, settings.krylov, space);
    }
    else { solver_ = std::make_unique<BiCGStab>(points, settings.krylov, space); }
    if (settings.preconditioner == Preconditioning::jacobi)
    {
        preconditioner_ = std::make_unique<JacobiPreconditioner>(system_->matrix().diagonal());
    }
    else { preconditioner_ = std::make_unique<IdentityPreconditioner>(); }
}

double IterativePoisson::solve(const RealField& source, const WallData& walls, RealField& phi)
{
    const double unbalanced = system_->rightHandSide(source[0], walls, rhs_);
    result_ = solver_->solve(system_->matrix(), *preconditioner_, rhs_, phi[0]);
    return unbalanced;
}

} // namespace isph
