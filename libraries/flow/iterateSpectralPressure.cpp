#include "flow/SpectralFlow.hpp"

#include <algorithm>
#include <functional>

namespace isph
{

void SpectralFlow::makeIteration(PlanEffort effort)
{
    iterated_.emplace(lattice_, settings_.kernel, wallEnds(lattice_), *settings_.iteration, *settings_.time);
    pressureTransform_.emplace(lattice_, 1, effort);
    phiModes_ = SpectralField(1, derivative_.rows().modes());
    source_ = RealField(1, lattice_.points());
    phi_ = RealField(1, lattice_.points());
}

void SpectralFlow::gatherSource(const Stretch& modes, double period)
{
    Complex* source = phiModes_[0].data() + modes.first;
    std::fill_n(source, modes.length, Complex(0));
    for (std::size_t c = 0; c < static_cast<std::size_t>(lattice_.dimensions()); ++c)
    {
        for (std::size_t i = 0; i < modes.length; ++i)
        {
            const double d = modes.d[c][i] / period;
            const Complex u = modes.value[c][i];
            source[i] += Complex(-d * u.imag(), d * u.real());
        }
    }
}

void SpectralFlow::solveForPressure(const Substep& substep)
{
    // What dealiasing drops has no source..
    const ModeRows& rows = derivative_.rows();
    for (std::size_t row = 0; row < rows.count(); ++row)
    {
        clearRow(row, keptRow(row) ? retained_.length() : 0, phiModes_);
    }
    {
        const auto scope = timings_.scope(Phase::transforms);
        pressureTransform_->backward(phiModes_, source_);
    }
    {
        const auto scope = timings_.scope(Phase::poisson);
        iterated_->begin(substep);
        iterated_->solve(source_, {}, phi_);
    }
    const auto scope = timings_.scope(Phase::transforms);
    pressureTransform_->forward(phi_, phiModes_);
    const double scale = 1 / static_cast<double>(lattice_.points());
    for (Complex& mode : phiModes_[0]) { mode *= scale; }
}

void SpectralFlow::correctVelocity(const Substep& substep, double period)
{
    const ModeRows& rows = derivative_.rows();
    const int dimensions = lattice_.dimensions();
    alignas(64) double d[3][stretch];
    for (std::size_t row = 0; row < rows.count(); ++row)
    {
        const std::size_t kept = keptRow(row) ? retained_.length() : 0;
        for (std::size_t begin = 0; begin < kept; begin += stretch)
        {
            const std::size_t end = std::min(begin + stretch, kept);
            Stretch modes{.row = row, .begin = begin, .first = rows.offset(row) + begin, .length = end - begin};
            modes.d = {d[0], d[1], d[2]};
            for (int c = 0; c < dimensions; ++c)
            {
                modes.value[static_cast<std::size_t>(c)] = state_[c].data() + modes.first;
            }
            derivative_.row(row, begin, end, modes.d);
            subtractSlope(modes, period, phiModes_);
            if (settings_.incremental)
            {
                std::transform(phiModes_[0].data() + modes.first, phiModes_[0].data() + modes.first + modes.length,
                               pressureModes_[0].data() + modes.first, pressureModes_[0].data() + modes.first,
                               std::plus<>());
            }
            if (substep.last && !filterFactors_[0].empty()) { filterVelocity(modes); }
            if (!convection_) { continue; }
            for (int c = 0; c < dimensions; ++c)
            {
                std::copy_n(state_[c].data() + modes.first, modes.length, inputModes_[c].data() + modes.first);
            }
            convection_->deriveInputs({modes.first, modes.length, {d[0], d[1], d[2]}}, inputModes_);
        }
    }
}

} // namespace isph
