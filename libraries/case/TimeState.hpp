#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace isph
{

/// Where a run is in time, with all that the march needs to go on in the same bits: what <time>/uniform/time holds.
struct TimeState
{
    double time = 0;     ///< [s]
    double carry = 0;    ///< [s], what the sum of all steps has beyond the last bit of `time`
    double origin = 0;   ///< [s], start of the first run: output intervals count from here
    long index = 0;      ///< steps since the origin
    double deltaT = 0;   ///< [s], length of the last step; 0 before the first
    double nominal = 0;  ///< [s], the last step as it was before it was fitted to output times
    double cpuTime = 0;  ///< [s], of all processors and all runs so far
    double wallTime = 0; ///< [s], of all runs so far

    bool operator==(const TimeState&) const = default;
};

/// The text of uniform/time.
/// \param timeName name of the time folder
/// \param extra further entries in dictionary grammar, e.g. of a scheme that restarts need
std::string timeStateText(const TimeState& state, const std::string& timeName, std::string_view extra = "");

/// Reads <timeName>/uniform/time of a case. Nothing if the file is missing, or is about another time than the name
/// says (a folder that was renamed to start a new run).
/// \throws Error(input) if the file is damaged.
std::optional<TimeState> readTimeState(const std::filesystem::path& caseDirectory, const std::string& timeName);

} // namespace isph
