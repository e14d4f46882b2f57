#include "linear/Preconditioner.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace isph
{

void IdentityPreconditioner::apply(std::span<const double> r, std::span<double> z) const
{
    std::ranges::copy(r, z.begin());
}

JacobiPreconditioner::JacobiPreconditioner(AlignedVector<double> diagonal) : inverse_(std::move(diagonal))
{
    for (double& value : inverse_)
    {
        value = 1 / value;
        if (!std::isfinite(value) || value == 0) { value = 1; }
    }
}

void JacobiPreconditioner::apply(std::span<const double> r, std::span<double> z) const
{
    std::ranges::transform(r, inverse_, z.begin(), std::multiplies{});
}

} // namespace isph
