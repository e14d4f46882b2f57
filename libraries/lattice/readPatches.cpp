#include "lattice/readPatches.hpp"

#include "core/Selection.hpp"
#include "lattice/readLattice.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace isph
{

namespace
{

constexpr std::array<std::string_view, 3> axisNames{"x", "y", "z"};

constexpr std::array<Selection<Patch::Type>::Variant, 3> patchTypes{{
    {"periodic", "both faces of an axis: what leaves through one enters through the other", Patch::Type::periodic},
    {"wall", "a solid wall", Patch::Type::wall},
    {"patch", "an open face: inlet, outlet", Patch::Type::patch},
}};
static_assert(distinct(patchTypes));

std::size_t faceIndex(const Word& word)
{
    const auto& names = faceNames();
    const auto found = std::find(names.begin(), names.end(), word.text);
    if (found == names.end()) { throwUnknownWord("face", word, names); }
    return static_cast<std::size_t>(found - names.begin());
}

/// The words of face, faces or axis as face numbers.
std::vector<std::size_t> facesOf(const Dictionary& patch)
{
    const int given = int(patch.has("face")) + int(patch.has("faces")) + int(patch.has("axis"));
    if (given != 1)
    {
        throw Error(Fault::input, patch.origin(), given == 0 ? "has no faces" : "has faces given in more than one way",
                    "write one of: face xMin; | faces (xMin xMax); | axis x;");
    }
    std::vector<std::size_t> faces;
    if (patch.has("axis"))
    {
        const auto axis = static_cast<std::size_t>(patch.word("axis").text[0] - 'x');
        return {2 * axis, 2 * axis + 1};
    }
    for (const Word& word : patch.words(patch.has("face") ? "face" : "faces")) { faces.push_back(faceIndex(word)); }
    return faces;
}

/// Gathers patches and what is wrong with them.
class PatchReader
{
public:
    PatchReader(const Dictionary& patches, const std::array<double, 3>& extent) : origin_(patches.origin())
    {
        for (const Entry& entry : patches.entries())
        {
            try
            {
                add(entry, extent);
            }
            catch (const Error& error)
            {
                complaints_.insert(complaints_.end(), error.complaints().begin(), error.complaints().end());
            }
        }
        // A face that a slip hid would be reported missing as well: one fact, one message.
        if (complaints_.empty()) { findMissingFaces(extent); }
        if (!complaints_.empty()) { throw Error(Fault::input, complaints_); }
    }

    std::vector<Patch> patches() && { return std::move(patches_); }

private:
    void add(const Entry& entry, const std::array<double, 3>& extent)
    {
        const Dictionary& dictionary = entry.dictionary();
        if (entry.isPattern())
        {
            throw Error(Fault::input, entry.origin(), "is a pattern, but a patch needs a name", "leave out the quotes");
        }
        Patch patch{entry.keyword(), Selection<Patch::Type>("patch type", patchTypes)[dictionary.word("type")], {}};
        std::vector<std::size_t> faces = facesOf(dictionary);
        std::sort(faces.begin(), faces.end());
        for (const std::size_t face : faces)
        {
            const std::string& name = faceNames()[face];
            if (!(extent[face / 2] > 0))
            {
                throw Error(
                    Fault::input, entry.origin(),
                    fmt::format("has the face {}, but axis {} is left out (extent 0)", name, axisNames[face / 2]),
                    "take the face out of the patch, or give the axis an extent");
            }
            if (!owners_[face].empty())
            {
                throw Error(Fault::input, entry.origin(),
                            owners_[face] == patch.name
                                ? fmt::format("names the face {} twice", name)
                                : fmt::format("has the face {}, which patch {} has already", name, owners_[face]),
                            "name every face once");
            }
            owners_[face] = patch.name;
            patch.faces.push_back(name);
        }
        if (patch.type == Patch::Type::periodic) { requirePairs(entry, faces); }
        patches_.push_back(std::move(patch));
    }

    static void requirePairs(const Entry& entry, const std::vector<std::size_t>& faces)
    {
        for (const std::size_t face : faces)
        {
            const std::size_t partner = face ^ 1U;
            if (std::find(faces.begin(), faces.end(), partner) == faces.end())
            {
                throw Error(Fault::input, entry.origin(),
                            fmt::format("is periodic but has {} without {}", faceNames()[face], faceNames()[partner]),
                            fmt::format("write axis {}; or make it a wall or a patch", axisNames[face / 2]));
            }
        }
    }

    void findMissingFaces(const std::array<double, 3>& extent)
    {
        for (std::size_t face = 0; face < owners_.size(); ++face)
        {
            if (extent[face / 2] > 0 && owners_[face].empty())
            {
                complaints_.push_back(
                    {origin_, fmt::format("no patch has the face {}", faceNames()[face]),
                     fmt::format("add it to one, e.g. sides {{ type periodic; axis {}; }}", axisNames[face / 2])});
            }
        }
    }

    Origin origin_;
    std::array<std::string, 6> owners_; ///< patch of each face
    std::vector<Patch> patches_;
    std::vector<Complaint> complaints_;
};

} // namespace

std::string_view toString(Patch::Type type) { return Selection<Patch::Type>("patch type", patchTypes).nameOf(type); }

const std::array<std::string, 6>& faceNames()
{
    static const std::array<std::string, 6> names{"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"};
    return names;
}

std::vector<Patch> readPatches(const Dictionary& dictionary, const std::array<double, 3>& extent)
{
    return PatchReader(dictionary.dictionary("patches"), extent).patches();
}

std::array<Axis::Ends, 3> endsOfAxes(const std::vector<Patch>& patches)
{
    std::array<Axis::Ends, 3> ends{};
    for (const Patch& patch : patches)
    {
        if (patch.type == Patch::Type::periodic) { continue; }
        for (const std::string& face : patch.faces)
        {
            ends[static_cast<std::size_t>(face[0] - 'x')] = Axis::Ends::bounded;
        }
    }
    return ends;
}

} // namespace isph
