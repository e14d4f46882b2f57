#include "Results.hpp"

#include "dictionary/Lexer.hpp"
#include "quantities.hpp"

#include <cmath>
#include <limits>

namespace isph
{

namespace fs = std::filesystem;

namespace
{

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double pointsOf(const JsonValues& report)
{
    double points = 1;
    int axes = 0;
    for (const char* axis : {"lattice.points.0", "lattice.points.1", "lattice.points.2"})
    {
        if (const auto count = report.number(axis))
        {
            points *= *count;
            ++axes;
        }
    }
    return axes > 0 ? points : none;
}

} // namespace

Results::Results(const Sweep& sweep, const std::vector<RunRecord>& records, const fs::path& caseDirectory)
    : sweep_(sweep), records_(records)
{
    std::vector<std::string> names = runColumns();
    for (const Parameter& parameter : sweep.parameters) { names.push_back(parameter.name); }
    names.insert(names.end(), sweep.measures.begin(), sweep.measures.end());
    names.insert(names.end(), sweep.collected.begin(), sweep.collected.end());
    for (const std::string& name : names) { columns_[name].assign(sweep.runs.size(), none); }
    for (std::size_t run = 0; run < sweep.runs.size(); ++run) { collect(run, caseDirectory); }
}

void Results::collect(std::size_t run, const fs::path& caseDirectory)
{
    const Run& made = sweep_.runs[run];
    const RunRecord& record = records_[run];
    for (std::size_t i = 0; i < sweep_.parameters.size(); ++i)
    {
        columns_[sweep_.parameters[i].name][run] =
            i == sweep_.resolution ? made.resolution : numberFrom(made.values[i]).value_or(none);
    }
    if (record.status == RunStatus::missing) { return; }
    columns_["cpuTime"][run] = record.cpuTime();
    columns_["wallTime"][run] = record.wallTime();
    columns_["peakMemory"][run] = record.peakMemory > 0 ? static_cast<double>(record.peakMemory) : none;

    const fs::path folder = caseDirectory / made.folder;
    const JsonValues report = reportLeft(folder);
    columns_["steps"][run] = report.number("steps").value_or(none);
    columns_["time"][run] = report.number("time").value_or(none);
    columns_["points"][run] = pointsOf(report);
    if (record.status != RunStatus::done) { return; }
    const std::vector<double> values = evaluateAll(made.quantities, caseDirectory, folder);
    for (std::size_t i = 0; i < values.size(); ++i) { columns_[made.quantities[i].name][run] = values[i]; }
}

std::vector<double> Results::along(std::size_t line, const std::string& name) const
{
    std::vector<double> values;
    for (std::size_t run = 0; run < sweep_.runs.size(); ++run)
    {
        const bool counts = sweep_.runs[run].line == line && records_[run].status == RunStatus::done;
        if (counts) { values.push_back(column(name)[run]); }
    }
    return values;
}

std::optional<Slope> Results::slope(std::size_t line, const std::string& x, const std::string& y) const
{
    std::vector<double> xs;
    std::vector<double> ys;
    for (std::size_t run = 0; run < sweep_.runs.size(); ++run)
    {
        const double resolution = sweep_.runs[run].resolution;
        const bool counts = sweep_.runs[run].line == line && records_[run].status == RunStatus::done;
        const FitRange& fit = sweep_.lines[line].fit;
        if (!counts || resolution < fit.from || resolution > fit.to) { continue; }
        xs.push_back(column(x)[run]);
        ys.push_back(column(y)[run]);
    }
    return fitSlope(xs, ys);
}

std::optional<Slope> Results::order(std::size_t line, const std::string& measure) const
{
    std::optional<Slope> fit = slope(line, sweep_.resolutionName(), measure);
    if (!fit) { return std::nullopt; }
    // A resolution that counts points makes runs larger as it grows, a spacing or a time step makes them smaller: told
    // by the points and steps of the runs, or by what they cost if that is all there is.
    const std::vector<double> resolution = along(line, sweep_.resolutionName());
    const std::vector<double> steps = along(line, "steps");
    std::vector<double> work = along(line, "points");
    for (std::size_t i = 0; i < work.size(); ++i) { work[i] *= steps[i]; }
    std::optional<Slope> growth = fitSlope(resolution, work);
    if (!growth) { growth = fitSlope(resolution, steps); }
    if (!growth) { growth = fitSlope(resolution, along(line, "cpuTime")); }
    if (!growth || growth->slope >= 0) { fit->slope = 0 - fit->slope; }
    return fit;
}

std::vector<CostCurve> Results::curves(const std::string& measure) const
{
    std::vector<CostCurve> result;
    for (std::size_t line = 0; line < sweep_.lines.size(); ++line)
    {
        result.push_back({sweep_.lines[line].title, along(line, "cpuTime"), along(line, measure)});
    }
    for (const External& external : sweep_.externals)
    {
        const auto cost = external.columns.find("cpuTime");
        const auto error = external.columns.find(measure);
        if (cost == external.columns.end() || error == external.columns.end()) { continue; }
        result.push_back({external.title, cost->second, error->second});
    }
    return result;
}

} // namespace isph
