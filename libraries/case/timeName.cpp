#include "case/timeName.hpp"

#include "case/TimeDirectories.hpp"
#include "case/TimeState.hpp"
#include "core/Error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace isph
{

namespace
{

constexpr int allDigits = 17; // enough for every double

constexpr std::array<Selection<TimeFormat>::Variant, 3> formats{{
    {"general", "timePrecision significant digits, fixed or scientific, whichever is shorter", TimeFormat::general},
    {"fixed", "timePrecision digits behind the point", TimeFormat::fixed},
    {"scientific", "one digit before the point, timePrecision behind it, and an exponent", TimeFormat::scientific},
}};
static_assert(distinct(formats));

std::string formatted(double time, TimeFormat format, int precision)
{
    switch (format)
    {
    case TimeFormat::fixed:
        return fmt::format("{:.{}f}", time, precision);
    case TimeFormat::scientific:
        return fmt::format("{:.{}e}", time, precision);
    case TimeFormat::general:
        break;
    }
    return fmt::format("{:.{}g}", time, precision);
}

/// The time a folder holds: the exact one if its uniform/time can say it.
double timeOfFolder(const std::filesystem::path& caseDirectory, const std::string& name)
{
    try
    {
        if (const auto state = readTimeState(caseDirectory, name)) { return state->time; }
    }
    catch (const Error&)
    {
        // A damaged folder is known by its name.
    }
    return timeOfName(name).value_or(0);
}

} // namespace

const Selection<TimeFormat>& timeFormats()
{
    static constexpr Selection<TimeFormat> selection("timeFormat", formats);
    return selection;
}

std::string timeName(double time, double step, TimeFormat format, int precision)
{
    // What is left of a sum that should have been zero.
    if (std::abs(time) <= 1e-9 * step) { time = 0; }
    std::string name;
    for (int digits = precision; digits <= std::max(precision, allDigits); ++digits)
    {
        name = formatted(time, format, digits);
        if (step == 0 || std::abs(timeOfName(name).value_or(time) - time) <= 0.1 * step) { break; }
    }
    return name;
}

std::string unusedTimeName(const std::filesystem::path& caseDirectory, double time, double step, TimeFormat format,
                           int precision)
{
    std::string name = timeName(time, step, format, precision);
    for (int digits = precision + 1; digits <= allDigits; ++digits)
    {
        if (!std::filesystem::exists(caseDirectory / name)) { break; }
        const bool sameTime = std::abs(timeOfFolder(caseDirectory, name) - time) <= 0.1 * step;
        if (sameTime) { break; }
        name = timeName(time, step, format, digits);
    }
    return name;
}

} // namespace isph
