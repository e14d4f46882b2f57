#include "postProcess.hpp"

#include "runSupport.hpp"

#include "case/TimeState.hpp"
#include "fields/threads.hpp"

#include <fmt/format.h>

namespace isph
{

void postProcess(const CommandLine& line, Log& log)
{
    useRequestedThreads();
    const Case flowCase(line.caseDirectory());
    const std::vector<TimeDirectory> times = selectedTimes(line);
    if (times.empty())
    {
        throw Error(Fault::input, "the options choose no time to run the functions on", "see listTimes");
    }
    Timings timings;
    Scene scene(flowCase, times.front().name);
    const auto flow = makeFlow(scene, timings, PlanEffort::estimated);
    Functions functions = readFunctions(line, flowCase, scene, times.front().name);
    if (functions.empty()) { log.line("controlDict has no functions: nothing to do"); }

    for (const TimeDirectory& time : times)
    {
        const auto state = readTimeState(flowCase.directory(), time.name);
        readFlow(flowCase, time.name, state.has_value(), scene, *flow);
        const TimeState at = state.value_or(TimeState{.time = time.value});
        log.line(fmt::format("Time = {}", time.name));
        functions.executeAll({.flow = *flow,
                              .time = at.time,
                              .name = time.name,
                              .step = at.index,
                              .cpuTime = at.cpuTime,
                              .wallTime = at.wallTime,
                              .timings = timings,
                              .dt = at.deltaT});
    }
}

} // namespace isph
