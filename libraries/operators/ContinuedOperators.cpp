#include "operators/ContinuedOperators.hpp"

#include <algorithm>
#include <functional>
#include <optional>

namespace isph
{

ContinuedOperators::ContinuedOperators(const Lattice& lattice, const Continuations& continuations,
                                       const KernelSettings& kernel, PlanEffort effort)
    : scratch_(1, lattice.points())
{
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const Axis& axis = lattice.activeAxis(d);
        const auto& continuation = continuations[static_cast<std::size_t>(lattice.direction(d))];
        std::optional<LineContinuation> ends;
        if (continuation) { ends.emplace(*continuation, axis.count); }
        ContinuedTransform transform(linesAlong(lattice, lattice.direction(d)), std::move(ends), axis.spacing(),
                                     effort);
        const LineSymbol symbol = lineSymbol(kernel, transform.length(), axis.spacing());
        derivatives_.emplace_back(std::move(transform), symbol);
    }
}

void ContinuedOperators::gradient(const RealField& f, int component, RealField& gradient)
{
    for (int d = 0; d < gradient.components(); ++d) { derivative(d)(f[component], gradient[d], {}); }
}

void ContinuedOperators::divergence(const RealField& u, RealField& divergence)
{
    derivative(0)(u[0], divergence[0], {});
    for (int d = 1; d < u.components(); ++d)
    {
        derivative(d)(u[d], scratch_[0], {});
        std::ranges::transform(divergence[0], scratch_[0], divergence[0].begin(), std::plus<>());
    }
}

void ContinuedOperators::laplacian(const RealField& f, RealField& laplacian)
{
    for (int component = 0; component < f.components(); ++component)
    {
        derivative(0)(f[component], {}, laplacian[component]);
        for (std::size_t d = 1; d < derivatives_.size(); ++d)
        {
            derivatives_[d](f[component], {}, scratch_[0]);
            std::ranges::transform(laplacian[component], scratch_[0], laplacian[component].begin(), std::plus<>());
        }
    }
}

} // namespace isph
