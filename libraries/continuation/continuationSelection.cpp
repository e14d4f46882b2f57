#include "continuation/continuationSelection.hpp"

#include "continuation/Gram.hpp"
#include "continuation/Mirror.hpp"
#include "continuation/Polynomial.hpp"
#include "continuation/SmoothGram.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace isph
{

namespace
{

using Maker = std::unique_ptr<Continuation> (*)(const Dictionary&, const Axis&);

bool isAuto(const Dictionary& dictionary, std::string_view key)
{
    return dictionary.find(key)->tokens().front().kind != Token::Kind::number;
}

int integerOr(const Dictionary& dictionary, std::string_view key, int automatic)
{
    return isAuto(dictionary, key) ? automatic : dictionary.integer(key);
}

int intervalsOf(const Axis& axis) { return axis.staggered ? axis.count : axis.count - 1; }

/// New points: as many as written, or for numbers up to 1 that fraction of the interval.
int newPointsOf(const Dictionary& dictionary, const Axis& axis, int automatic)
{
    if (isAuto(dictionary, "extension")) { return automatic; }
    const double written = dictionary.number("extension");
    const int intervals = intervalsOf(axis);
    if (written > 1 && written != std::floor(written))
    {
        throw dictionary.error("extension",
                               fmt::format("is {}, neither a whole number of points nor a fraction", written),
                               "write auto, a number of points, or a fraction of the interval up to 1");
    }
    // Short axes may need more new points than they have: 25 are what the default takes.
    constexpr int alwaysAllowed = 64;
    const int largest = std::max(intervals, alwaysAllowed);
    const double points = written > 1 ? written : std::round(written * intervals);
    if (points < 1 || points > largest)
    {
        throw dictionary.error("extension", fmt::format("is {} new points on axis {}", points, axis.name),
                               fmt::format("write auto, or 1 ... {} points", largest));
    }
    return static_cast<int>(points);
}

/// Refuses a continuation that uses more points than there are.
void requirePoints(const Continuation& continuation, const Dictionary& dictionary, const Axis& axis,
                   std::string_view key)
{
    if (continuation.points() > axis.count)
    {
        throw dictionary.error(key,
                               fmt::format("needs {} points at each end, but axis {} has {}", continuation.points(),
                                           axis.name, axis.count),
                               "take more lattice points in system/latticeDict, or fewer here");
    }
}

/// What make gives; an error that knows no file is one of this entry.
template<class Make>
auto atEntry(const Dictionary& dictionary, std::string_view key, Make make)
{
    try
    {
        return make();
    }
    catch (const Error& slip)
    {
        const Complaint& complaint = slip.complaints().front();
        if (!complaint.origin.file.empty()) { throw; }
        throw dictionary.error(key, complaint.what, complaint.advice);
    }
}

std::unique_ptr<Continuation> makeSmoothGram(const Dictionary& dictionary, const Axis& axis)
{
    const int newPoints = newPointsOf(dictionary, axis, automaticNewPoints(axis.count));
    const int degree = integerOr(dictionary, "degree", automaticDegree("smoothGram"));
    const int smoothness = integerOr(dictionary, "smoothness", automaticSmoothness("smoothGram"));
    auto made =
        atEntry(dictionary, "degree", [&] { return std::make_unique<SmoothGram>(newPoints, degree, smoothness); });
    requirePoints(*made, dictionary, axis, "degree");
    return made;
}

std::unique_ptr<Continuation> makePolynomial(const Dictionary& dictionary, const Axis& axis)
{
    const int intervals = intervalsOf(axis);
    const int quarter = std::max(static_cast<int>(std::lround(0.25 * intervals)), 1);
    const int newPoints = newPointsOf(dictionary, axis, quarter);
    const int degree = integerOr(dictionary, "degree", automaticDegree("polynomial"));
    const int points = integerOr(dictionary, "points", std::max(Polynomial::automaticPoints(intervals), degree + 1));
    const int smoothness = integerOr(dictionary, "smoothness", automaticSmoothness("polynomial"));
    auto made = atEntry(dictionary, points < degree + 1 ? "points" : "degree",
                        [&] { return std::make_unique<Polynomial>(newPoints, degree, points, smoothness); });
    requirePoints(*made, dictionary, axis, "points");
    return made;
}

std::unique_ptr<Continuation> makeGram(const Dictionary& dictionary, const Axis& axis)
{
    const int newPoints = newPointsOf(dictionary, axis, automaticNewPoints(axis.count));
    const int degree = integerOr(dictionary, "degree", automaticDegree("gram"));
    const bool longOrShort = newPoints < Gram::leastNewPoints || newPoints > Gram::largestNewPoints;
    auto made = atEntry(dictionary, longOrShort ? "extension" : "degree",
                        [&] { return std::make_unique<Gram>(newPoints, degree); });
    requirePoints(*made, dictionary, axis, "degree");
    return made;
}

std::unique_ptr<Continuation> makeMirror(const Dictionary& dictionary, const Axis& axis)
{
    // Images of all points, and no more: a short axis cannot give the automatic number.
    const int images = axis.staggered ? axis.count : axis.count - 1;
    const int newPoints = newPointsOf(dictionary, axis, std::min(automaticNewPoints(axis.count), images));
    auto made = std::make_unique<Mirror>(newPoints, axis.staggered,
                                         integerOr(dictionary, "smoothness", automaticSmoothness("mirror")));
    requirePoints(*made, dictionary, axis, "extension");
    return made;
}

constexpr std::array<Selection<Maker>::Variant, 4> table{{
    {"smoothGram", "polynomial through the points next to each end, blended smoothly; closed form", &makeSmoothGram},
    {"polynomial", "polynomial fitted to a part of the points (Lin, Fourtakas & Rogers 2026)", &makePolynomial},
    {"gram", "FC(Gram) from a table in double-double arithmetic, for comparison", &makeGram},
    {"mirror", "mirror particles, second order (Fourtakas, Rogers & Nasar 2021)", &makeMirror},
}};
static_assert(distinct(table));

} // namespace

const Selection<Maker>& continuations()
{
    static constexpr Selection<Maker> selection("continuation", table);
    return selection;
}

// A polynomial is the published one, where nothing else is asked for.
int automaticDegree(std::string_view type) { return type == "polynomial" ? 5 : 4; }
int automaticSmoothness(std::string_view type) { return type == "polynomial" ? 2 : 16; }

Key continuationKey()
{
    using Type = Key::Type;
    Key key{.name = "continuation", .type = Type::dictionary, .meaning = "used on bounded axes only"};
    key.keys = {
        {.name = "type",
         .type = Type::word,
         .fallback = "smoothGram",
         .meaning = "smoothGram | polynomial | gram | mirror",
         .words = continuations().names()},
        {.name = "degree",
         .type = Type::integer,
         .fallback = "auto",
         .meaning = "auto: 4, polynomial 5",
         .words = {"auto"},
         .minimum = 0},
        {.name = "smoothness",
         .type = Type::integer,
         .fallback = "auto",
         .meaning = "m of the blending function S_m; auto: 16, polynomial 2 (the quintic)",
         .words = {"auto"},
         .minimum = 0,
         .maximum = BlendedContinuation::largestSmoothness},
        {.name = "extension",
         .type = Type::number,
         .fallback = "auto",
         .meaning = "new points, or up to 1 a fraction of the interval; auto: 25 and more, polynomial 0.25",
         .words = {"auto"},
         .positive = true},
        {.name = "points",
         .type = Type::integer,
         .fallback = "auto",
         .meaning = "polynomial: points fitted at each end; auto: a quarter of the interval, at least 8",
         .words = {"auto"},
         .minimum = 1},
        {.name = "extended",
         .type = Type::flag,
         .fallback = "no",
         .meaning = "yes: transform the whole extended box, as the paper does"},
    };
    return key;
}

std::unique_ptr<Continuation> selectContinuation(const Dictionary& continuation, const Axis& axis)
{
    const Word type = continuation.word("type");
    const Maker make = continuations()[type];
    if (axis.staggered && type.text != "mirror")
    {
        throw continuation.error(
            "type", fmt::format("{} needs points on the walls, but axis {} is staggered", type.text, axis.name),
            "write type mirror; or arrangement collocated; in system/latticeDict");
    }
    return make(continuation, axis);
}

Continuations selectContinuations(const Dictionary& continuation, const Lattice& lattice)
{
    Continuations made;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        if (lattice.activeAxis(d).periodic()) { continue; }
        made[static_cast<std::size_t>(lattice.direction(d))] = selectContinuation(continuation, lattice.activeAxis(d));
    }
    return made;
}

} // namespace isph
