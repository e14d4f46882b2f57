#include "linear/BiCGStab.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isph
{

namespace
{

/// Whether a product of vectors is lost in the round-off of its terms; also where it is no number.
bool vanishes(double product, double normA, double normB)
{
    return !(std::abs(product) > std::numeric_limits<double>::epsilon() * normA * normB);
}

} // namespace

BiCGStab::BiCGStab(std::size_t size, KrylovSettings settings, KrylovSpace space)
    : KrylovSolver(size, settings, space),
      shadow_(size),
      direction_(size),
      image_(size),
      residualImage_(size),
      preconditioned_(size),
      preconditionedResidual_(size)
{
}

int BiCGStab::iterate(const System& system, std::span<double> x, std::span<double> residual)
{
    std::ranges::copy(residual, shadow_.begin());
    std::ranges::copy(residual, direction_.begin());
    const double shadowNorm = norm(shadow_);
    double rho = product(shadow_, residual);
    int made = 0;
    while (made < system.iterations)
    {
        system.preconditioner.apply(direction_, preconditioned_);
        system.matrix.apply(preconditioned_, image_);
        const double along = product(shadow_, image_);
        if (vanishes(along, shadowNorm, norm(image_))) { return made; }
        const double alpha = rho / along;
        for (std::size_t i = 0; i < x.size(); ++i)
        {
            x[i] += alpha * preconditioned_[i];
            residual[i] -= alpha * image_[i];
        }
        ++made;
        const double half = norm(residual);
        if (half <= system.target || !std::isfinite(half)) { return made; }

        system.preconditioner.apply(residual, preconditionedResidual_);
        system.matrix.apply(preconditionedResidual_, residualImage_);
        const double imageNorm2 = product(residualImage_, residualImage_);
        const double overlap = product(residualImage_, residual);
        if (vanishes(overlap, std::sqrt(imageNorm2), half)) { return made; }
        const double omega = overlap / imageNorm2;
        for (std::size_t i = 0; i < x.size(); ++i)
        {
            x[i] += omega * preconditionedResidual_[i];
            residual[i] -= omega * residualImage_[i];
        }
        const double reached = norm(residual);
        if (reached <= system.target) { return made; }
        const double next = product(shadow_, residual);
        if (vanishes(next, shadowNorm, reached)) { return made; }
        const double beta = (next / rho) * (alpha / omega);
        rho = next;
        for (std::size_t i = 0; i < x.size(); ++i)
        {
            direction_[i] = residual[i] + beta * (direction_[i] - omega * image_[i]);
        }
    }
    return made;
}

} // namespace isph
