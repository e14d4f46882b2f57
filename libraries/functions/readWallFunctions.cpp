#include "functions/Forces.hpp"
#include "functions/PatchFlux.hpp"
#include "functions/readFunctions.hpp"
#include "functions/WallProfile.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace isph
{

namespace
{

std::vector<Key> patchKeys()
{
    using enum Key::Type;
    return {{.name = "patches", .type = list, .meaning = "names of patches, e.g. (floor lid)"},
            {.name = "patch", .type = word, .meaning = "one patch, in place of patches"}};
}

/// The patches that a function looks at, each with its faces.
std::vector<WallProfile::NamedFaces> readPatchFaces(const Dictionary& dictionary, const Lattice& lattice)
{
    std::vector<std::string> known;
    for (const Patch& patch : lattice.patches())
    {
        if (patch.type != Patch::Type::periodic) { known.push_back(patch.name); }
    }
    if (known.empty())
    {
        throw dictionary.error("type", "looks at walls, but the box has no wall patch",
                               "take the function out, or set enabled no;");
    }
    if (dictionary.has("patch") == dictionary.has("patches"))
    {
        throw dictionary.error("patches", dictionary.has("patch") ? "is there besides patch" : "is missing",
                               "write e.g. patches (" + known.front() + ");");
    }
    const std::vector<Word> words =
        dictionary.has("patch") ? std::vector{dictionary.word("patch")} : dictionary.words("patches");
    if (words.empty())
    {
        throw dictionary.error("patches", "names no patch", "write e.g. patches (" + known.front() + ");");
    }
    std::vector<WallProfile::NamedFaces> patches;
    for (const Word& word : words)
    {
        if (std::ranges::find(known, word.text) == known.end()) { throwUnknownWord("patch", word, known); }
        const auto patch = std::ranges::find(lattice.patches(), word.text, &Patch::name);
        patches.push_back({word.text, facesOf(*patch, lattice)});
    }
    return patches;
}

std::vector<Key> wallProfileKeys()
{
    std::vector<Key> keys = patchKeys();
    keys.push_back({.name = "writeControl",
                    .type = Key::Type::word,
                    .fallback = "writeTime",
                    .meaning = "when profiles are written: what writeInterval counts",
                    .words = functionWriteControls().names()});
    return keys;
}

std::unique_ptr<FunctionObject> makeWallProfile(const std::string& name, const Dictionary& dictionary,
                                                const FunctionSurroundings& surroundings)
{
    return std::make_unique<WallProfile>(outputFolder(name, surroundings), surroundings.lattice, surroundings.fluid.nu,
                                         readPatchFaces(dictionary, surroundings.lattice), pressureForm(surroundings));
}

std::vector<Key> forcesKeys()
{
    std::vector<Key> keys = patchKeys();
    keys.push_back({.name = "CofR",
                    .type = Key::Type::vector,
                    .unit = "m",
                    .fallback = "(0 0 0)",
                    .meaning = "centre that moments are about"});
    return keys;
}

std::unique_ptr<FunctionObject> makeForces(const std::string& name, const Dictionary& dictionary,
                                           const FunctionSurroundings& surroundings)
{
    std::vector<LatticeFace> faces;
    for (auto& patch : readPatchFaces(dictionary, surroundings.lattice))
    {
        std::ranges::move(patch.faces, std::back_inserter(faces));
    }
    const Fluid& fluid = surroundings.fluid;
    return std::make_unique<Forces>(outputFile(name, "forces.csv", surroundings), surroundings.lattice,
                                    std::move(faces), fluid.nu, fluid.rho ? &*fluid.rho : nullptr,
                                    dictionary.vector("CofR"));
}

std::unique_ptr<FunctionObject> makePatchFlux(const std::string& name, const Dictionary& dictionary,
                                              const FunctionSurroundings& surroundings)
{
    return std::make_unique<PatchFlux>(outputFile(name, "flux.csv", surroundings), surroundings.lattice,
                                       readPatchFaces(dictionary, surroundings.lattice), surroundings.boundary);
}

} // namespace

const FunctionType wallProfileType{wallProfileKeys, makeWallProfile};
const FunctionType forcesType{forcesKeys, makeForces};
const FunctionType patchFluxType{patchKeys, makePatchFlux};

} // namespace isph
