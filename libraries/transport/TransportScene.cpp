#include "transport/TransportScene.hpp"

#include "case/TimeDirectories.hpp"
#include "caseFields/FieldsOfTime.hpp"
#include "core/Error.hpp"
#include "lattice/memoryEstimate.hpp"
#include "lattice/readLattice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace isph
{

namespace
{

/// Folders of a flow would be replaced by those of the scalar.
void requireNoFlow(const Case& theCase)
{
    for (const TimeDirectory& time : timeDirectories(theCase.directory()))
    {
        if (time.name == carrierFolder || !theCase.has(time.name + "/U")) { continue; }
        throw Error(Fault::input, {time.name + "/U", 0, ""},
                    "is the velocity of a flow that was solved here, and its times would be replaced",
                    "copy the case with cloneCase, and the velocity into its folder 0");
    }
}

} // namespace

TransportScene::TransportScene(const Case& theCase, const std::string& startTime)
    : lattice(readLattice(theCase.dictionary("constant/lattice"))),
      diffusivity(readDiffusivity(theCase)),
      settings(readTransportSettings(theCase, lattice, diffusivity)),
      velocity(readGivenVelocity(theCase, carrierFolder, lattice)),
      file(readScalarFile(theCase, startTime, lattice)),
      boundary(readScalarBoundary(theCase, file.T, lattice))
{
    requireNoFlow(theCase);
}

SceneDescription describeTransport(const TransportScene& scene, const ScalarTransport& transport)
{
    const FlowSettings& settings = scene.settings;
    Fluid carrier; // the words for kernel, continuation and filter are those of a flow
    carrier.nu = scene.diffusivity;
    const SceneDescription flow = describeScene(scene.lattice, carrier, settings);

    SceneDescription description{};
    const auto choose = [&description](bool active, const std::string& yes, const std::string& no)
    { (active ? description.active : description.leftOut).push_back(active ? yes : no); };
    choose(true, "scalar T", "");
    choose(transport.convects(),
           scene.velocity->dependsOnTime() ? "convection (U . grad) T, U anew in every substep"
                                           : "convection (U . grad) T, U as given",
           "convection");
    choose(scene.diffusivity > 0, fmt::format("diffusion: {}, explicit", laplacians().nameOf(settings.laplacian)),
           "diffusion (DT is 0)");
    choose(transport.dealiases(), "dealiasing: two thirds of periodic axes", "dealiasing");
    choose(settings.filter.type != FilterSettings::Type::none,
           fmt::format("filter: {}", filters().nameOf(settings.filter.type)), "filter");
    if (scene.lattice.periodic()) { description.leftOut.emplace_back("continuation (every axis is periodic)"); }
    else { description.active.emplace_back("continuation on bounded axes"); }
    description.leftOut.emplace_back("pressure");

    for (const auto& [key, value] : flow.schemes)
    {
        if (key == "kernel" || key == "time" || key == "filter" || key == "continuation")
        {
            description.schemes.emplace_back(key, value);
        }
    }
    description.schemes.emplace_back("convection", transport.convects() ? "advective" : "none");
    description.schemes.emplace_back(
        "laplacian", scene.diffusivity > 0 ? std::string(laplacians().nameOf(settings.laplacian)) : "none");
    description.schemes.emplace_back("viscous", scene.diffusivity > 0 ? "explicit" : "none");
    description.schemes.emplace_back("dealiasing", transport.dealiases() ? "twoThirds" : "none");
    description.transformsOfLines = true;
    description.transformsPerSubstep =
        scene.lattice.dimensions() * (1 + (transport.convects() ? 1 : 0) + (scene.diffusivity > 0 ? 1 : 0));
    return description;
}

double transportMemory(const TransportScene& scene)
{
    // T, the one before, two rates, what is read, what is written; U and where it comes from; coordinates.
    const int arrays = 6 + 2 * scene.lattice.dimensions() + (scene.velocity->dependsOnTime() ? 3 : 0);
    return programMemory + 8.0 * arrays * static_cast<double>(scene.lattice.points());
}

double startTransport(const Case& theCase, const std::string& time, bool restart, double t, TransportScene& scene,
                      ScalarTransport& transport)
{
    RealField values = readField(theCase, time, "T", scene.lattice);
    if (values.components() != 1)
    {
        throw Error(Fault::input, {time + "/T", 0, "internalField"}, "is a vector, but T is a scalar",
                    "write e.g. internalField uniform 0;");
    }
    if (transport.convects())
    {
        RealField U(scene.lattice.dimensions(), scene.lattice.points());
        scene.velocity->evaluate(t, U);
        const auto patches = scene.boundary.inflowThroughOutflow(U);
        if (!patches.empty())
        {
            throw Error(Fault::input, scene.file.T.dictionary("boundaryField").origin(),
                        fmt::format("patch {} is outflow, but U enters there: nothing says what it brings in",
                                    fmt::join(patches, ", ")),
                        "prescribe what enters: type fixedValue; value uniform 0;");
        }
    }
    const double dropped = restart && scene.file.stored ? 0 : transport.prepare(values, t);
    transport.start(values, t);
    return dropped;
}

} // namespace isph
