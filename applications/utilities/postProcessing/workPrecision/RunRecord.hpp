#pragma once

#include "core/readJson.hpp"
#include "core/Selection.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isph
{

/// How a run ended.
enum class RunStatus
{
    done,
    diverged,
    timeLimit,
    failed,
    missing ///< it has not been made yet
};

/// The words of the table.
const Selection<RunStatus>& runStatuses();

/// What is known of a run that has ended: written into its folder as its last act, so that a run that was killed has
/// none.
struct RunRecord
{
    RunStatus status = RunStatus::missing;
    std::string settings;          ///< hash of everything that it was made from
    std::vector<double> cpuTimes;  ///< of the solver, one a repetition [s]
    std::vector<double> wallTimes; ///< [s]
    long peakMemory = 0;           ///< [bytes]
    double timeLimit = 0;          ///< that it exceeded [s]
    double jobTime = 0;            ///< all of the commands, once [s]
    std::string message;           ///< why it failed, or when it diverged

    double cpuTime() const;
    double wallTime() const;
};

/// The record in a run's folder; nothing if there is none that is whole.
std::optional<RunRecord> readRecord(const std::filesystem::path& folder);

/// \throws Error(input) if the machine refuses.
void writeRecord(const std::filesystem::path& folder, const RunRecord& record);

/// The values of the report that a solver left in a run's folder: none if there is no report, or no whole one, as of a
/// solver that was killed.
JsonValues reportLeft(const std::filesystem::path& folder);

/// FNV-1a, 64 bits, as text: tells whether two texts are the same.
std::string hashOf(std::string_view text);

} // namespace isph
