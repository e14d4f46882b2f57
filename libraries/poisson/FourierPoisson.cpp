#include "poisson/FourierPoisson.hpp"

#include <utility>

namespace isph
{

FourierPoisson::FourierPoisson(const Lattice& lattice, AlignedVector<double> inverse, PlanEffort effort)
    : inverse_(std::move(inverse)), transform_(lattice, 1, effort), modes_(1, transform_.modes())
{
    // The transforms are not normalised: fold 1/points into the table.
    for (double& value : inverse_) { value /= static_cast<double>(transform_.points()); }
}

void FourierPoisson::solve(const RealField& source, RealField& phi)
{
    transform_.forward(source, modes_);
    const auto modes = modes_[0];
    for (std::size_t i = 0; i < modes.size(); ++i) { modes[i] *= -inverse_[i]; }
    transform_.backward(modes_, phi);
}

} // namespace isph
