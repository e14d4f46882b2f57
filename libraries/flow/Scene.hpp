#pragma once

#include "boundary/FlowBoundary.hpp"
#include "case/Case.hpp"
#include "core/Timings.hpp"
#include "flow/FlowSettings.hpp"
#include "flow/Fluid.hpp"
#include "flow/IncompressibleFlow.hpp"
#include "flow/readFlow.hpp"
#include "lattice/Lattice.hpp"

#include <memory>

namespace isph
{

/// Everything a case says about its flow but the values of the fields: points, fluid, schemes, boundary conditions.
struct Scene
{
    /// Reads constant/, system/schemes, system/solution and the dictionaries of a time's fields.
    /// \throws Error(input) for whatever is wrong there.
    Scene(const Case& flowCase, const std::string& time);

    Lattice lattice;
    Fluid fluid;
    FlowSettings settings;
    FlowFiles files;
    FlowBoundary boundary; ///< with the data of the time that was read
};

/// The flow of a scene: in Fourier space, at the points for neighbour summation, or between walls, where it keeps the
/// boundary at the time it has come to. The scene must outlive it.
std::unique_ptr<IncompressibleFlow> makeFlow(Scene& scene, Timings& timings, PlanEffort effort = PlanEffort::measured);

} // namespace isph
