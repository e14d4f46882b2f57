#include "sampling/SampleSet.hpp"

#include "core/Error.hpp"
#include "core/numberText.hpp"
#include "core/writeTextFile.hpp"

#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace isph
{

namespace
{

Points pointsOf(const Line& line, std::vector<double>& distance)
{
    assert(line.nPoints >= 2);
    const double length =
        std::hypot(line.end[0] - line.start[0], line.end[1] - line.start[1], line.end[2] - line.start[2]);
    Points points;
    for (int i = 0; i < line.nPoints; ++i)
    {
        const double part = static_cast<double>(i) / (line.nPoints - 1);
        distance.push_back(part * length);
        // Weighing both ends meets both of them exactly.
        for (std::size_t d = 0; d < 3; ++d) { points[d].push_back((1 - part) * line.start[d] + part * line.end[d]); }
    }
    return points;
}

/// Coordinates of a plane along one of its axes.
std::vector<double> coordinatesOf(const Axis& axis, int nPoints)
{
    std::vector<double> coordinates;
    if (nPoints == 0 || !axis.active())
    {
        for (int i = 0; i < axis.count; ++i) { coordinates.push_back(axis.coordinate(i)); }
        return coordinates;
    }
    assert(nPoints >= 2);
    for (int i = 0; i < nPoints; ++i) { coordinates.push_back(axis.origin + axis.extent * i / (nPoints - 1)); }
    return coordinates;
}

Points pointsOf(const Plane& plane, const Lattice& lattice)
{
    std::array<std::vector<double>, 3> along;
    std::size_t inPlane = 0;
    for (int d = 0; d < 3; ++d)
    {
        const Axis& axis = lattice.axis(d);
        along[static_cast<std::size_t>(d)] = d != plane.normal ? coordinatesOf(axis, plane.nPoints[inPlane++])
                                             : axis.active()   ? std::vector{plane.at}
                                                               : std::vector{axis.origin};
    }
    Points points;
    for (const double z : along[2])
    {
        for (const double y : along[1])
        {
            for (const double x : along[0])
            {
                points[0].push_back(x);
                points[1].push_back(y);
                points[2].push_back(z);
            }
        }
    }
    return points;
}

} // namespace

SampleSet::SampleSet(const Lattice& lattice, const std::vector<Line>& lines, const std::vector<Plane>& planes,
                     std::vector<Word> fields, Interpolation interpolation)
    : lattice_(lattice), fields_(std::move(fields))
{
    for (const Line& line : lines)
    {
        std::vector<double> distance;
        Points points = pointsOf(line, distance);
        add("line", line.name, std::move(distance), std::move(points), interpolation);
    }
    for (const Plane& plane : planes) { add("plane", plane.name, {}, pointsOf(plane, lattice), interpolation); }
}

void SampleSet::add(const std::string& kind, const std::string& name, std::vector<double> distance, Points points,
                    Interpolation interpolation)
{
    try
    {
        Interpolator interpolator(lattice_, points, interpolation);
        places_.push_back({name, std::move(distance), std::move(points), std::move(interpolator)});
    }
    catch (const Error& error)
    {
        throw Error(Fault::input, fmt::format("{} '{}': {}", kind, name, error.what()));
    }
}

SampleTable SampleSet::sample(std::size_t place, std::span<const NamedField> fields) const
{
    const Place& at = places_[place];
    SampleTable table;
    const auto add = [&table](std::string head, std::vector<double> column)
    {
        table.heads.push_back(std::move(head));
        table.columns.push_back(std::move(column));
    };
    if (!at.distance.empty()) { add("distance [m]", at.distance); }
    for (std::size_t d = 0; d < 3; ++d) { add(fmt::format("{} [m]", "xyz"[d]), at.points[d]); }

    for (const NamedField& field : fields)
    {
        const auto sampled = [&](int component)
        {
            std::vector<double> values(at.interpolator.points());
            at.interpolator(field.values[component], values);
            return values;
        };
        if (field.values.components() == 1)
        {
            add(fmt::format("{} [{}]", field.name, field.unit), sampled(0));
            continue;
        }
        int component = 0;
        for (int d = 0; d < 3; ++d)
        {
            const bool active = lattice_.axis(d).active();
            add(fmt::format("{}.{} [{}]", field.name, lattice_.axis(d).name, field.unit),
                active ? sampled(component++) : std::vector<double>(at.interpolator.points(), 0.0));
        }
    }
    return table;
}

std::string csvText(const SampleTable& table)
{
    std::string text = fmt::format("{}\n", fmt::join(table.heads, ","));
    for (std::size_t row = 0; row < table.columns.front().size(); ++row)
    {
        for (std::size_t c = 0; c < table.columns.size(); ++c)
        {
            if (c > 0) { text += ','; }
            text += numberText(table.columns[c][row]);
        }
        text += '\n';
    }
    return text;
}

void writeSamples(const SampleSet& set, std::span<const NamedField> fields, const std::filesystem::path& folder)
{
    for (std::size_t place = 0; place < set.size(); ++place)
    {
        writeTextFile(folder / (set.name(place) + ".csv"), csvText(set.sample(place, fields)));
    }
}

} // namespace isph
