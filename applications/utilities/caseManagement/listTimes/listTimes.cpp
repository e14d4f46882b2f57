// listTimes: the time folders of a case, a line each, earliest first; or removes them.
//
//     listTimes -case cavity                 the times that were written (not 0)
//     listTimes -case cavity -withZero       with 0
//     listTimes -case cavity -latestTime
//     listTimes -case cavity -time 0.5: -rm  removes the times from 0.5 on

#include "case/AtomicFolder.hpp"
#include "case/Case.hpp"
#include "case/RunLock.hpp"
#include "case/TimeDirectories.hpp"
#include "core/runApplication.hpp"

#include <fmt/format.h>
#include <iostream>

using namespace isph;

static void run(const CommandLine& line, Log& log)
{
    const Case theCase(line.caseDirectory());
    std::vector<TimeDirectory> times = timeDirectories(theCase.directory());
    if (!line.has("withZero"))
    {
        std::erase_if(times, [](const TimeDirectory& time) { return time.value == 0; });
    }
    times = selectTimes(times, line);

    if (!line.has("rm"))
    {
        for (const TimeDirectory& time : times) { std::cout << time.name << '\n'; }
        return;
    }
    const RunLock lock(theCase.directory()); // what a solver has just written is not taken from under it
    for (const TimeDirectory& time : times)
    {
        removeFolder(theCase.path(time.name));
        log.line(fmt::format("Removed {}", time.name));
    }
}

int main(int argc, char** argv)
{
    Application application{.name = "listTimes",
                            .summary = "lists the time folders of a case, or removes them",
                            .examples = "listTimes -case cavity\nlistTimes -case cavity -latestTime\n"
                                        "listTimes -case cavity -time 0.5: -rm",
                            .options = timeOptions,
                            .banner = false};
    application.options.push_back({"withZero", "", "list time 0 too (-noZero has precedence)"});
    application.options.push_back({"rm", "", "remove the selected time folders"});
    return runApplication(application, argc, argv, run);
}
