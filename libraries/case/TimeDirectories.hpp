#pragma once

#include "core/CommandLine.hpp"

#include <filesystem>
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

/// Whether a name, rounded as it is, stands for a time: they differ by no more than a unit of the name's last digit,
/// and by no more than 1e-5 of it.
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
    /// \throws Error(input) if there is none for a single value.
    std::vector<TimeDirectory> select(std::span<const TimeDirectory> times) const;

private:
    struct Range
    {
        double from = 0;
        double to = 0;
        bool single = false;
        std::string text;
    };
    std::vector<Range> ranges_;
};

/// The times that -time, -latestTime and -noZero choose; all of them without an option. May be empty.
std::vector<TimeDirectory> selectTimes(std::span<const TimeDirectory> times, const CommandLine& line);

/// The same for the time folders of the case (-case).
/// \throws Error(input) if there is no such folder: a program that works on times has nothing to do.
std::vector<TimeDirectory> selectedTimes(const CommandLine& line);

} // namespace isph
