#include "flow/readFlow.hpp"

#include "flow/Scene.hpp"

#include "boundary/readBoundary.hpp"
#include "caseFields/FieldsOfTime.hpp"
#include "caseFields/readFieldFile.hpp"
#include "caseFields/unitOf.hpp"

#include <array>
#include <utility>
#include <vector>

namespace isph
{

namespace
{

using Dimensions = std::array<int, 7>;
constexpr Dimensions velocityDimensions{0, 1, -1, 0, 0, 0, 0};
constexpr Dimensions kinematicPressure{0, 2, -2, 0, 0, 0, 0};
constexpr Dimensions pascal{1, -1, -2, 0, 0, 0, 0};

} // namespace

Dictionary readVelocityFile(const Case& flowCase, const std::string& time, const Lattice& lattice)
{
    Dictionary U = readFieldFile(flowCase, time, "U", lattice);
    if (U.dimensions("dimensions") != velocityDimensions)
    {
        throw U.error("dimensions", "are not those of a velocity", "write [0 1 -1 0 0 0 0]");
    }
    checkVelocityConditions(U, lattice);
    return U;
}

Dictionary readPressureFile(const Case& flowCase, const std::string& time, const Lattice& lattice, const Fluid& fluid)
{
    Dictionary p = readFieldFile(flowCase, time, "p", lattice);
    const Dimensions dimensions = p.dimensions("dimensions");
    if (dimensions != kinematicPressure && dimensions != pascal)
    {
        throw p.error("dimensions", "are not those of a pressure",
                      "write [0 2 -2 0 0 0 0] for kinematic pressure or [1 -1 -2 0 0 0 0] for Pa");
    }
    if (dimensions == pascal && !fluid.rho)
    {
        throw p.error("dimensions", "ask for a pressure in Pa, but there is no density",
                      "add rho [1 -3 0 0 0 0 0] ...; to constant/transportProperties");
    }
    checkPressureConditions(p, lattice);
    return p;
}

FlowFiles readFlowFiles(const Case& flowCase, const std::string& time, const Lattice& lattice, const Fluid& fluid)
{
    FlowFiles files;
    std::vector<Complaint> slips;
    const auto attempt = [&slips](const auto& read)
    {
        try
        {
            read();
        }
        catch (const Error& error)
        {
            slips.insert(slips.end(), error.complaints().begin(), error.complaints().end());
        }
    };
    attempt([&] { files.U = readVelocityFile(flowCase, time, lattice); });
    attempt([&] { files.p = readPressureFile(flowCase, time, lattice, fluid); });
    if (!slips.empty()) { throw Error(Fault::input, std::move(slips)); }

    const Dimensions dimensions = files.p.dimensions("dimensions");
    if (dimensions == pascal) { files.pressureScale = *fluid.rho; }
    files.pressureUnit = unitOf(dimensions);
    return files;
}

FlowBoundary readFlowBoundary(const Case& flowCase, const std::string& time, const Lattice& lattice, const Fluid& fluid,
                              const FlowFiles& files)
{
    BoundaryContext context;
    context.constants.emplace_back("nu", fluid.nu);
    if (fluid.rho) { context.constants.emplace_back("rho", *fluid.rho); }
    context.folder = flowCase.directory();
    context.pressureScale = files.pressureScale;
    context.time = FieldsOfTime(flowCase, time).time();
    return readBoundary(files.U, files.p, lattice, context);
}

StartReport readFlow(const Case& flowCase, const std::string& time, bool restart, Scene& scene,
                     IncompressibleFlow& flow)
{
    FieldsOfTime fields(flowCase, time);
    scene.boundary.update(fields.time());
    if (restart && flowCase.has(time + "/fields.h5"))
    {
        const FieldReader reader(flowCase.path(time + "/fields.h5"), time + "/fields.h5");
        if (flow.restores(reader))
        {
            flow.restore(reader);
            return {};
        }
    }
    // The pressure follows from the velocity; its values are read so that a slip in them does not wait for another
    // program.
    fields.read("p", scene.lattice);
    return flow.start(fields.read("U", scene.lattice), scene.settings.initialProjection && !restart);
}

} // namespace isph
