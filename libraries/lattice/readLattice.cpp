#include "lattice/readLattice.hpp"

#include "lattice/readPatches.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace isph
{

namespace
{

constexpr double fitTolerance = 1e-9; ///< of the contract, relative to the extent

using Vector = std::array<double, 3>;

/// The facts that both dictionaries share, and how many points an interval count makes.
struct Box
{
    Vector origin{};
    Vector extent{};
    std::vector<Patch> patches;
    std::array<Axis::Ends, 3> ends{};
    bool staggered = false;

    bool active(std::size_t d) const { return extent[d] > 0; }
    bool pointsOnBothEnds(std::size_t d) const { return active(d) && ends[d] == Axis::Ends::bounded && !staggered; }
    /// One along a periodic axis: nothing changes along it, and its component is carried along.
    int fewestPoints(std::size_t d) const { return ends[d] == Axis::Ends::periodic ? 1 : 2; }
};

char axisName(std::size_t d) { return "xyz"[d]; }

Box readBox(const Dictionary& dictionary)
{
    Box box;
    box.origin = dictionary.vector("origin");
    box.extent = dictionary.vector("extent");
    int active = 0;
    for (std::size_t d = 0; d < 3; ++d)
    {
        if (!(box.extent[d] >= 0) || !std::isfinite(box.extent[d]) || !std::isfinite(box.origin[d]))
        {
            throw dictionary.error("extent",
                                   fmt::format("is {} along axis {} but must be 0 or more", box.extent[d], axisName(d)),
                                   "write the size of the box in metres; 0 leaves an axis out");
        }
        active += box.active(d) ? 1 : 0;
    }
    if (active < 2)
    {
        throw dictionary.error("extent", "is above 0 along fewer than two axes",
                               "incompressible flow along one line is a constant: give two or three axes an extent");
    }
    box.patches = readPatches(dictionary, box.extent);
    box.ends = endsOfAxes(box.patches);
    box.staggered = dictionary.word("arrangement").text == "staggered";
    return box;
}

/// A whole number of things along an axis, as a double that is known to fit an int.
int wholeNumber(const Dictionary& dictionary, std::string_view key, std::size_t d, double value, int minimum)
{
    if (value != std::floor(value))
    {
        throw dictionary.error(key, fmt::format("is {} along axis {} but must be a whole number", value, axisName(d)));
    }
    if (!(value >= minimum))
    {
        throw dictionary.error(key,
                               fmt::format("is {} along axis {} but must be at least {}", value, axisName(d), minimum));
    }
    if (value > std::numeric_limits<int>::max() - 1)
    {
        throw dictionary.error(key, fmt::format("is {} along axis {} but can be at most {}", value, axisName(d),
                                                std::numeric_limits<int>::max() - 1));
    }
    return static_cast<int>(value);
}

std::array<int, 3> readCount(const Dictionary& dictionary, const Box& box)
{
    const Vector written = dictionary.vector("count");
    std::array<int, 3> count{};
    for (std::size_t d = 0; d < 3; ++d)
    {
        if (!box.active(d) && written[d] != 1)
        {
            throw dictionary.error("count",
                                   fmt::format("is {} along axis {}, whose extent is 0", written[d], axisName(d)),
                                   "write 1 to leave the axis out, or give it an extent");
        }
        count[d] = box.active(d) ? wholeNumber(dictionary, "count", d, written[d], box.fewestPoints(d)) : 1;
    }
    return count;
}

std::array<int, 3> readIntervals(const Dictionary& dictionary, const Box& box)
{
    const Vector written = dictionary.vector("intervals");
    std::array<int, 3> count{};
    for (std::size_t d = 0; d < 3; ++d)
    {
        if (!box.active(d) && written[d] != 0)
        {
            throw dictionary.error("intervals",
                                   fmt::format("is {} along axis {}, whose extent is 0", written[d], axisName(d)),
                                   "write 0 to leave the axis out, or give it an extent");
        }
        const int more = box.pointsOnBothEnds(d) ? 1 : 0;
        const int fewest = box.fewestPoints(d) - more;
        count[d] = box.active(d) ? wholeNumber(dictionary, "intervals", d, written[d], fewest) + more : 1;
    }
    return count;
}

std::array<int, 3> readSpacing(const Dictionary& dictionary, const Box& box)
{
    const bool oneForAll = dictionary.find("spacing")->tokens().size() == 1;
    const Vector written = oneForAll ? Vector{} : dictionary.vector("spacing");
    std::array<int, 3> count{1, 1, 1};
    for (std::size_t d = 0; d < 3; ++d)
    {
        if (!box.active(d)) { continue; }
        const double spacing = oneForAll ? dictionary.number("spacing") : written[d];
        if (!(spacing > 0) || !std::isfinite(spacing))
        {
            throw dictionary.error("spacing",
                                   fmt::format("is {} along axis {} but must be positive", spacing, axisName(d)));
        }
        const double intervals = std::round(box.extent[d] / spacing);
        if (std::abs(intervals * spacing - box.extent[d]) > fitTolerance * box.extent[d])
        {
            const double fewer = std::max(1.0, std::floor(box.extent[d] / spacing));
            throw dictionary.error(
                "spacing", fmt::format("{} does not fit the extent {} of axis {}", spacing, box.extent[d], axisName(d)),
                fmt::format("write {} for {} intervals or {} for {}", box.extent[d] / fewer, fewer,
                            box.extent[d] / (fewer + 1), fewer + 1));
        }
        const int more = box.pointsOnBothEnds(d) ? 1 : 0;
        if (intervals + more < box.fewestPoints(d))
        {
            throw dictionary.error("spacing", fmt::format("{} leaves axis {} with one point", spacing, axisName(d)),
                                   "an axis that ends at walls needs two points or more");
        }
        count[d] = wholeNumber(dictionary, "spacing", d, intervals, 1) + more;
    }
    return count;
}

/// \param key entry that gave the counts, for the message
Lattice makeLattice(const Dictionary& dictionary, Box box, const std::array<int, 3>& count, std::string_view key)
{
    // Far above any memory, far below where sizes in bytes overflow.
    constexpr double mostPoints = 1e15;
    double points = 1;
    std::array<Axis, 3> axes;
    for (std::size_t d = 0; d < 3; ++d)
    {
        axes[d] = {axisName(d), box.origin[d], box.extent[d],
                   count[d],    box.ends[d],   box.staggered && box.ends[d] == Axis::Ends::bounded};
        points *= count[d];
    }
    if (points > mostPoints)
    {
        throw dictionary.error(key, fmt::format("makes {} points, more than any memory holds", points),
                               "take fewer points");
    }
    return Lattice(axes, std::move(box.patches));
}

/// constant/lattice may have been edited: what it repeats must still be what follows.
void requireSame(const Dictionary& dictionary, const Lattice& lattice)
{
    const Vector spacing = dictionary.vector("spacing");
    const std::vector<Word> axes = dictionary.words("axes");
    if (axes.size() != 3) { throw dictionary.error("axes", "must be three words, one an axis"); }
    for (int d = 0; d < 3; ++d)
    {
        const Axis& axis = lattice.axis(d);
        const auto i = static_cast<std::size_t>(d);
        const double expected = axis.active() ? axis.spacing() : 0;
        if (!(std::abs(spacing[i] - expected) <= fitTolerance * expected))
        {
            throw dictionary.error(
                "spacing",
                fmt::format("is {} along axis {}, but extent and count make it {}", spacing[i], axis.name, expected),
                "change system/latticeDict instead and run makeLattice -overwrite");
        }
        const std::string kind = toString(axis);
        if (axes[i].text != kind)
        {
            throw dictionary.error(
                "axes",
                fmt::format("calls axis {} {}, but extent and patches make it {}", axis.name, axes[i].text, kind),
                "change system/latticeDict instead and run makeLattice -overwrite");
        }
    }
}

} // namespace

std::string toString(const Axis& axis)
{
    if (!axis.active()) { return "leftOut"; }
    return axis.periodic() ? "periodic" : "bounded";
}

Lattice makeLattice(const Dictionary& latticeDict)
{
    const Dictionary dictionary = latticeDictSchema().complete(latticeDict);
    Box box = readBox(dictionary);

    std::vector<std::string_view> given;
    for (const std::string_view key : {"count", "intervals", "spacing"})
    {
        if (dictionary.has(key)) { given.push_back(key); }
    }
    if (given.empty())
    {
        throw Error(Fault::input, dictionary.origin(), "has none of count, intervals and spacing",
                    "write one of them, e.g. count (160 160 1);");
    }
    if (given.size() > 1)
    {
        throw dictionary.error(given[1], fmt::format("is given besides {}", given[0]), "keep one of the two");
    }
    const auto read = given[0] == "count" ? readCount : given[0] == "intervals" ? readIntervals : readSpacing;
    const std::array<int, 3> count = read(dictionary, box);
    return makeLattice(dictionary, std::move(box), count, given[0]);
}

Lattice readLattice(const Dictionary& written)
{
    const Dictionary dictionary = latticeSchema().complete(written);
    Box box = readBox(dictionary);
    const std::array<int, 3> count = readCount(dictionary, box);
    Lattice lattice = makeLattice(dictionary, std::move(box), count, "count");
    requireSame(dictionary, lattice);
    return lattice;
}

} // namespace isph
