#include "case/TimeDirectories.hpp"

#include "core/Error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

namespace isph
{

namespace
{

/// What one digit more or less in the last place of a number's name amounts to: 1e-6 for "0.333333", 1e3 for "5e3".
double lastDigit(std::string_view name)
{
    const std::size_t mantissaEnd = std::min(name.find_first_of("eE"), name.size());
    const std::size_t point = std::min(name.find('.'), mantissaEnd);
    const auto decimals = point < mantissaEnd ? static_cast<int>(mantissaEnd - point) - 1 : 0;
    int exponent = 0;
    if (mantissaEnd < name.size())
    {
        std::string_view digits = name.substr(mantissaEnd + 1);
        if (digits.starts_with('+')) { digits.remove_prefix(1); }
        std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    }
    return std::pow(10.0, exponent - decimals);
}

std::string namesOf(std::span<const TimeDirectory> times)
{
    constexpr std::size_t shown = 12;
    std::string text;
    for (std::size_t i = 0; i < times.size(); ++i)
    {
        // The first ones and the last one of many.
        if (times.size() > shown && i == shown - 2) { text.append(", ..."); }
        if (times.size() > shown && i >= shown - 2 && i + 1 < times.size()) { continue; }
        text.append(text.empty() ? "" : ", ").append(times[i].name);
    }
    return text.empty() ? "the case has no time folders" : fmt::format("the case has {}", text);
}

/// A bound of a range; the fallback where nothing is written.
double bound(std::string_view text, double fallback, const std::string& whole)
{
    if (text.empty()) { return fallback; }
    const auto value = timeOfName(text);
    if (!value)
    {
        throw Error(Fault::usage, fmt::format("-time {}: '{}' is not a number", whole, text),
                    "write times and ranges like 0.1,0.5:1 or :2 or 3:");
    }
    return *value;
}

} // namespace

std::optional<double> timeOfName(std::string_view name)
{
    // from_chars would also take "inf", "nan" and, with a sign in front, nothing else that a number needs.
    if (name.find_first_not_of("0123456789+-.eE") != std::string_view::npos) { return std::nullopt; }
    if (name.starts_with('+')) { name.remove_prefix(1); }
    double value = 0;
    const auto result = std::from_chars(name.data(), name.data() + name.size(), value);
    const bool whole = result.ec == std::errc() && result.ptr == name.data() + name.size();
    return whole ? std::optional(value) : std::nullopt;
}

bool standsFor(std::string_view name, double time)
{
    const auto value = timeOfName(name);
    if (!value) { return false; }
    const double tolerance = std::min(lastDigit(name) * (1 + 1e-9), 1e-5 * std::abs(*value));
    return std::abs(*value - time) <= tolerance;
}

std::vector<TimeDirectory> timeDirectories(const std::filesystem::path& caseDirectory)
{
    std::vector<TimeDirectory> times;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(caseDirectory, error))
    {
        const std::string name = entry.path().filename().string();
        const auto value = timeOfName(name);
        std::error_code ignored;
        if (value && entry.is_directory(ignored)) { times.push_back({*value, name}); }
    }
    if (error)
    {
        throw Error(Fault::input, {caseDirectory.string(), 0, ""}, "could not be read: " + error.message(),
                    "choose a case with -case DIR");
    }
    std::ranges::sort(times, [](const TimeDirectory& a, const TimeDirectory& b)
                      { return a.value != b.value ? a.value < b.value : a.name < b.name; });
    return times;
}

std::optional<TimeDirectory> findTime(std::span<const TimeDirectory> times, double time)
{
    const auto distance = [time](const TimeDirectory& folder) { return std::abs(folder.value - time); };
    const auto nearest = std::ranges::min_element(times, {}, distance);
    if (nearest == times.end() || !standsFor(nearest->name, time)) { return std::nullopt; }
    return *nearest;
}

TimeRanges::TimeRanges(const std::string& text)
{
    std::string_view rest = text;
    while (!rest.empty())
    {
        const std::size_t end = std::min(rest.find_first_of(", "), rest.size());
        const std::string_view item = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (item.empty()) { continue; }

        const std::size_t colon = item.find(':');
        Range range;
        range.text = item;
        range.single = colon == std::string_view::npos;
        if (range.single) { range.from = range.to = bound(item, 0, text); }
        else
        {
            constexpr double infinity = std::numeric_limits<double>::infinity();
            range.from = bound(item.substr(0, colon), -infinity, text);
            range.to = bound(item.substr(colon + 1), infinity, text);
        }
        if (range.from > range.to)
        {
            throw Error(Fault::usage, fmt::format("-time {}: the range {} ends before it begins", text, item),
                        "write the earlier time first");
        }
        ranges_.push_back(range);
    }
    if (ranges_.empty())
    {
        throw Error(Fault::usage, "-time is empty", "write times and ranges like 0.1,0.5:1 or :2 or 3:");
    }
}

std::vector<TimeDirectory> TimeRanges::select(std::span<const TimeDirectory> times) const
{
    std::vector<bool> selected(times.size(), false);
    for (const Range& range : ranges_)
    {
        if (range.single)
        {
            const auto found = findTime(times, range.from);
            if (!found)
            {
                throw Error(Fault::input, fmt::format("there is no time folder {}", range.text), namesOf(times));
            }
            selected[static_cast<std::size_t>(std::ranges::find(times, *found) - times.begin())] = true;
            continue;
        }
        for (std::size_t i = 0; i < times.size(); ++i)
        {
            const bool inside = times[i].value >= range.from && times[i].value <= range.to;
            const bool onBound = standsFor(times[i].name, range.from) || standsFor(times[i].name, range.to);
            if (inside || onBound) { selected[i] = true; }
        }
    }

    std::vector<TimeDirectory> result;
    for (std::size_t i = 0; i < times.size(); ++i)
    {
        if (selected[i]) { result.push_back(times[i]); }
    }
    return result;
}

std::vector<TimeDirectory> selectTimes(std::span<const TimeDirectory> times, const CommandLine& line)
{
    std::vector<TimeDirectory> candidates(times.begin(), times.end());
    if (line.has("noZero"))
    {
        std::erase_if(candidates, [](const TimeDirectory& time) { return time.value == 0; });
    }
    if (!line.has("time") && !line.has("latestTime")) { return candidates; }

    std::vector<TimeDirectory> result;
    if (const auto ranges = line.value("time")) { result = TimeRanges(*ranges).select(candidates); }
    if (line.has("latestTime") && !candidates.empty() && (result.empty() || result.back() != candidates.back()))
    {
        result.push_back(candidates.back());
    }
    return result;
}

std::vector<TimeDirectory> selectedTimes(const CommandLine& line)
{
    const std::vector<TimeDirectory> times = timeDirectories(line.caseDirectory());
    std::vector<TimeDirectory> selected = selectTimes(times, line);
    if (selected.empty()) { throw Error(Fault::input, "no time folder is selected", namesOf(times)); }
    return selected;
}

} // namespace isph
