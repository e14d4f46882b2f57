#include "flow/IteratedPressure.hpp"

#include "fields/fieldOperations.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace isph
{

IteratedPressure::IteratedPressure(const Lattice& lattice, const KernelSettings& kernel,
                                   const std::array<AxisEnds, 3>& ends, const IterationSettings& settings,
                                   const TimeScheme& scheme)
    : poisson_(lattice, KernelSamples(lattice, kernel, LaplacianForm::morris), ends, settings)
{
    record_.name = pressureSolvers().nameOf(settings.solver);
    for (std::size_t n = 0; n < scheme.substeps.size(); ++n)
    {
        last_.emplace_back(1, lattice.points());
        before_.emplace_back(1, lattice.points());
    }
}

void IteratedPressure::begin(const Substep& substep)
{
    if (substep.first) { std::swap(before_, last_); }
    substep_ = substep.first ? 0 : substep_ + 1;
}

double IteratedPressure::solve(const RealField& source, const WallData& walls, RealField& phi)
{
    copyInto(before_[substep_], phi);
    const double unbalanced = poisson_.solve(source, walls, phi);
    copyInto(phi, last_[substep_]);

    const KrylovResult& result = poisson_.result();
    ++record_.solves;
    record_.iterations += result.iterations;
    record_.mostIterations = std::max(record_.mostIterations, result.iterations);
    // Of what is no number the guard of the step tells.
    if (result.finalResidual > record_.largestResidual) { record_.largestResidual = result.finalResidual; }
    if (!result.converged) { ++record_.unconverged; }
    record_.last = result;
    return unbalanced;
}

double IteratedPressure::solveApart(const RealField& source, const WallData& walls, RealField& phi)
{
    copyInto(last_.back(), phi);
    return poisson_.solve(source, walls, phi);
}

void IteratedPressure::save(FieldWriter& writer) const
{
    for (std::size_t n = 0; n < last_.size(); ++n) { writer.writeState(fmt::format("lastPhi{}", n), last_[n]); }
}

void IteratedPressure::restore(const FieldReader& reader)
{
    for (std::size_t n = 0; n < last_.size(); ++n)
    {
        const std::string name = fmt::format("lastPhi{}", n);
        if (reader.hasState(name)) { reader.readState(name, last_[n]); }
    }
}

double iterationMemory(const Lattice& lattice, std::size_t neighbours, PressureSolver solver, const TimeScheme& scheme)
{
    // Vectors of every iteration, its own, right-hand side, diagonal, and the beginnings of rows; start values, those
    // of the step before, and in the file.
    const double vectors =
        (solver == PressureSolver::cg ? 8.5 : 11.5) + 3 * static_cast<double>(scheme.substeps.size());
    return morrisSystemBytes(lattice, neighbours) + mirrorDataBytes(lattice, neighbours) +
           8 * vectors * static_cast<double>(lattice.points());
}

} // namespace isph
