#pragma once

#include "linear/LinearOperator.hpp"
#include "linear/Preconditioner.hpp"

#include <span>

namespace isph
{

/// When an iteration ends.
struct KrylovSettings
{
    double tolerance = 1e-10; ///< of ||b - A x||/||b||
    int maxIterations = 1000;
};

/// The space of a system.
struct KrylovSpace
{
    /// Of the inner product sum w_i x_i y_i, positive; empty: all 1. One in which the operator is self-adjoint, as
    /// conjugate gradients need it. Must outlive the solver.
    std::span<const double> weights{};

    /// Whether A sends constants to zero: the mean (by weights) of b, which A cannot make, is taken out of it, and that
    /// of the solution is zero.
    bool constantNull = false;
};

/// What an iteration did. Residuals are those of the solution, b - A x computed anew, relative to b.
struct KrylovResult
{
    int iterations = 0;
    double initialResidual = 0;
    double finalResidual = 0;
    bool converged = true;
};

/// Solves A x = b iteratively. Workspaces are made once; a solve allocates nothing.
///
/// Iterations are our own and not Eigen's, whose solvers allocate their vectors in every solve, know no null space and
/// no weights, and report the residual of the recurrence. Where a recurrence breaks down, or what it takes for
/// converged is not, it starts anew from the true residual. The solution is never worse than the start value, and
/// finite.
class KrylovSolver
{
public:
    virtual ~KrylovSolver() = default;

    /// \param b if not finite, x becomes 0 and the result says that nothing converged
    /// \param x start value, then the solution; one that is worse than 0 or not finite is not used
    KrylovResult solve(const LinearOperator& matrix, const Preconditioner& preconditioner, std::span<const double> b,
                       std::span<double> x);

protected:
    KrylovSolver(std::size_t size, KrylovSettings settings, KrylovSpace space);

    /// What derived classes iterate on.
    struct System
    {
        const LinearOperator& matrix;
        const Preconditioner& preconditioner;
        double target;  ///< norm of the residual to be reached
        int iterations; ///< left
    };

    /// Improves x from its residual on until the residual of the recurrence meets the target, iterations are spent, or
    /// the recurrence breaks down. \return iterations made
    virtual int iterate(const System& system, std::span<double> x, std::span<double> residual) = 0;

    double product(std::span<const double> a, std::span<const double> b) const;
    double norm(std::span<const double> a) const;

private:
    void subtractMean(std::span<double> values) const;
    double residualOf(const LinearOperator& matrix, std::span<const double> x);

    KrylovSettings settings_;
    KrylovSpace space_;
    double totalWeight_;
    AlignedVector<double> rhs_;
    AlignedVector<double> residual_;
    AlignedVector<double> best_;
};

} // namespace isph
