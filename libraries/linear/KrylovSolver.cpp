#include "linear/KrylovSolver.hpp"

#include "fields/reductions.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace isph
{

namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A power of two near a magnitude, so that scaling by it rounds nothing.
double binaryScale(double magnitude) { return std::ldexp(1.0, std::clamp(std::ilogb(magnitude), -1000, 1000)); }

} // namespace

KrylovSolver::KrylovSolver(std::size_t size, KrylovSettings settings, KrylovSpace space)
    : settings_(settings),
      space_(space),
      totalWeight_(space.weights.empty() ? static_cast<double>(size) : sum(space.weights)),
      rhs_(size),
      residual_(size),
      best_(size)
{
    assert(space.weights.empty() || space.weights.size() == size);
}

double KrylovSolver::product(std::span<const double> a, std::span<const double> b) const
{
    return space_.weights.empty() ? sumOfProducts(a, b) : sumOfProducts(a, b, space_.weights);
}

double KrylovSolver::norm(std::span<const double> a) const { return std::sqrt(product(a, a)); }

void KrylovSolver::subtractMean(std::span<double> values) const
{
    if (!space_.constantNull) { return; }
    const double total = space_.weights.empty() ? sum(values) : sumOfProducts(values, space_.weights);
    const double mean = total / totalWeight_;
    for (double& value : values) { value -= mean; }
}

double KrylovSolver::residualOf(const LinearOperator& matrix, std::span<const double> x)
{
    matrix.apply(x, residual_);
    for (std::size_t i = 0; i < residual_.size(); ++i) { residual_[i] = rhs_[i] - residual_[i]; }
    return norm(residual_);
}

KrylovResult KrylovSolver::solve(const LinearOperator& matrix, const Preconditioner& preconditioner,
                                 std::span<const double> b, std::span<double> x)
{
    assert(b.size() == rhs_.size() && x.size() == rhs_.size());
    KrylovResult result;
    const double magnitude = largestMagnitude(b);
    if (!std::isfinite(magnitude))
    {
        std::ranges::fill(x, 0.0);
        result.initialResidual = result.finalResidual = std::numeric_limits<double>::quiet_NaN();
        result.converged = false;
        return result;
    }
    // Squares of very large or small numbers would leave the range of numbers.
    const double scale = magnitude > 0 ? binaryScale(magnitude) : 1;
    for (std::size_t i = 0; i < b.size(); ++i) { rhs_[i] = b[i] / scale; }
    const double whole = norm(rhs_);
    subtractMean(rhs_);
    const double reference = norm(rhs_);
    if (reference <= 4 * epsilon * whole)
    {
        std::ranges::fill(x, 0.0); // b was a constant, and what is left is round-off
        return result;
    }

    if (allFinite(x))
    {
        for (double& value : x) { value /= scale; }
    }
    else { std::ranges::fill(x, 0.0); }
    double residual = residualOf(matrix, x);
    if (!(residual <= reference))
    {
        std::ranges::fill(x, 0.0);
        std::ranges::copy(rhs_, residual_.begin());
        residual = reference;
    }
    result.initialResidual = residual / reference;

    const double target = settings_.tolerance * reference;
    // A recurrence falls on below the round-off of its source, where the true residual does not: there it drifts, and
    // would end with less than it had.
    const double asked = std::max(target, 4 * epsilon * reference);
    int failures = 0;
    while (residual > target && result.iterations < settings_.maxIterations && failures < 2)
    {
        std::ranges::copy(x, best_.begin());
        result.iterations +=
            iterate({matrix, preconditioner, asked, settings_.maxIterations - result.iterations}, x, residual_);
        double reached = residualOf(matrix, x);
        if (!(reached < residual))
        {
            std::ranges::copy(best_, x.begin());
            reached = residualOf(matrix, x);
        }
        if (reached > 0.5 * residual) { ++failures; }
        residual = reached;
    }
    result.finalResidual = residual / reference;
    result.converged = residual <= target;
    subtractMean(x);
    for (double& value : x) { value *= scale; }
    return result;
}

} // namespace isph
