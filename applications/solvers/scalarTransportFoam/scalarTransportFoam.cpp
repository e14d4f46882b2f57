// scalarTransportFoam: a scalar T carried by a given velocity, by fast transforms.
//
//     makeLattice -case gaussianVortexConvection
//     scalarTransportFoam -case gaussianVortexConvection
//
// Reads 0/T, 0/U, constant/ and system/; writes time folders, postProcessing/ and postProcessing/report.json.

#include "case/AtomicFolder.hpp"
#include "case/PurgeWrite.hpp"
#include "case/readTimeControl.hpp"
#include "case/RunLock.hpp"
#include "core/FlushDenormals.hpp"
#include "core/runApplication.hpp"
#include "core/signals.hpp"
#include "fields/threads.hpp"
#include "flow/RunLog.hpp"
#include "flow/stableNumbers.hpp"
#include "flow/StepGuard.hpp"
#include "functions/flowListings.hpp"
#include "transport/readScalarFunctions.hpp"
#include "transport/TransportScene.hpp"
#include "transport/writeTransport.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

using namespace isph;

static RunReport openReport(const Case& theCase, const TransportScene& scene, const ScalarTransport& transport,
                            int threads)
{
    RunReport report;
    report.caseName = theCase.name();
    report.lattice = scene.lattice;
    report.scene = describeTransport(scene, transport);
    report.threads = threads;
    report.substepsPerStep = static_cast<int>(scene.settings.time->substeps.size());
    return report;
}

static Error divergence(const StepGuard& guard, const TimeControl& control, double largest)
{
    const std::string grown = std::isfinite(largest)
                                  ? fmt::format("reached {:.3g}, far beyond what start and walls allow", largest)
                                  : std::string("is no longer finite");
    return guard.diverged(
        fmt::format("the solution diverged in the step after time {}: T {}", control.timeName(), grown),
        "the scalar is under-resolved or its continuation is not robust for it; try continuation { degree 3; }, filter "
        "{ type exponential; }, or more points");
}

static void run(const CommandLine& line, Log& log)
{
    // Read: everything the run needs, in the order one thing depends on another.
    const FlushDenormals flush;
    Timings timings;
    auto setup = std::make_optional<Timings::Scope>(timings, Phase::setup);
    const int threads = useRequestedThreads();
    const Case theCase(line.caseDirectory());
    const RunLock lock(theCase.directory());
    removeLeftovers(theCase.directory());
    removeLeftovers(theCase.path("postProcessing"));
    TimeControl control = readTimeControl(theCase);
    const StartFolder start = findStart(theCase, control.settings());
    TransportScene scene(theCase, start.folder.name);
    const TimeScheme& scheme = *scene.settings.time;
    ScalarFunctions functions;
    if (!line.has("noFunctionObjects"))
    {
        functions = readScalarFunctions(theCase, scene.lattice, start.folder.name, scene.file.unit);
    }

    // Build: the scalar in the state of the start folder.
    ScalarTransport transport(scene.lattice, scene.diffusivity, scene.settings, *scene.velocity, scene.boundary,
                              timings);
    const double dropped = startTransport(theCase, start.folder.name, start.restart, control.time(), scene, transport);
    std::vector<std::string> notes;
    if (dropped > 1e-12) { notes.push_back(fmt::format("Start: dealiasing dropped {:.3g} of the norm of T", dropped)); }
    RunReport report = openReport(theCase, scene, transport, threads);
    RunLog runLog(log, line.has("verbose"), control, report, notes);
    StepGuard guard(log, scheme, control.settings().divergedCo);
    ControlDictWatch watch(theCase);
    PurgeWrite purge(theCase.directory(), control.settings().purgeWrite);
    Fluid carrier;
    carrier.nu = scene.diffusivity;
    setup.reset();

    // March: from here on the case is only written to.
    const auto write = [&]
    {
        const auto scope = timings.scope(Phase::output);
        const std::string name = timeNameOf(theCase, control);
        writeTransport(theCase, name, control.state(), scene, transport);
        purge.wrote(name);
    };
    const auto observe = [&]
    {
        const auto scope = timings.scope(Phase::functions);
        const TimeState state = control.state();
        functions.execute(control.event(), {.T = transport.values(),
                                            .U = transport.velocity(),
                                            .time = state.time,
                                            .name = control.timeName(),
                                            .step = state.index,
                                            .cpuTime = state.cpuTime,
                                            .wallTime = state.wallTime});
    };
    const auto finish = [&](Ending ending)
    {
        for (const auto& [field, norm, value] : functions.errors()) { report.errors.push_back({field, norm, value}); }
        runLog.close(report, timings);
        writeReport(theCase, report.json(control, timings, ending));
    };

    catchSignals();
    StepRates rates = transport.rates(control.time());
    observe();
    while (control.running())
    {
        const double dt = control.timeStep(stepLimits(scene.lattice, carrier, scheme, rates, functions.nextTime()));
        const StabilityMargin margin = guard.judge(rates, dt);
        transport.step(control.time(), dt);
        report.step(margin, transport.transforms());

        if (!transport.sound(control.settings().divergedCo))
        {
            const double largest = transport.largest();
            transport.stepBack();
            if (control.steps() > 0) { write(); }
            finish(Ending::diverged);
            throw divergence(guard, control, largest);
        }
        control.advance();
        rates = transport.rates(control.time());
        if (control.settings().steadyTolerance) { control.noteAcceleration(transport.rateOfChange(dt)); }
        if (caughtSignal() != 0) { control.end(Ending::signal); }
        if (control.settings().runTimeModifiable) { watch.refresh(control, log); }

        observe();
        runLog.step(rates, dt,
                    [&]
                    {
                        const auto [least, most] = std::ranges::minmax(transport.values()[0]);
                        return fmt::format("T min: {:.6g} max: {:.6g}", least, most);
                    });
        if (control.writesNow()) { write(); }
    }
    finish(control.ending().value_or(Ending::endTime));
    if (control.ending() == Ending::signal) { throw StoppedBySignal{caughtSignal()}; }
}

int main(int argc, char** argv)
{
    std::vector<Listing> listings{{"listConditions", [] { return scalarConditions().words(); }},
                                  {"listFunctions", [] { return scalarFunctionTypes(); }}};
    for (const Listing& listing : flowListings())
    {
        if (listing.option != "listFunctions") { listings.push_back(listing); }
    }
    const Application application{.name = "scalarTransportFoam",
                                  .summary = "A scalar carried by a given velocity, by fast transforms.",
                                  .examples = "scalarTransportFoam -case gaussianVortexConvection",
                                  .options = {{"noFunctionObjects", "", "do not run the functions of controlDict"},
                                              {"verbose", "", "report every step, also on a terminal"}},
                                  .listings = std::move(listings)};
    return runApplication(application, argc, argv, run);
}
