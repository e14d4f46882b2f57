#pragma once

#include "core/FileDescriptor.hpp"
#include "core/Log.hpp"
#include "RunRecord.hpp"
#include "Sweep.hpp"

namespace isph
{

/// What is known of every run of a sweep, made anew or found on disk; status `missing` where there is none that counts:
/// one that was made from other settings, was stopped at a shorter limit of time, or failed.
std::vector<RunRecord> knownRecords(const Sweep& sweep, const std::filesystem::path& caseDirectory);

/// Held by who makes or removes the runs of a case, as a second one would in the same folders.
/// \throws Error(input) if another sweep of the case is running.
FileDescriptor lockSweep(const std::filesystem::path& folder);

/// Makes the runs that are missing, and the repetitions that are. Progress goes to the log.
/// \throws Error(input) if another sweep of the case is running, or a quantity cannot be got from the first run
/// \throws StoppedBySignal after it has stopped what it started; what has ended by then counts when it goes on.
void runSweep(const Sweep& sweep, const std::filesystem::path& caseDirectory, std::vector<RunRecord>& records,
              Log& log);

/// Seconds of the runs that are still to be made, one job at a time: along a line as a power of the resolution, fitted
/// to what is known of it; where nothing is known of a line, what the others took. Negative: nothing is known at all.
double secondsLeft(const Sweep& sweep, const std::vector<RunRecord>& records);

/// "0:12", "1:02:03"
std::string durationText(double seconds);

} // namespace isph
