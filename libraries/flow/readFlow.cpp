#include "flow/readFlow.hpp"

#include "flow/Scene.hpp"

#include "caseFields/FieldsOfTime.hpp"
#include "caseFields/unitOf.hpp"
#include "core/nearestWord.hpp"
#include "dictionary/Schema.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace isph
{

namespace
{

using Dimensions = std::array<int, 7>;
constexpr Dimensions velocityDimensions{0, 1, -1, 0, 0, 0, 0};
constexpr Dimensions kinematicPressure{0, 2, -2, 0, 0, 0, 0};
constexpr Dimensions pascal{1, -1, -2, 0, 0, 0, 0};

/// Keys of a field's dictionary; its values are read where they are needed.
const Schema& fieldSchema()
{
    using Type = Key::Type;
    static const Schema schema(
        "field",
        {{.name = "dimensions", .type = Type::any, .meaning = "exponents of kg m s K mol A cd", .required = true},
         {.name = "internalField", .type = Type::any, .meaning = "values in the box", .required = true},
         {.name = "boundaryField", .type = Type::any, .meaning = "a condition for each patch", .required = true}});
    return schema;
}

/// Every patch has a condition of its kind, and every condition a patch.
void checkBoundary(const Dictionary& field, const Lattice& lattice)
{
    if (!field.hasDictionary("boundaryField"))
    {
        throw field.error("boundaryField", "is not a dictionary",
                          "write boundaryField { ... } with an entry for each patch");
    }
    const Dictionary& boundary = field.dictionary("boundaryField");
    std::vector<std::string> names;
    for (const Patch& patch : lattice.patches()) { names.push_back(patch.name); }

    std::vector<Complaint> slips;
    for (const Entry& entry : boundary.entries())
    {
        if (entry.isPattern() || std::ranges::find(names, entry.keyword()) != names.end()) { continue; }
        if (!entry.isDictionary() && entry.usedByMacro) { continue; }
        slips.push_back({entry.origin(), fmt::format("'{}' is no patch of the lattice", entry.keyword()),
                         "patches are: " + listOfWords(entry.keyword(), names)});
    }
    for (const Patch& patch : lattice.patches())
    {
        if (!boundary.hasDictionary(patch.name))
        {
            slips.push_back({boundary.origin(), fmt::format("patch {} has no boundary condition", patch.name),
                             fmt::format("write {} {{ type ...; }}", patch.name)});
            continue;
        }
        const Dictionary& condition = boundary.dictionary(patch.name);
        const Word type = condition.word("type");
        if (patch.type == Patch::Type::periodic && type.text != "periodic")
        {
            slips.push_back({type.origin, fmt::format("is {} but patch {} is periodic", type.text, patch.name),
                             "write type periodic; or change the patch in system/latticeDict"});
        }
    }
    if (!slips.empty()) { throw Error(Fault::input, slips); }
}

Dictionary readFieldFile(const Case& flowCase, const std::string& time, const std::string& name, const Lattice& lattice)
{
    Dictionary field = fieldSchema().complete(flowCase.dictionary(time + "/" + name));
    checkBoundary(field, lattice);
    return field;
}

} // namespace

Dictionary readVelocityFile(const Case& flowCase, const std::string& time, const Lattice& lattice)
{
    Dictionary U = readFieldFile(flowCase, time, "U", lattice);
    if (U.dimensions("dimensions") != velocityDimensions)
    {
        throw U.error("dimensions", "are not those of a velocity", "write [0 1 -1 0 0 0 0]");
    }
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
    return p;
}

FlowFiles readFlowFiles(const Case& flowCase, const std::string& time, const Lattice& lattice, const Fluid& fluid)
{
    FlowFiles files;
    files.U = readVelocityFile(flowCase, time, lattice);
    files.p = readPressureFile(flowCase, time, lattice, fluid);
    const Dimensions dimensions = files.p.dimensions("dimensions");
    if (dimensions == pascal) { files.pressureScale = *fluid.rho; }
    files.pressureUnit = unitOf(dimensions);
    return files;
}

StartReport readFlow(const Case& flowCase, const std::string& time, bool restart, const Scene& scene,
                     IncompressibleFlow& flow)
{
    if (restart && flowCase.has(time + "/fields.h5"))
    {
        const FieldReader reader(flowCase.path(time + "/fields.h5"), time + "/fields.h5");
        if (flow.restores(reader))
        {
            flow.restore(reader);
            return {};
        }
    }
    FieldsOfTime fields(flowCase, time);
    // The pressure follows from the velocity; its values are read so that a slip in them does not wait for another
    // program.
    fields.read("p", scene.lattice);
    return flow.start(fields.read("U", scene.lattice), scene.settings.initialProjection && !restart);
}

} // namespace isph
