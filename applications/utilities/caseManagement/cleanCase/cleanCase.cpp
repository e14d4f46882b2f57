// cleanCase: removes what programs have made of a case and can make again.
//
//     cleanCase -case cavity            written times, postProcessing, VTK, logs, constant/lattice
//     cleanCase -case cavity -dryRun    only prints what would go

#include "case/Case.hpp"
#include "case/RunLock.hpp"
#include "case/TimeDirectories.hpp"
#include "core/FileDescriptor.hpp"
#include "core/runApplication.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

using namespace isph;
namespace fs = std::filesystem;

/// The results in a case, relative to it.
static std::vector<fs::path> resultsOf(const Case& theCase)
{
    std::vector<fs::path> results;
    for (const char* name : {"postProcessing", "VTK", "pictures", "0/extended.h5", "0/uniform"})
    {
        if (theCase.has(name)) { results.emplace_back(name); }
    }
    if (theCase.has("constant/lattice") && theCase.has("system/latticeDict"))
    {
        results.emplace_back("constant/lattice");
    }

    // Folder 0 is input; a case without it starts from its first time.
    const std::vector<TimeDirectory> times = timeDirectories(theCase.directory());
    const bool hasZero = findTime(times, 0).has_value();
    for (const TimeDirectory& time : times)
    {
        const bool input = hasZero ? time.value == 0 : time == times.front();
        if (!input) { results.emplace_back(time.name); }
    }

    for (const fs::directory_entry& entry : fs::directory_iterator(theCase.directory()))
    {
        const std::string name = entry.path().filename().string();
        const bool log = name.starts_with("log.") && entry.is_regular_file();
        const bool leftover =
            name.starts_with('.') && (name.find(".tmp-") != name.npos || name.find(".old-") != name.npos);
        if (log || leftover) { results.emplace_back(name); }
    }
    return results;
}

static void run(const CommandLine& line, Log& log)
{
    const Case theCase(line.caseDirectory());
    const bool dryRun = line.has("dryRun");
    std::optional<RunLock> lock; // refuses a case that is being solved
    if (!dryRun) { lock.emplace(theCase.directory()); }

    for (const fs::path& result : resultsOf(theCase))
    {
        if (!dryRun)
        {
            std::error_code error;
            fs::remove_all(theCase.directory() / result, error);
            if (error) { throwRefused(theCase.directory() / result, "could not be removed", error.value()); }
        }
        log.line(fmt::format("{} {}", dryRun ? "Would remove" : "Removed", result.string()));
    }
}

int main(int argc, char** argv)
{
    const Application application{
        .name = "cleanCase",
        .summary = "removes results: written times, postProcessing, VTK, pictures, logs, constant/lattice",
        .examples = "cleanCase -case cavity\ncleanCase -case cavity -dryRun",
        .options = {{"dryRun", "", "print what would be removed, and remove nothing"}},
        .banner = false};
    return runApplication(application, argc, argv, run);
}
