#include "case/TimeState.hpp"

#include "case/TimeDirectories.hpp"
#include "core/numberText.hpp"
#include "dictionary/Dictionary.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace isph
{

std::string timeStateText(const TimeState& state, const std::string& timeName, std::string_view extra)
{
    std::string text = fmt::format("FoamFile\n{{\n    version     2.0;\n    format      ascii;\n    class       "
                                   "dictionary;\n    location    \"{}/uniform\";\n    object      time;\n}}\n\n",
                                   timeName);
    const auto entry = [&text](std::string_view key, double value, std::string_view meaning)
    { text += fmt::format("{:<12}{:<24}// {}\n", key, numberText(value) + ";", meaning); };

    entry("value", state.time, "[s]");
    text += fmt::format("{:<12}\"{}\";\n", "name", timeName);
    entry("index", static_cast<double>(state.index), "steps since the first start");
    entry("deltaT", state.deltaT, "[s], of the last step");
    entry("nominal", state.nominal, "[s], the last step before it was fitted to output times");
    entry("carry", state.carry, "[s], what the sum of the steps has beyond the last bit of value");
    entry("origin", state.origin, "[s], the first start: output intervals count from here");
    entry("cpuTime", state.cpuTime, "[s], all runs so far");
    entry("wallTime", state.wallTime, "[s], all runs so far");
    if (!extra.empty()) { text += fmt::format("\n{}{}", extra, extra.ends_with('\n') ? "" : "\n"); }
    return text;
}

std::optional<TimeState> readTimeState(const std::filesystem::path& caseDirectory, const std::string& timeName)
{
    const std::string relative = timeName + "/uniform/time";
    if (!std::filesystem::exists(caseDirectory / relative)) { return std::nullopt; }

    const Dictionary dictionary = Dictionary::read(caseDirectory / relative, relative);
    TimeState state;
    state.time = dictionary.number("value");
    state.index = static_cast<long>(dictionary.number("index"));
    state.deltaT = dictionary.number("deltaT");
    state.nominal = dictionary.number("nominal");
    state.carry = dictionary.number("carry");
    state.origin = dictionary.number("origin");
    state.cpuTime = dictionary.number("cpuTime");
    state.wallTime = dictionary.number("wallTime");

    // Names are within a tenth of a step of their time (timeName.hpp).
    const double named = timeOfName(timeName).value_or(state.time);
    const double tolerance = std::max(0.1 * state.deltaT, 1e-9 * std::abs(state.time));
    if (std::abs(named - state.time) > tolerance) { return std::nullopt; }
    return state;
}

} // namespace isph
