#include "RunLog.hpp"

#include "flow/flowDiagnostics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace isph
{

namespace
{

void describeStart(Log& log, const StartReport& started)
{
    const auto say = [&log](double part, const std::string& what)
    {
        if (part > 1e-12) { log.line(fmt::format("Start: {} ({:.3g} of its norm)", what, part)); }
    };
    say(started.projected, "the projection changed the velocity");
    say(started.dealiased, "dealiasing dropped modes of the velocity");
    say(started.nyquist, "checkerboard modes were taken out of the velocity");
}

} // namespace

RunLog::RunLog(Log& log, bool verbose, const TimeControl& control, const Scene& scene,
               const SceneDescription& description, const StartReport& started)
    : log_(log), everyStep_(verbose), control_(control)
{
    log.line(fmt::format("Lattice: {} x {} x {} points, spacing {}", scene.lattice.axis(0).count,
                         scene.lattice.axis(1).count, scene.lattice.axis(2).count,
                         scene.lattice.activeAxis(0).spacing()));
    for (const auto& [key, value] : description.schemes) { log.line(fmt::format("    {:<12} {}", key, value)); }
    log.line(fmt::format("Active:   {}", fmt::join(description.active, "; ")));
    log.line(fmt::format("Left out: {}", fmt::join(description.leftOut, "; ")));
    describeStart(log, started);
    log.line();
    if (log.onTerminal() && !verbose) { progress_.emplace(log, control.time(), control.settings().endTime); }
}

void RunLog::step(const StepRates& rates, double dt, IncompressibleFlow& flow)
{
    if (progress_)
    {
        progress_->update(control_.time(), control_.steps());
        return;
    }
    if (!log_.shown()) { return; }
    const Clock::time_point now = Clock::now();
    const bool reported = everyStep_ || control_.steps() == 1 || control_.writesNow() || control_.ending() ||
                          now - lastBlock_ >= std::chrono::seconds(1);
    if (!reported) { return; }
    lastBlock_ = now;

    const DivergenceNorms divergence = divergenceNorms(flow);
    log_.line(fmt::format("Time = {}", control_.timeName()));
    log_.line();
    log_.line(fmt::format("Courant Number mean: {:.6g} max: {:.6g}", dt * rates.meanCourant, dt * rates.courant));
    log_.line(fmt::format("deltaT = {:.6g}", dt));
    log_.line(fmt::format("divergence L2: {:.3g} Linf: {:.3g}", divergence.L2, divergence.Linf));
    log_.line(fmt::format("ExecutionTime = {:.2f} s  ClockTime = {:.2f} s", cpuSeconds(),
                          std::chrono::duration<double>(now - start_).count()));
    log_.line();
}

void RunLog::close(const RunReport& report, const Timings& timings)
{
    progress_.reset();
    report.print(log_, control_, timings);
    log_.line();
}

} // namespace isph
