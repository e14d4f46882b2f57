#include "poisson/pressureSolvers.hpp"

#include <array>

namespace isph
{

const Selection<PressureSolver>& pressureSolvers()
{
    static constexpr std::array<Selection<PressureSolver>::Variant, 4> table{{
        {"fft", "by transforms: exact, and the fastest", PressureSolver::fft},
        {"direct", "the diagonalised continuation operators, for verification; bounded axes", PressureSolver::direct},
        {"BiCGStab", "iteratively, the matrix of classical ISPH; for comparison", PressureSolver::biCGStab},
        {"CG", "the same matrix by conjugate gradients", PressureSolver::cg},
    }};
    static_assert(distinct(table));
    static constexpr Selection<PressureSolver> selection("solver of the pressure", table);
    return selection;
}

const Selection<Preconditioning>& preconditioners()
{
    static constexpr std::array<Selection<Preconditioning>::Variant, 2> table{{
        {"jacobi", "the inverse of the diagonal", Preconditioning::jacobi},
        {"none", "no preconditioner", Preconditioning::none},
    }};
    static_assert(distinct(table));
    static constexpr Selection<Preconditioning> selection("preconditioner", table);
    return selection;
}

} // namespace isph
