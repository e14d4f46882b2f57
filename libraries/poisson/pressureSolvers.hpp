#pragma once

#include "core/Selection.hpp"
#include "linear/KrylovSolver.hpp"

namespace isph
{

/// How the pressure equation is solved.
enum class PressureSolver
{
    fft,      ///< by transforms
    direct,   ///< the diagonalised continuation operators
    biCGStab, ///< the matrix of classical ISPH, iteratively
    cg
};

const Selection<PressureSolver>& pressureSolvers();

/// Whether a solver needs the matrix.
inline bool iterative(PressureSolver solver)
{
    return solver == PressureSolver::biCGStab || solver == PressureSolver::cg;
}

enum class Preconditioning
{
    jacobi,
    none
};

const Selection<Preconditioning>& preconditioners();

/// Every choice of an iterative solution.
struct IterationSettings
{
    PressureSolver solver = PressureSolver::biCGStab;
    Preconditioning preconditioner = Preconditioning::jacobi;
    KrylovSettings krylov{};
};

} // namespace isph
