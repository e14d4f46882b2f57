#include "StabilityReport.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace isph
{

namespace
{

std::string_view nameOf(Verdict verdict)
{
    return verdict == Verdict::stable ? "stable" : verdict == Verdict::unstable ? "unstable" : "either";
}

std::string growthText(const std::optional<double>& growth)
{
    // Beyond these numbers a factor tells nothing more.
    if (!growth) { return "-"; }
    if (*growth < -0.99) { return "dies out"; }
    return *growth < std::log(1e3) ? fmt::format("{:.4f}", std::exp(*growth)) : ">1000";
}

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json ofSpectrum(const OperatorSpectrum& spectrum)
{
    const bool known = spectrum.count > 0;
    return Json::object({{"operator", spectrum.name},
                         {"order", spectrum.derivative},
                         {"radius", known ? Json(spectrum.radius) : Json()},
                         {"largestRealPart", known ? Json(spectrum.growth) : Json()},
                         {"largestImaginaryPart", known ? Json(spectrum.imaginary) : Json()},
                         {"eigenvalues", static_cast<long long>(spectrum.count)},
                         {"grows", spectrum.grows}});
}

Json ofTrial(const TrialSummary& trial)
{
    Json rows = Json::array();
    for (const TrialRow& row : trial.result.rows)
    {
        rows.add(Json::object({{"fraction", row.fraction},
                               {"deltaT", row.outcome.dt},
                               {"steps", row.outcome.steps},
                               {"predictedGrowth", row.predicted ? Json(std::exp(*row.predicted)) : Json()},
                               {"growth", std::exp(row.outcome.growth)},
                               {"finite", row.outcome.finite},
                               {"expected", nameOf(row.expected)},
                               {"observed", nameOf(row.observed)},
                               {"agree", row.agrees}}));
    }
    return Json::object({{"term", trial.term},
                         {"what", trial.what},
                         {"limit", std::isfinite(trial.limit) ? Json(trial.limit) : Json()},
                         {"limitOfModes", orNull(trial.limitOfModes)},
                         {"growthInTime", trial.growthInTime},
                         {"trials", rows},
                         {"note", trial.result.note}});
}

} // namespace

bool StabilityReport::agrees() const
{
    return std::ranges::all_of(
        trials, [](const TrialSummary& trial)
        { return std::ranges::all_of(trial.result.rows, [](const TrialRow& row) { return row.agrees; }); });
}

bool StabilityReport::modesMayGrow() const
{
    return std::ranges::any_of(trials, [](const TrialSummary& trial) { return trial.modesMayGrow(); });
}

bool StabilityReport::modesGrow() const
{
    return std::ranges::any_of(trials, [](const TrialSummary& trial) { return trial.modesGrow(); });
}

bool TrialSummary::modesMayGrow() const
{
    return std::ranges::any_of(result.rows, [](const TrialRow& row)
                               { return row.predicted && row.fraction <= 1 && row.expected != Verdict::stable; });
}

bool TrialSummary::modesGrow() const
{
    return modesMayGrow() && std::ranges::any_of(result.rows, [](const TrialRow& row)
                                                 { return row.fraction <= 1 && row.observed == Verdict::unstable; });
}

TrialSummary summaryOf(const StabilityTrial& trial, TrialResult result)
{
    TrialSummary summary{
        .term = trial.term, .what = trial.what, .limit = trial.prediction.limit, .result = std::move(result)};
    const Prediction& prediction = trial.prediction;
    if (prediction.modes.empty()) { return summary; }
    summary.limitOfModes = largestStableStep(*prediction.scheme, prediction.modes);
    summary.growthInTime = exactGrowth(prediction.modes);
    return summary;
}

void printPrediction(const StabilityReport& report, Log& log)
{
    log.line(fmt::format("Case {}", report.caseName));
    log.line();
    log.line("Spectra, in units of pi/dx (first derivatives) and (pi/dx)^2");
    for (const OperatorSpectrum& spectrum : report.spectra)
    {
        log.line(fmt::format("    {:<18} radius {:<8.4g} largest real part {:<10.2g} {}", spectrum.name,
                             spectrum.radius, spectrum.count > 0 ? spectrum.growth + 0.0 : 0.0, spectrum.words));
    }
    if (report.growthAtRest)
    {
        const bool grows = *report.growthAtRest > growthThreshold;
        log.line(fmt::format("    {:<18} {}", "projection",
                             grows ? fmt::format("modes at the ends grow {} times with every step, whatever its length",
                                                 growthText(report.growthAtRest))
                                   : "nothing grows by it"));
    }
    log.line();
    log.line("Limits");
    log.line(fmt::format("    {:<18} {}: |imaginary| <= {:.5g}, real >= {:.5g}", "region", report.scheme,
                         report.time->imaginaryLimit, -report.time->realLimit));
    if (report.numbers.courant && *report.numbers.courant > 0)
    {
        log.line(fmt::format("    {:<18} {:.4g} for a flow along an axis", "Courant number", *report.numbers.courant));
    }
    else if (report.numbers.courant)
    {
        log.line(fmt::format("    {:<18} none: the step must stay below 2 nu/|u|^2 instead", "Courant number"));
    }
    if (report.numbers.viscous)
    {
        log.line(fmt::format("    {:<18} {:.4g} (nu dt/dx^2)", "viscous number", *report.numbers.viscous));
    }
    log.line();
    log.line(report.tried ? "Trials" : "Steps");
}

void printTrial(const TrialSummary& trial, Log& log)
{
    log.line(fmt::format("{}: {}", trial.term, trial.what));
    if (std::isfinite(trial.limit))
    {
        std::string text = fmt::format("    limit {:.4g} s", trial.limit);
        if (trial.limitOfModes)
        {
            text += std::isfinite(*trial.limitOfModes)
                        ? fmt::format("; the modes bear {:.4g} times that", *trial.limitOfModes / trial.limit)
                        : "; the modes bear any step";
        }
        log.line(text);
    }
    if (trial.growthInTime * std::min(trial.limit, 1e300) > growthThreshold)
    {
        log.line(fmt::format("    modes grow in exact time, at up to {:.3g} 1/s", trial.growthInTime));
    }
    if (trial.result.rows.empty()) { return; }
    log.line(fmt::format("    {:>8}  {:>10}  {:>5}  {:>10}  {:>10}  {:<9} {:<9} {}", "fraction", "deltaT", "steps",
                         "predicted", "growth", "expected", "observed", "agree"));
    for (const TrialRow& row : trial.result.rows)
    {
        log.line(fmt::format("    {:>8.4g}  {:>10.4g}  {:>5}  {:>10}  {:>10}  {:<9} {:<9} {}", row.fraction,
                             row.outcome.dt, row.outcome.steps, growthText(row.predicted),
                             row.outcome.finite ? growthText(row.outcome.growth) : "infinite", nameOf(row.expected),
                             nameOf(row.observed), row.agrees ? "yes" : "NO"));
    }
    if (!trial.result.note.empty()) { log.line("    " + trial.result.note); }
}

void printVerdict(const StabilityReport& report, Log& log)
{
    log.line();
    for (const std::string& what : report.leftOut) { log.line("Left out, " + what); }
    if (!report.tried) { log.line("Nothing was tried."); }
    else if (report.agrees())
    {
        log.line("Predictions and trials agree.");
        if (report.modesGrow()) { log.line("The schemes of this case make modes grow, whatever the step."); }
    }
}

Json jsonOf(const StabilityReport& report)
{
    Json spectra = Json::array();
    for (const OperatorSpectrum& spectrum : report.spectra) { spectra.add(ofSpectrum(spectrum)); }
    Json trials = Json::array();
    for (const TrialSummary& trial : report.trials) { trials.add(ofTrial(trial)); }
    return Json::object({{"schema", 1},
                         {"case", report.caseName},
                         {"scheme", report.scheme},
                         {"courant", orNull(report.numbers.courant)},
                         {"viscousNumber", orNull(report.numbers.viscous)},
                         {"growthAtRest", report.growthAtRest ? Json(std::exp(*report.growthAtRest)) : Json()},
                         {"spectra", spectra},
                         {"terms", trials},
                         {"leftOut", Json::arrayOf(report.leftOut)},
                         {"tried", report.tried},
                         {"modesGrow", report.modesGrow()},
                         {"agree", report.tried ? Json(report.agrees()) : Json()}});
}

} // namespace isph
