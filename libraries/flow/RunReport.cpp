#include "flow/RunReport.hpp"

#include "core/version.hpp"
#include "core/writeTextFile.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace isph
{

void RunReport::step(const StabilityMargin& ofStep, long transformsSoFar)
{
    transforms = transformsSoFar;
    margin.convective = std::max(margin.convective, ofStep.convective);
    margin.viscous = std::max(margin.viscous, ofStep.viscous);
}

double RunReport::secondsPerPointAndSubstep(const Timings& timings, long steps) const
{
    const double inSteps = timings.seconds(Phase::transforms) + timings.seconds(Phase::pointwise) +
                           timings.seconds(Phase::boundary) + timings.seconds(Phase::continuation) +
                           timings.seconds(Phase::poisson);
    const double substeps = static_cast<double>(steps) * substepsPerStep;
    return steps > 0 ? inSteps / (static_cast<double>(lattice.points()) * substeps) : 0;
}

Json RunReport::json(const TimeControl& control, const Timings& timings, Ending endedBecause) const
{
    Json counts = Json::array();
    Json spacings = Json::array();
    Json axes = Json::array();
    for (int direction = 0; direction < 3; ++direction)
    {
        const Axis& axis = lattice.axis(direction);
        counts.add(axis.count);
        if (!axis.active()) { continue; }
        spacings.add(axis.spacing());
        axes.add(axis.periodic() ? "periodic" : "bounded");
    }
    Json schemes = Json::object();
    for (const auto& [key, value] : scene.schemes) { schemes.set(key, value); }
    Json seconds = Json::object();
    for (std::size_t phase = 0; phase < phaseNames.size(); ++phase)
    {
        seconds.set(phaseNames[phase], timings.seconds(static_cast<Phase>(phase)));
    }
    seconds.set("other", timings.other());

    Json norms = Json::object();
    for (const ReportedError& first : errors)
    {
        Json ofField = Json::object();
        for (const ReportedError& error : errors)
        {
            if (error.field == first.field) { ofField.set(error.norm, error.value); }
        }
        norms.set(first.field, std::move(ofField));
    }
    const double substeps = static_cast<double>(control.steps()) * substepsPerStep;
    Json report = Json::object(
        {{"schema", schema},
         {"version", version},
         {"case", caseName},
         {"endedBecause", toString(endedBecause)},
         {"lattice", Json::object({{"points", counts}, {"spacing", spacings}, {"axes", axes}})},
         {"active", Json::arrayOf(scene.active)},
         {"leftOut", Json::arrayOf(scene.leftOut)},
         {"schemes", schemes},
         {"steps", control.steps()},
         {"time", control.time()},
         {"cpuTime", cpuSeconds()},
         {"wallTime", timings.total()},
         {"threads", threads},
         {"peakMemory", peakMemory()},
         {"seconds", seconds},
         {"transformsPerSubstep", substeps > 0 ? static_cast<double>(transforms) / substeps : 0},
         {"secondsPerPointAndSubstep", secondsPerPointAndSubstep(timings, control.steps())},
         {"stabilityMargin", Json::object({{"convective", margin.convective},
                                           {"viscous", margin.viscous},
                                           {"ruling", margin.convectionRules() ? "convective" : "viscous"}})},
         {"errors", norms}});
    if (pressure)
    {
        report.set("pressureSolver",
                   Json::object({{"name", pressure->name},
                                 {"solves", pressure->solves},
                                 {"iterations", Json::object({{"mean", pressure->meanIterations()},
                                                              {"max", pressure->mostIterations}})},
                                 {"finalResidual", Json::object({{"max", pressure->largestResidual}})},
                                 {"notConverged", pressure->unconverged}}));
    }
    return report;
}

void RunReport::print(Log& log, const TimeControl& control, const Timings& timings) const
{
    const double total = timings.total();
    log.line();
    log.line("Where the time went:");
    const auto line = [&](std::string_view name, double seconds)
    {
        if (seconds >= 0.0005 * total)
        {
            log.line(fmt::format("    {:<14}{:>10.3f} s {:>6.1f} %", name, seconds, 100 * seconds / total));
        }
    };
    for (std::size_t phase = 0; phase < phaseNames.size(); ++phase)
    {
        line(phaseNames[phase], timings.seconds(static_cast<Phase>(phase)));
    }
    line("other", timings.other());
    line("total", total);
    if (control.steps() > 0)
    {
        log.line(fmt::format("{} steps, {:.3g} s a step, {:.3g} ns per point and substep, {:.1f} MB at most",
                             control.steps(), total / static_cast<double>(control.steps()),
                             1e9 * secondsPerPointAndSubstep(timings, control.steps()),
                             static_cast<double>(peakMemory()) / 1e6));
        log.line(fmt::format("Largest step over its limit: convective {:.3g}, viscous {:.3g}", margin.convective,
                             margin.viscous));
    }
    if (pressure && pressure->solves > 0)
    {
        log.line(fmt::format("{}: {:.1f} iterations a solve, at most {}, largest residual {:.3g}", pressure->name,
                             pressure->meanIterations(), pressure->mostIterations, pressure->largestResidual));
    }
    for (const ReportedError& error : errors)
    {
        if (error.norm == "relL2")
        {
            log.line(fmt::format("Relative L2 error of {}: {:.4e}", error.field, error.value));
        }
    }
}

void writeReport(const Case& theCase, const Json& report)
{
    std::filesystem::create_directories(theCase.path("postProcessing"));
    writeTextFile(theCase.path("postProcessing/report.json"), report.text());
}

} // namespace isph
