#include "sampling/readSampleSet.hpp"

#include "core/Error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <sstream>

namespace isph
{

namespace
{

std::vector<Key> keysOfSampleDict()
{
    using enum Key::Type;
    const Key line{.name = "*",
                   .type = dictionary,
                   .meaning = "a name of your choice: <name>.csv",
                   .keys = {{.name = "start", .type = vector, .unit = "m", .meaning = "first point", .required = true},
                            {.name = "end", .type = vector, .unit = "m", .meaning = "last point", .required = true},
                            {.name = "nPoints",
                             .type = integer,
                             .meaning = "points, both ends included",
                             .required = true,
                             .minimum = 2}}};
    const Key plane{
        .name = "*",
        .type = dictionary,
        .meaning = "a name of your choice: <name>.csv",
        .keys = {{.name = "normal",
                  .type = word,
                  .meaning = "the axis that the plane is normal to",
                  .required = true,
                  .words = {"x", "y", "z"}},
                 {.name = "at", .type = number, .unit = "m", .meaning = "where on that axis", .required = true},
                 {.name = "nPoints",
                  .type = list,
                  .meaning = "points along the two other axes, from face to face; default: the lattice points"}}};
    return {
        {.name = "lines", .type = dictionary, .meaning = "straight lines", .keys = {line}},
        {.name = "planes", .type = dictionary, .meaning = "planes across the box", .keys = {plane}},
        {.name = "fields", .type = list, .fallback = "(U p)", .meaning = "fields of the case, and vorticity"},
        {.name = "interpolation",
         .type = word,
         .fallback = "spectral",
         .meaning = "how values between lattice points are found; lattice points are hit exactly",
         .words = interpolations().names()},
    };
}

/// Complains where a coordinate leaves the box, at the entry that gives it.
void requireInside(const Dictionary& place, const std::string& key, const Axis& axis, double coordinate)
{
    if (inside(axis, coordinate)) { return; }
    throw place.error(key, fmt::format("has {} = {}, outside of the box", axis.name, coordinate),
                      fmt::format("{} reaches from {} to {}", axis.name, axis.origin, axis.origin + axis.extent));
}

Line lineOf(const std::string& name, const Dictionary& place, const Lattice& lattice)
{
    const Line line{name, place.vector("start"), place.vector("end"), place.integer("nPoints")};
    for (std::size_t d = 0; d < 3; ++d)
    {
        requireInside(place, "start", lattice.axis(static_cast<int>(d)), line.start[d]);
        requireInside(place, "end", lattice.axis(static_cast<int>(d)), line.end[d]);
    }
    if (line.start == line.end) { throw place.error("end", "is the same point as the start"); }
    return line;
}

Plane planeOf(const std::string& name, const Dictionary& place, const Lattice& lattice)
{
    Plane plane{name, place.word("normal").text.front() - 'x', place.number("at"), {}};
    requireInside(place, "at", lattice.axis(plane.normal), plane.at);
    if (place.has("nPoints"))
    {
        const std::vector<double> counts = place.numbers("nPoints");
        const auto isCount = [](double value) { return value >= 2 && value <= 1e5 && value == std::floor(value); };
        if (counts.size() != 2 || !std::ranges::all_of(counts, isCount))
        {
            throw place.error("nPoints", "is not two whole numbers of 2 or more",
                              "write e.g. (201 201): points along the two axes of the plane");
        }
        std::ranges::transform(counts, plane.nPoints.begin(), [](double value) { return static_cast<int>(value); });
    }
    return plane;
}

/// The places of one kind, in the order of the dictionary; names collects those given so far.
template<class Place>
std::vector<Place> placesOf(const Dictionary& sampleDict, const std::string& kind, const Lattice& lattice,
                            std::vector<std::string>& names,
                            Place (*read)(const std::string&, const Dictionary&, const Lattice&))
{
    std::vector<Place> places;
    if (!sampleDict.hasDictionary(kind)) { return places; }
    for (const Entry& entry : sampleDict.dictionary(kind).entries())
    {
        if (!entry.isDictionary()) { continue; } // a constant that a macro uses
        const std::string& name = entry.keyword();
        if (name.find('/') != std::string::npos)
        {
            throw Error(Fault::input, entry.origin(), "is no name for a file", "take a name without '/'");
        }
        if (std::ranges::find(names, name) != names.end())
        {
            throw Error(Fault::input, entry.origin(), "is the name of a line already",
                        fmt::format("both would write {}.csv: take another name", name));
        }
        names.push_back(name);
        places.push_back(read(name, entry.dictionary(), lattice));
    }
    return places;
}

} // namespace

const Schema& sampleSchema()
{
    static const Schema schema("sampleDict", keysOfSampleDict());
    return schema;
}

SampleSet readSampleSet(const Dictionary& sampleDict, const Lattice& lattice, const SampleChoices& choices)
{
    const Dictionary complete = sampleSchema().complete(sampleDict);
    std::vector<std::string> names;
    std::vector<Line> lines = placesOf(complete, "lines", lattice, names, lineOf);
    std::vector<Plane> planes = placesOf(complete, "planes", lattice, names, planeOf);
    if (names.empty())
    {
        throw Error(Fault::input, {complete.origin().file, 0, ""}, "asks for no line and no plane",
                    "write e.g. lines { centre { start (0.5 0 0); end (0.5 1 0); nPoints 101; } }");
    }
    if (choices.only)
    {
        const std::string& only = choices.only->text;
        if (std::ranges::find(names, only) == names.end()) { throwUnknownWord("line or plane", *choices.only, names); }
        std::erase_if(lines, [&only](const Line& line) { return line.name != only; });
        std::erase_if(planes, [&only](const Plane& plane) { return plane.name != only; });
    }
    return {lattice, lines, planes, choices.fields.value_or(complete.words("fields")),
            interpolations()[choices.interpolation.value_or(complete.word("interpolation"))]};
}

Plane planeOfText(const std::string& text, const Lattice& lattice)
{
    std::istringstream in(text);
    std::string normal;
    in >> normal;
    Plane plane{"plane", 2, 0, {}};
    if (normal == "auto")
    {
        for (int d = 0; d < 3; ++d)
        {
            if (!lattice.axis(d).active()) { plane.normal = d; }
        }
    }
    else if (normal == "x" || normal == "y" || normal == "z") { plane.normal = normal.front() - 'x'; }
    else { normal.clear(); }

    const Axis& axis = lattice.axis(plane.normal);
    plane.at = axis.origin + axis.extent / 2;
    std::string rest;
    if (in >> rest)
    {
        char* end = nullptr;
        plane.at = std::strtod(rest.c_str(), &end);
        if (*end != '\0' || !std::isfinite(plane.at)) { normal.clear(); }
    }
    if (normal.empty() || in >> rest)
    {
        throw Error(Fault::usage, fmt::format("-plane '{}' names no plane", text),
                    "write an axis and where on it, e.g. -plane 'z 0.5', or -plane z for the middle, or -plane auto");
    }
    if (!inside(axis, plane.at))
    {
        throw Error(Fault::input, fmt::format("-plane '{}' lies outside of the box", text),
                    fmt::format("{} reaches from {} to {}", axis.name, axis.origin, axis.origin + axis.extent));
    }
    return plane;
}

} // namespace isph
