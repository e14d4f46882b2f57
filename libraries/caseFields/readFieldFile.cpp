#include "caseFields/readFieldFile.hpp"

#include "core/nearestWord.hpp"
#include "dictionary/Schema.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace isph
{

namespace
{

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

} // namespace

Dictionary readFieldFile(const Case& flowCase, const std::string& time, const std::string& name, const Lattice& lattice)
{
    Dictionary field = fieldSchema().complete(flowCase.dictionary(time + "/" + name));
    checkBoundary(field, lattice);
    return field;
}

} // namespace isph
