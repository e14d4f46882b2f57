#pragma once

#include "core/CommandLine.hpp"
#include "core/Selection.hpp"

#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isph
{

/// A folder of a case that is named by a number.
struct TimeDirectory
{
    double value;     ///< what its name reads [s]; the exact time is in uniform/time
    std::string name; ///< e.g. "0.25"

    bool operator==(const TimeDirectory&) const = default;
};

/// The time a folder name stands for; nothing if it is not a number ("0.orig", "constant", ".0.25.tmp-4711").
std::optional<double> timeOfName(std::string_view name);

/// Whether a name, rounded as it is, stands for a time: they differ by no more than a unit of the last digit of the
/// name, or a millionth if the name has fewer digits than that.
bool standsFor(std::string_view name, double time);

/// The time folders of a case, earliest first.
std::vector<TimeDirectory> timeDirectories(const std::filesystem::path& caseDirectory);

/// The folder that stands for a time, the nearest if several do.
std::optional<TimeDirectory> findTime(std::span<const TimeDirectory> times, double time);

/// Times as -time takes them: "0.1,0.5:1", open ranges ":1" and "0.5:"; bounds included.
class TimeRanges
{
public:
    /// \throws Error(usage) if the text is none.
    explicit TimeRanges(const std::string& text);

    /// The times that the ranges hold; a single value picks the folder that stands for it.
    /// \throws Error(input) if a single value or a range picks nothing.
    std::vector<TimeDirectory> select(std::span<const TimeDirectory> times) const;

private:
    struct Range
    {
        double from;
        double to;
        std::string text;
    };
    std::vector<Range> ranges_;
};

/// The times that -time, -latestTime and -noZero choose; all of them without an option. May be empty only if nothing
/// was asked for by -time.
std::vector<TimeDirectory> selectTimes(std::span<const TimeDirectory> times, const CommandLine& line);

/// How times are written as names.
enum class TimeFormat
{
    general,
    fixed,
    scientific
};
const Selection<TimeFormat>& timeFormats();

/// The name of a time, with as many digits beyond the precision as it takes to read back within a tenth of a step:
/// no two steps of a run have the same name.
/// \param step length of the step [s] that led there; 0: all digits that the precision does not show are round-off
std::string timeName(double time, double step, TimeFormat format = TimeFormat::general, int precision = 6);

/// timeName with still more digits where a folder of that name holds another time (its uniform/time says so).
std::string unusedTimeName(const std::filesystem::path& caseDirectory, double time, double step, TimeFormat format,
                           int precision);

} // namespace isph
