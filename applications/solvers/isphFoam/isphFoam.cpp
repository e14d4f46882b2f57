// isphFoam: incompressible SPH in a box, periodic or with walls, by fast transforms.
//
//     makeLattice -case taylorGreen2D
//     isphFoam -case taylorGreen2D
//     isphFoam -case taylorGreen2D -postProcess -latestTime
//
// Reads 0/, constant/ and system/; writes time folders, postProcessing/ and postProcessing/report.json.

#include "postProcess.hpp"
#include "runSupport.hpp"

#include "case/AtomicFolder.hpp"
#include "case/PurgeWrite.hpp"
#include "case/readTimeControl.hpp"
#include "case/RunLock.hpp"
#include "core/FlushDenormals.hpp"
#include "core/runApplication.hpp"
#include "core/signals.hpp"
#include "fields/threads.hpp"
#include "flow/readFlow.hpp"
#include "flow/RunLog.hpp"
#include "flow/stableNumbers.hpp"
#include "flow/StepGuard.hpp"
#include "flow/writeFlow.hpp"
#include "functions/flowListings.hpp"

#include <optional>

using namespace isph;

static void run(const CommandLine& line, Log& log)
{
    if (line.has("postProcess")) { return postProcess(line, log); }

    // Read: everything the run needs, in the order one thing depends on another.
    const FlushDenormals flush;
    Timings timings;
    auto setup = std::make_optional<Timings::Scope>(timings, Phase::setup);
    const int threads = useRequestedThreads();
    const Case flowCase(line.caseDirectory());
    const RunLock lock(flowCase.directory());
    removeLeftovers(flowCase.directory());
    removeLeftovers(flowCase.path("postProcessing"));
    TimeControl control = readTimeControl(flowCase);
    const StartFolder start = findStart(flowCase, control.settings());
    Scene scene(flowCase, start.folder.name);
    Functions functions = readFunctions(line, flowCase, scene, start.folder.name);
    const TimeScheme& scheme = *scene.settings.time;
    RunReport report = openReport(flowCase, scene, threads);

    // Build: the flow in the state of the start folder.
    const auto flow = makeFlow(scene, timings);
    const StartReport started = readFlow(flowCase, start.folder.name, start.restart, scene, *flow);
    warnOfOtherPlans(flowCase, start, *flow, log);
    for (const std::string& caution : flow->cautions()) { log.warning(caution); }
    RunLog runLog(log, line.has("verbose"), control, report, linesOn(started));
    StepGuard guard(log, scheme, control.settings().divergedCo);
    SteadyCheck steady(control.settings().steadyTolerance, *flow);
    ControlDictWatch watch(flowCase);
    PurgeWrite purge(flowCase.directory(), control.settings().purgeWrite);
    setup.reset();

    // March: from here on the case is only written to.
    const auto write = [&]
    {
        const auto scope = timings.scope(Phase::output);
        const std::string name = timeNameOf(flowCase, control);
        writeFlow(flowCase, name, control.state(), scene, *flow);
        purge.wrote(name);
    };
    const auto observe = [&]
    {
        if (functions.empty()) { return; }
        const auto scope = timings.scope(Phase::functions);
        functions.execute(control.event(), flowAtTime(*flow, control, timings));
    };
    const auto finish = [&](Ending ending)
    {
        for (const auto& [field, norm, value] : functions.errors()) { report.errors.push_back({field, norm, value}); }
        runLog.close(report, timings);
        writeReport(flowCase, report.json(control, timings, ending));
    };

    const auto leave = [&](const Error& diverged)
    {
        if (control.steps() > 0) { write(); }
        finish(Ending::diverged);
        throw Error(diverged);
    };

    long transforms = 0; // of steps, not of the rates after the last one
    const auto step = [&](double dt)
    {
        advance(scheme, *flow, control.time(), dt);
        transforms = flow->transforms();
        return flow->rates();
    };

    catchSignals();
    StepRates rates = flow->rates();
    observe();
    while (control.running())
    {
        StepLimits limits = stepLimits(scene.lattice, scene.fluid, scheme, rates, functions.nextTime());
        double dt = 0;
        try
        {
            dt = control.timeStep(limits);
        }
        catch (const Error& noStep) // is left that would reach the end
        {
            leave(noStep);
        }
        StepRates after = step(dt);
        while (const auto shorter = guard.shorter(after, dt, control))
        {
            flow->stepBack();
            rates = flow->rates();
            limits.largestStable = *shorter / control.settings().safetyFactor;
            dt = control.timeStep(limits);
            after = step(dt);
        }
        report.step(guard.judge(rates, dt), transforms);
        notePressure(*flow, report, log);

        rates = after;
        if (const auto diverged = guard.divergence(rates, dt, control))
        {
            flow->stepBack();
            leave(*diverged);
        }
        control.advance();
        if (steady.asked()) { control.noteAcceleration(steady.acceleration(*flow, dt)); }
        if (caughtSignal() != 0) { control.end(Ending::signal); }
        if (control.settings().runTimeModifiable) { watch.refresh(control, log); }

        observe();
        runLog.step(rates, dt, [&] { return divergenceLine(*flow); });
        if (control.writesNow()) { write(); }
    }
    finish(control.ending().value_or(Ending::endTime));
    if (control.ending() == Ending::signal) { throw StoppedBySignal{caughtSignal()}; }
}

int main(int argc, char** argv)
{
    Application application{.name = "isphFoam",
                            .summary = "Incompressible SPH in a box, periodic or with walls, by fast transforms.",
                            .examples = "isphFoam -case cavity\n"
                                        "isphFoam -case taylorGreen2D -postProcess -latestTime",
                            .options = {{"postProcess", "", "run the functions on the times already written"},
                                        {"noFunctionObjects", "", "do not run the functions of controlDict"},
                                        {"verbose", "", "report every step, also on a terminal"}},
                            .listings = flowListings()};
    application.options.insert(application.options.end(), timeOptions.begin(), timeOptions.end());
    return runApplication(application, argc, argv, run);
}
