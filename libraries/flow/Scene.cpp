#include "flow/Scene.hpp"

#include "flow/BoundedFlow.hpp"
#include "flow/PhysicalFlow.hpp"
#include "flow/readFlowSettings.hpp"
#include "flow/readFluid.hpp"
#include "flow/SpectralFlow.hpp"
#include "lattice/readLattice.hpp"

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

std::unique_ptr<IncompressibleFlow> makeFlow(Scene& scene, Timings& timings, PlanEffort effort)
{
    if (!scene.lattice.periodic())
    {
        return std::make_unique<BoundedFlow>(scene.lattice, scene.fluid, scene.settings, scene.boundary, timings,
                                             effort);
    }
    if (scene.settings.directSum)
    {
        return std::make_unique<PhysicalFlow>(scene.lattice, scene.fluid, scene.settings, timings);
    }
    return std::make_unique<SpectralFlow>(scene.lattice, scene.fluid, scene.settings, timings, effort);
}

} // namespace isph
