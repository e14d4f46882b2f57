#include "runSupport.hpp"

#include "flow/flowDiagnostics.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace isph
{

Functions readFunctions(const CommandLine& line, const Case& flowCase, const Scene& scene, const std::string& startTime)
{
    const Dictionary controlDict = flowCase.dictionary("system/controlDict");
    if (line.has("noFunctionObjects") || !controlDict.hasDictionary("functions")) { return {}; }
    return Functions(controlDict.dictionary("functions"), {.theCase = flowCase,
                                                           .lattice = scene.lattice,
                                                           .fluid = scene.fluid,
                                                           .startTime = startTime,
                                                           .pressureScale = scene.files.pressureScale,
                                                           .pressureUnit = scene.files.pressureUnit,
                                                           .pressureFixed = scene.boundary.fixesPressure(),
                                                           .boundary = &scene.boundary,
                                                           .besideRun = line.has("postProcess")});
}

std::vector<std::string> linesOn(const StartReport& started)
{
    std::vector<std::string> lines;
    const auto say = [&lines](double part, const std::string& what)
    {
        if (part > 1e-12) { lines.push_back(fmt::format("Start: {} ({:.3g} of its norm)", what, part)); }
    };
    say(started.projected, "the projection changed the velocity");
    say(started.dealiased, "dealiasing dropped modes of the velocity");
    say(started.nyquist, "checkerboard modes were taken out of the velocity");
    return lines;
}

std::string divergenceLine(IncompressibleFlow& flow)
{
    const DivergenceNorms divergence = divergenceNorms(flow);
    std::string line = fmt::format("divergence L2: {:.3g} Linf: {:.3g}", divergence.L2, divergence.Linf);
    if (const auto viscous = flow.viscousStep(); !viscous.empty())
    {
        line += fmt::format("\nviscous term: {}", viscous);
    }
    if (const PressureRecord* pressure = flow.pressureRecord()) { line = pressure->line() + "\n" + line; }
    return line;
}

void notePressure(const IncompressibleFlow& flow, RunReport& report, Log& log)
{
    const PressureRecord* record = flow.pressureRecord();
    if (record == nullptr) { return; }
    const long before = report.pressure ? report.pressure->unconverged : 0;
    for (long n = before; n < record->unconverged; ++n)
    {
        log.warning("the pressure did not reach its tolerance; the run goes on with what it has (p.maxIter and "
                    "p.tolerance in system/solution)");
    }
    report.pressure = *record;
}

FlowAtTime flowAtTime(IncompressibleFlow& flow, const TimeControl& control, const Timings& timings)
{
    const TimeState state = control.state();
    return {.flow = flow,
            .time = state.time,
            .name = control.timeName(),
            .step = state.index,
            .cpuTime = state.cpuTime,
            .wallTime = state.wallTime,
            .timings = timings,
            .dt = control.lastStep()};
}

RunReport openReport(const Case& flowCase, const Scene& scene, int threads)
{
    RunReport report;
    report.caseName = flowCase.name();
    report.lattice = scene.lattice;
    report.scene = describeScene(scene.lattice, scene.fluid, scene.settings);
    report.threads = threads;
    report.substepsPerStep = static_cast<int>(scene.settings.time->substeps.size());
    return report;
}

void warnOfOtherPlans(const Case& flowCase, const StartFolder& start, const IncompressibleFlow& flow, Log& log)
{
    if (!start.restart) { return; }
    const Dictionary state = flowCase.dictionary(start.folder.name + "/uniform/time");
    if (!state.has("transformPlans") || state.text("transformPlans") == flow.planFingerprint()) { return; }
    log.warning(
        "this restart uses other transform plans than the run that wrote its start: it goes on within round-off, "
        "not in the same bits (another machine, thread count or wisdom)");
}

SteadyCheck::SteadyCheck(const std::optional<double>& tolerance, IncompressibleFlow& flow)
{
    if (tolerance) { previous_ = copyOf(flow.velocity()); }
}

double SteadyCheck::acceleration(IncompressibleFlow& flow, double dt)
{
    const RealField& velocity = flow.velocity();
    double largest2 = 0;
    for (std::size_t i = 0; i < velocity.size(); ++i)
    {
        double change2 = 0;
        for (int c = 0; c < velocity.components(); ++c)
        {
            const double change = velocity[c][i] - previous_[c][i];
            change2 += change * change;
            previous_[c][i] = velocity[c][i];
        }
        largest2 = std::max(largest2, change2);
    }
    return std::sqrt(largest2) / dt;
}

} // namespace isph
