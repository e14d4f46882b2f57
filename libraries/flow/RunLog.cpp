#include "flow/RunLog.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace isph
{

RunLog::RunLog(Log& log, bool verbose, const TimeControl& control, const RunReport& report,
               const std::vector<std::string>& notes)
    : log_(log), everyStep_(verbose), control_(control)
{
    log.line(fmt::format("Lattice: {} x {} x {} points, spacing {}", report.lattice.axis(0).count,
                         report.lattice.axis(1).count, report.lattice.axis(2).count,
                         report.lattice.activeAxis(0).spacing()));
    for (const auto& [key, value] : report.scene.schemes) { log.line(fmt::format("    {:<12} {}", key, value)); }
    log.line(fmt::format("Active:   {}", fmt::join(report.scene.active, "; ")));
    log.line(fmt::format("Left out: {}", fmt::join(report.scene.leftOut, "; ")));
    for (const std::string& note : notes) { log.line(note); }
    log.line();
    if (log.onTerminal() && !verbose) { progress_.emplace(log, control.time(), control.settings().endTime); }
}

void RunLog::step(const StepRates& rates, double dt, const std::function<std::string()>& state)
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

    log_.line(fmt::format("Time = {}", control_.timeName()));
    log_.line();
    log_.line(fmt::format("Courant Number mean: {:.6g} max: {:.6g}", dt * rates.meanCourant, dt * rates.courant));
    log_.line(fmt::format("deltaT = {:.6g}", dt));
    log_.line(state());
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
