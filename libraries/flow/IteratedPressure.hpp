#pragma once

#include "fieldStore/FieldReader.hpp"
#include "fieldStore/FieldWriter.hpp"
#include "flow/PressureRecord.hpp"
#include "kernels/KernelSettings.hpp"
#include "poisson/IterativePoisson.hpp"
#include "schemes/TimeScheme.hpp"

#include <utility>
#include <vector>

namespace isph
{

/// The pressure of a flow by IterativePoisson, and the record of its solves. Each substep starts from its own solution
/// in the last step: what substeps leave undone differs by their share of the step.
class IteratedPressure
{
public:
    /// \param kernel is sampled, whatever its symbol: a closed one with its own supportRadius
    /// \throws Error(input) without origin, see MorrisSystem and KernelSamples
    IteratedPressure(const Lattice& lattice, const KernelSettings& kernel, const std::array<AxisEnds, 3>& ends,
                     const IterationSettings& settings, const TimeScheme& scheme);

    /// A new substep: the first of a step or the next one.
    void begin(const Substep& substep);

    /// Forgets the last step.
    void stepBack() { std::swap(before_, last_); }

    /// As IterativePoisson::solve, from the solution of the last step, in a substep.
    double solve(const RealField& source, const WallData& walls, RealField& phi);

    /// The same off the steps: neither recorded, nor what a later solve starts from.
    double solveApart(const RealField& source, const WallData& walls, RealField& phi);

    /// What the next step starts from, for the same bits after a restart.
    void save(FieldWriter& writer) const;
    void restore(const FieldReader& reader); ///< what is not there stays as it is

    const PressureRecord& record() const { return record_; }

private:
    IterativePoisson poisson_;
    PressureRecord record_;
    std::vector<RealField> last_;   ///< solution by substep
    std::vector<RealField> before_; ///< in the step before the last one
    std::size_t substep_ = 0;
};

/// Memory of the matrix, of the vectors of an iteration and of what it starts from [bytes].
/// \param neighbours of a point, itself included
double iterationMemory(const Lattice& lattice, std::size_t neighbours, PressureSolver solver, const TimeScheme& scheme);

} // namespace isph
