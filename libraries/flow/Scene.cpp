#include "flow/Scene.hpp"

#include "core/Error.hpp"
#include "flow/BoundedFlow.hpp"
#include "flow/PhysicalFlow.hpp"
#include "flow/readFlowSettings.hpp"
#include "flow/readFluid.hpp"
#include "flow/SpectralFlow.hpp"
#include "lattice/readLattice.hpp"

#include <utility>
#include <vector>

namespace isph
{

Scene::Scene(const Case& flowCase, const std::string& time)
    : lattice(readLattice(flowCase.dictionary("constant/lattice"))),
      fluid(readFluid(flowCase, lattice)),
      settings(readFlowSettings(flowCase.dictionary("system/schemes"), flowCase.dictionary("system/solution"), lattice,
                                fluid)),
      files(readFlowFiles(flowCase, time, lattice, fluid)),
      boundary(readFlowBoundary(flowCase, time, lattice, fluid, files))
{
}

namespace
{

/// Schemes that do not go together on this lattice, as only their making shows, are told with their file.
std::unique_ptr<IncompressibleFlow> makeBoundedFlow(Scene& scene, Timings& timings, PlanEffort effort)
{
    try
    {
        return std::make_unique<BoundedFlow>(scene.lattice, scene.fluid, scene.settings, scene.boundary, timings,
                                             effort);
    }
    catch (const Error& error)
    {
        std::vector<Complaint> complaints = error.complaints();
        for (Complaint& complaint : complaints)
        {
            if (complaint.origin.file.empty()) { complaint.origin.file = "system/schemes"; }
        }
        throw Error(error.fault(), std::move(complaints));
    }
}

} // namespace

std::unique_ptr<IncompressibleFlow> makeFlow(Scene& scene, Timings& timings, PlanEffort effort)
{
    if (!scene.lattice.periodic()) { return makeBoundedFlow(scene, timings, effort); }
    if (scene.settings.directSum)
    {
        return std::make_unique<PhysicalFlow>(scene.lattice, scene.fluid, scene.settings, timings);
    }
    return std::make_unique<SpectralFlow>(scene.lattice, scene.fluid, scene.settings, timings, effort);
}

} // namespace isph
