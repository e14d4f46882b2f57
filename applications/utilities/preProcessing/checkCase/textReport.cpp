#include "reports.hpp"

#include "lattice/fastCounts.hpp"
#include "lattice/memoryEstimate.hpp"
#include "lattice/readLattice.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace isph
{

namespace
{

class Reporter
{
public:
    Reporter(const CaseCheck& check, Log& log) : check_(check), reading_(check.reading), log_(log) {}

    void print() const
    {
        printLattice();
        printScene();
        printChoices("Schemes", check_.choices.schemes);
        printChoices("Solution", check_.choices.solution);
        printIdle();
        printKernel();
        printCost();
        printSteps();
        printList("Not looked at, because of the errors", reading_.unread);
        printWarnings();
    }

private:
    static constexpr int width = 26; ///< of the first column

    void title(std::string_view text) const { log_.line(fmt::format("{}", text)); }
    void row(std::string_view name, const std::string& value) const
    {
        log_.line(fmt::format("    {:<{}}  {}", name, width, value));
    }
    void printList(std::string_view name, const std::vector<std::string>& items) const;
    void printLattice() const;
    void printScene() const;
    void printChoices(std::string_view name, const std::vector<Choice>& choices) const;
    void printIdle() const;
    void printKernel() const;
    void printCost() const;
    void printSteps() const;
    void printLimits() const;
    void printWarnings() const;
    std::string perAxis(const std::array<double, 3>& values) const;

    const CaseCheck& check_;
    const CaseReading& reading_;
    Log& log_;
};

void Reporter::printList(std::string_view name, const std::vector<std::string>& items) const
{
    if (items.empty()) { return; }
    title(name);
    for (const std::string& item : items) { log_.line("    " + item); }
    log_.line();
}

void Reporter::printLattice() const
{
    if (!reading_.lattice) { return; }
    title("Lattice");
    for (int direction = 0; direction < 3; ++direction)
    {
        const Axis& axis = reading_.lattice->axis(direction);
        const std::string name(1, axis.name);
        if (!axis.active())
        {
            row(name, "left out");
            continue;
        }
        const int length = axis.periodic() || axis.staggered ? axis.count : axis.count - 1;
        row(name, fmt::format("{} points from {:.6g} to {:.6g} m, spacing {:.6g} m, {}{}, transforms {}", axis.count,
                              axis.origin, axis.origin + axis.extent, axis.spacing(), toString(axis),
                              axis.staggered ? ", half a spacing inside" : "", isFastCount(length) ? "fast" : "slow"));
    }
    log_.line();
}

void Reporter::printScene() const
{
    if (!check_.scene) { return; }
    printList("Active", check_.scene->active);
    printList("Left out", check_.scene->leftOut);
}

void Reporter::printChoices(std::string_view name, const std::vector<Choice>& choices) const
{
    if (choices.empty()) { return; }
    title(name);
    for (const Choice& choice : choices)
    {
        row(choice.key,
            fmt::format("{:<20} {}", choice.value + (choice.unit.empty() ? "" : " " + choice.unit), choice.from));
    }
    log_.line();
}

void Reporter::printIdle() const
{
    if (check_.choices.idle.empty()) { return; }
    title("Written, but without effect here");
    for (const Idle& idle : check_.choices.idle)
    {
        log_.line(fmt::format("    {}: {}", toString(idle.origin), idle.why));
    }
    log_.line();
}

std::string Reporter::perAxis(const std::array<double, 3>& values) const
{
    const auto count = static_cast<std::size_t>(reading_.lattice->dimensions());
    const std::span<const double> used(values.data(), count);
    const bool alike =
        std::ranges::all_of(used, [&](double value) { return std::abs(value - used[0]) <= 1e-9 * used[0]; });
    return alike ? fmt::format("{:.6g} m", used[0]) : fmt::format("{:.6g} m along the axes", fmt::join(used, ", "));
}

void Reporter::printKernel() const
{
    if (!check_.kernel) { return; }
    const KernelResolution& kernel = *check_.kernel;
    const KernelSettings& settings = reading_.settings->kernel;
    title("Resolution of the kernel");
    if (settings.exact()) { row("smoothing length", "none: the exact derivative of every wave on the lattice"); }
    else
    {
        row("smoothing length h", fmt::format("{} dx = {}", settings.smoothingLength, perAxis(kernel.h)));
        row("support", kernel.supportPoints ? fmt::format("{} h = {:.4g} dx: {} neighbours", settings.supportRadius,
                                                          *kernel.supportPoints, kernel.neighbours)
                                            : "unlimited: the closed symbol is not cut off");
        row("cut-off (half height)",
            !kernel.cutOff ? "beyond every wave on the lattice"
            : *kernel.cutOff < 1
                ? fmt::format("{:.3g} of the Nyquist wavenumber: a wave of {:.3g} points", *kernel.cutOff,
                              2 / *kernel.cutOff)
                : fmt::format("{:.3g} of the Nyquist wavenumber: the lattice ends before", *kernel.cutOff));
    }
    if (settings.symbol == KernelSettings::Symbol::sampled)
    {
        row("error of long waves", fmt::format("{:.1e}, a floor that more points do not lower", kernel.defect));
    }
    for (const KernelResolution::Wave& wave : kernel.waves)
    {
        const auto error = [](double value) { return value < 1e-14 ? "round-off" : fmt::format("{:.1e}", value); };
        row(fmt::format("error of {} points a wave", wave.pointsPerWavelength),
            fmt::format("gradient {}{}", error(wave.gradient),
                        wave.laplacian ? ", Laplacian " + error(*wave.laplacian) : ""));
    }
    log_.line();
}

void Reporter::printCost() const
{
    if (!check_.memory) { return; }
    title("Cost");
    if (check_.scene)
    {
        const auto substeps = static_cast<int>(reading_.settings->time->substeps.size());
        row("transforms", fmt::format("{} a substep, {} a step{}", check_.scene->transformsPerSubstep,
                                      substeps * check_.scene->transformsPerSubstep,
                                      check_.scene->transformsOfLines ? ", each of the lines along one axis" : ""));
    }
    row("memory", fmt::format("about {} of {}", memoryText(*check_.memory), memoryText(machineMemory())));
    log_.line();
}

void Reporter::printLimits() const
{
    const StepForecast& steps = *check_.steps;
    const FlowSettings& settings = *reading_.settings;
    const bool convects = settings.convection != ConvectionForm::none;
    const std::string_view viscosity = reading_.scalar ? "DT" : "nu";
    if (!convects) { row("largest Courant number", "no limit: nothing is convected"); }
    else if (settings.time->imaginaryLimit == 0)
    {
        const double step = steps.rates.unbalancedConvection > 0 ? 2 / steps.rates.unbalancedConvection : unlimited;
        row("largest Courant number", fmt::format("none: {} needs dt <= 2 {}/|u|^2 instead, here {:.4g} s",
                                                  timeSchemes().nameOf(settings.time), viscosity, step));
    }
    else if (steps.numbers.courant)
    {
        row("largest Courant number", fmt::format("{:.4g} for a flow along an axis", *steps.numbers.courant));
    }
    if (steps.numbers.viscous)
    {
        row("largest viscous number",
            fmt::format("{:.4g} ({} dt/dx^2){}", *steps.numbers.viscous, viscosity,
                        !settings.automaticViscous ? ""
                        : steps.crankNicolson      ? " where the term is explicit; CrankNicolson pays and begins"
                                                   : "; beyond it CrankNicolson, which does not pay at the start"));
    }
    else
    {
        row("largest viscous number", reading_.fluid->nu == 0 ? fmt::format("no limit: {} is 0", viscosity)
                                      : settings.crankNicolson
                                          ? std::string("no limit: CrankNicolson is implicit")
                                          : std::string("no limit: the integrating factor is exact"));
    }
    row("largest stable step", std::isfinite(steps.largestStable)
                                   ? fmt::format("{:.4g} s for the velocity at the start; the {} term rules",
                                                 steps.largestStable, steps.ruling)
                                   : "no limit for the velocity at the start");
}

void Reporter::printSteps() const
{
    if (!check_.steps) { return; }
    const StepForecast& steps = *check_.steps;
    const TimeControl& control = *reading_.control;
    const TimeSettings& settings = control.settings();
    title("Time steps");
    printLimits();
    if (steps.step > 0)
    {
        const bool limited = std::isfinite(steps.largestStable);
        const std::string source = !settings.deltaT ? fmt::format("auto ({} of the stable one)", settings.safetyFactor)
                                   : settings.adjustTimeStep ? "adjusted"
                                                             : "as written";
        row("deltaT",
            fmt::format("{:.6g} s, {}{}", steps.step, source,
                        limited ? fmt::format("; {:.3g} of the largest stable step", steps.step / steps.largestStable)
                                : ""));
        if (steps.rates.courant > 0)
        {
            row("Courant number at start",
                fmt::format("mean {:.4g}, max {:.4g}{}", steps.step * steps.rates.meanCourant,
                            steps.step * steps.rates.courant,
                            reading_.settings->exactMeanFlow ? ", without the mean flow" : ""));
        }
        if (steps.viscousNumber > 0) { row("viscous number", fmt::format("{:.4g}", steps.viscousNumber)); }
        const bool fixed = settings.deltaT && !settings.adjustTimeStep;
        row("steps", fmt::format("{}{:.0f}, from {} to {} s", fixed ? "" : "about ", steps.steps, control.time(),
                                 settings.endTime));
    }
    log_.line();
}

void Reporter::printWarnings() const
{
    if (log_.shown()) { printList("Warnings", reading_.warnings); }
    else
    {
        for (const std::string& warning : reading_.warnings) { log_.warning(warning); }
    }
}

} // namespace

void printReport(const CaseCheck& check, Log& log)
{
    if (check.reading.theCase)
    {
        const auto& start = check.reading.start;
        log.line(
            fmt::format("Case {}{}", check.reading.theCase->name(),
                        start ? fmt::format(", from time {}{}", start->folder.name, start->restart ? " on" : "") : ""));
        log.line();
    }
    Reporter(check, log).print();
    const std::size_t errors = check.reading.slips.size();
    log.line(errors == 0 ? "The case can run."
                         : fmt::format("The case cannot run: {} error{}.", errors, errors == 1 ? "" : "s"));
}

} // namespace isph
