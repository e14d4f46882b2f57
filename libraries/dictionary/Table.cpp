#include "dictionary/Table.hpp"

#include "dictionary/Lexer.hpp"
#include "dictionary/readText.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace isph
{

namespace
{

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t\r\"");
    if (first == std::string_view::npos) { return {}; }
    return text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<std::string_view> cells(std::string_view row)
{
    std::vector<std::string_view> result;
    for (;;)
    {
        const std::size_t comma = row.find(',');
        result.push_back(trimmed(row.substr(0, comma)));
        if (comma == std::string_view::npos) { return result; }
        row.remove_prefix(comma + 1);
    }
}

/// "y [m]" names y.
bool isCoordinate(std::string_view heading)
{
    const std::string_view name = trimmed(heading.substr(0, heading.find('[')));
    return name.size() == 1 && std::string_view("xyzt").find(name) != std::string_view::npos;
}

} // namespace

NaturalSpline::NaturalSpline(std::vector<double> places, std::vector<double> values)
    : places_(std::move(places)), values_(std::move(values)), curvatures_(places_.size(), 0.0)
{
    assert(places_.size() >= 2 && places_.size() == values_.size());
    // The tridiagonal system for the curvatures, by elimination and back substitution.
    std::vector<double> slope(places_.size(), 0.0);
    for (std::size_t i = 1; i + 1 < places_.size(); ++i)
    {
        const double before = places_[i] - places_[i - 1];
        const double behind = places_[i + 1] - places_[i];
        const double share = before / (before + behind);
        const double pivot = share * curvatures_[i - 1] + 2;
        const double bend = (values_[i + 1] - values_[i]) / behind - (values_[i] - values_[i - 1]) / before;
        curvatures_[i] = (share - 1) / pivot;
        slope[i] = (6 * bend / (before + behind) - share * slope[i - 1]) / pivot;
    }
    curvatures_.back() = 0;
    for (std::size_t i = places_.size() - 1; i-- > 0;)
    {
        curvatures_[i] = curvatures_[i] * curvatures_[i + 1] + slope[i];
    }
}

double NaturalSpline::operator()(double place) const
{
    if (!(place > places_.front())) { return values_.front(); }
    if (place >= places_.back()) { return values_.back(); }
    const auto above = static_cast<std::size_t>(std::ranges::upper_bound(places_, place) - places_.begin());
    const std::size_t below = above - 1;
    const double width = places_[above] - places_[below];
    const double a = (places_[above] - place) / width;
    const double b = (place - places_[below]) / width;
    return a * values_[below] + b * values_[above] +
           ((a * a * a - a) * curvatures_[below] + (b * b * b - b) * curvatures_[above]) * width * width / 6;
}

double SpaceTimeFunction::Table::operator()(int component, double x, double y, double z, double t) const
{
    const double place = coordinate == 'x' ? x : coordinate == 'y' ? y : coordinate == 'z' ? z : t;
    return columns[static_cast<std::size_t>(component)](place);
}

SpaceTimeFunction::Table readTable(const std::filesystem::path& file, const std::string& name, int components,
                                   const Origin& origin)
{
    Origin whole = origin;
    whole.entry += fmt::format(": table \"{}\"", name);
    const std::string text = readText(file, whole);
    const auto fail = [&name, &origin](int line, const std::string& what, const std::string& advice = "") {
        throw Error(Fault::input, Origin{name, line, origin.entry}, what, advice);
    };

    const std::size_t width = static_cast<std::size_t>(components) + 1;
    std::optional<std::size_t> place; // column of the coordinate
    SpaceTimeFunction::Table table;
    std::vector<std::vector<double>> columns(width);
    int line = 0;
    for (std::size_t begin = 0; begin < text.size();)
    {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view row = trimmed(std::string_view(text).substr(begin, end - begin));
        begin = end + 1;
        ++line;
        if (row.empty() || row[0] == '#') { continue; }

        const std::vector<std::string_view> row_ = cells(row);
        if (row_.size() != width)
        {
            fail(line, fmt::format("has {} columns but must have {}", row_.size(), width),
                 fmt::format("a coordinate and {}", components == 1 ? "the value" : "one column a component"));
        }
        if (!place)
        {
            const auto heading = std::ranges::find_if(row_, isCoordinate);
            if (heading == row_.end())
            {
                fail(line, "names no coordinate column", "head the columns with names, one of them x, y, z or t");
            }
            place = static_cast<std::size_t>(heading - row_.begin());
            table.coordinate = (*heading)[0];
            continue;
        }
        for (std::size_t i = 0; i < width; ++i)
        {
            const std::optional<double> number = numberFrom(row_[i]);
            if (!number || !std::isfinite(*number))
            {
                fail(line, fmt::format("has '{}' where a number should be", row_[i]));
            }
            columns[i].push_back(*number);
        }
        const std::vector<double>& places = columns[*place];
        if (places.size() > 1 && !(places.back() > places[places.size() - 2]))
        {
            fail(line, fmt::format("has {} = {} after {}, but the coordinate must increase", table.coordinate,
                                   places.back(), places[places.size() - 2]));
        }
    }
    if (columns[0].size() < 2) { fail(line, "ends with fewer than two rows of numbers"); }
    for (std::size_t i = 0; i < width; ++i)
    {
        if (i != *place) { table.columns.emplace_back(columns[*place], columns[i]); }
    }
    return table;
}

} // namespace isph
