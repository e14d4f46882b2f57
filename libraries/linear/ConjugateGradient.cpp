#include "linear/ConjugateGradient.hpp"

#include <algorithm>

namespace isph
{

ConjugateGradient::ConjugateGradient(std::size_t size, KrylovSettings settings, KrylovSpace space)
    : KrylovSolver(size, settings, space), direction_(size), image_(size), preconditioned_(size)
{
}

int ConjugateGradient::iterate(const System& system, std::span<double> x, std::span<double> residual)
{
    system.preconditioner.apply(residual, preconditioned_);
    std::ranges::copy(preconditioned_, direction_.begin());
    double rz = product(residual, preconditioned_);
    int made = 0;
    while (made < system.iterations)
    {
        system.matrix.apply(direction_, image_);
        const double curvature = product(direction_, image_);
        // Not so for an operator that is not positive, nor where nothing is left.
        if (!(curvature > 0 && rz > 0)) { return made; }
        const double alpha = rz / curvature;
        for (std::size_t i = 0; i < x.size(); ++i)
        {
            x[i] += alpha * direction_[i];
            residual[i] -= alpha * image_[i];
        }
        ++made;
        if (norm(residual) <= system.target) { return made; }
        system.preconditioner.apply(residual, preconditioned_);
        const double next = product(residual, preconditioned_);
        const double beta = next / rz;
        rz = next;
        for (std::size_t i = 0; i < x.size(); ++i) { direction_[i] = preconditioned_[i] + beta * direction_[i]; }
    }
    return made;
}

} // namespace isph
