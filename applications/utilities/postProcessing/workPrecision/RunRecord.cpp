#include "RunRecord.hpp"

#include "core/numberText.hpp"
#include "core/writeTextFile.hpp"
#include "dictionary/Dictionary.hpp"
#include "dictionary/writeDictionary.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fmt/format.h>
#include <limits>

namespace isph
{

namespace
{

constexpr const char* recordName = "workPrecision.record";

double smallestOf(const std::vector<double>& times)
{
    return times.empty() ? std::numeric_limits<double>::quiet_NaN() : std::ranges::min(times);
}

std::string listText(const std::vector<double>& values)
{
    std::string text = "(";
    for (const double value : values) { text += fmt::format("{}{}", text == "(" ? "" : " ", numberText(value)); }
    return text + ")";
}

/// As a string of a dictionary: one line, no quotes.
std::string plain(std::string text)
{
    std::ranges::replace(text, '"', '\'');
    std::ranges::replace(text, '\n', ' ');
    std::ranges::replace(text, '\\', '/');
    return text;
}

} // namespace

const Selection<RunStatus>& runStatuses()
{
    using enum RunStatus;
    static constexpr std::array<Selection<RunStatus>::Variant, 5> table{{
        {"done", "ended as it should", done},
        {"diverged", "left the finite numbers", diverged},
        {"timeLimit", "was stopped because it took too long", timeLimit},
        {"failed", "ended with an error", failed},
        {"missing", "has not been made", missing},
    }};
    static_assert(distinct(table));
    static constexpr Selection<RunStatus> selection("status", table);
    return selection;
}

double RunRecord::cpuTime() const { return smallestOf(cpuTimes); }
double RunRecord::wallTime() const { return smallestOf(wallTimes); }

std::optional<RunRecord> readRecord(const std::filesystem::path& folder)
{
    if (!std::filesystem::exists(folder / recordName)) { return std::nullopt; }
    try
    {
        const Dictionary dictionary = Dictionary::read(folder / recordName, recordName);
        RunRecord record;
        record.status = runStatuses()[dictionary.word("status")];
        record.settings = dictionary.text("settings");
        record.cpuTimes = dictionary.numbers("cpuTimes");
        record.wallTimes = dictionary.numbers("wallTimes");
        record.peakMemory = static_cast<long>(dictionary.number("peakMemory"));
        record.timeLimit = dictionary.number("timeLimit");
        record.jobTime = dictionary.number("jobTime");
        record.message = dictionary.text("message");
        return record;
    }
    catch (const Error&)
    {
        return std::nullopt; // of another version: the run is made anew
    }
}

void writeRecord(const std::filesystem::path& folder, const RunRecord& record)
{
    writeTextFile(folder / recordName,
                  foamHeader("dictionary", recordName) +
                      fmt::format("status {};\nsettings \"{}\";\ncpuTimes {};\nwallTimes {};\npeakMemory {};\n"
                                  "timeLimit {};\njobTime {};\nmessage \"{}\";\n",
                                  runStatuses().nameOf(record.status), record.settings, listText(record.cpuTimes),
                                  listText(record.wallTimes), record.peakMemory, numberText(record.timeLimit),
                                  numberText(record.jobTime), plain(record.message)));
}

JsonValues reportLeft(const std::filesystem::path& folder)
{
    const std::filesystem::path file = folder / "postProcessing" / "report.json";
    try
    {
        return std::filesystem::exists(file) ? readJson(file, file.string()) : JsonValues{};
    }
    catch (const Error&)
    {
        return {};
    }
}

std::string hashOf(std::string_view text)
{
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : text)
    {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3U;
    }
    return fmt::format("{:016x}", hash);
}

} // namespace isph
