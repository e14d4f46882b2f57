#include "core/numberText.hpp"
#include "core/writeTextFile.hpp"
#include "Results.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace isph
{

namespace
{

/// A number as a cell: nothing where there is none.
std::string cell(double value) { return std::isfinite(value) ? numberText(value) : ""; }

/// A text as a cell: one without commas and quotes, so that any reader of CSV takes it.
std::string cell(std::string text)
{
    std::ranges::replace(text, ',', ';');
    std::ranges::replace(text, '"', '\'');
    return text;
}

std::string runTable(const Results& results)
{
    const Sweep& sweep = results.sweep();
    std::string text = "variant";
    for (const Parameter& parameter : sweep.parameters) { text += ',' + parameter.name; }
    text += ",status";
    for (const std::string& name : sweep.measures) { text += ',' + name; }
    for (const std::string& name : sweep.collected) { text += ',' + name; }
    text += ",cpuTime [s],wallTime [s],peakMemory [bytes],steps,points,time [s],repetitions,message\n";
    for (std::size_t run = 0; run < sweep.runs.size(); ++run)
    {
        const RunRecord& record = results.records()[run];
        text += cell(sweep.lines[sweep.runs[run].line].name);
        for (const std::string& value : sweep.runs[run].values) { text += ',' + cell(value); }
        text += fmt::format(",{}", runStatuses().nameOf(record.status));
        const auto add = [&](const std::string& name) { text += ',' + cell(results.column(name)[run]); };
        std::ranges::for_each(sweep.measures, add);
        std::ranges::for_each(sweep.collected, add);
        for (const char* name : {"cpuTime", "wallTime", "peakMemory", "steps", "points", "time"}) { add(name); }
        text += fmt::format(",{},{}\n", record.cpuTimes.size(), cell(record.message));
    }
    return text;
}

/// Pictures whose slopes those of the measures do not cover.
std::vector<const Picture*> otherPictures(const Sweep& sweep)
{
    std::vector<const Picture*> pictures;
    for (const Picture& picture : sweep.pictures)
    {
        const bool measure = std::ranges::find(sweep.measures, picture.y) != sweep.measures.end();
        const bool covered = measure && (picture.x == sweep.resolutionName() || picture.x == "cpuTime");
        if (!covered) { pictures.push_back(&picture); }
    }
    return pictures;
}

std::string slopeTable(const Results& results)
{
    const Sweep& sweep = results.sweep();
    std::string text = "variant,quantity,against,slope,order,points\n";
    for (std::size_t line = 0; line < sweep.lines.size(); ++line)
    {
        const std::string& name = sweep.lines[line].name;
        const auto row = [&](const std::string& y, const std::string& x, const std::string& order)
        {
            const auto fit = results.slope(line, x, y);
            text += fmt::format("{},{},{},{},{},{}\n", cell(name), y, x, fit ? cell(fit->slope) : "", order,
                                fit ? fit->points : 0);
        };
        for (const std::string& measure : sweep.measures)
        {
            const auto order = results.order(line, measure);
            row(measure, sweep.resolutionName(), order ? cell(order->slope) : "");
            row(measure, "cpuTime", "");
        }
        row("cpuTime", sweep.resolutionName(), "");
        for (const Picture* picture : otherPictures(sweep))
        {
            const bool cost = picture->x == sweep.resolutionName() && picture->y == "cpuTime";
            if (!cost) { row(picture->y, picture->x, ""); }
        }
    }
    return text;
}

std::string cheapestTable(const Results& results)
{
    std::string text = "quantity,error,cheapest,cpuTime [s],atMost,second,cpuTime of the second [s]\n";
    for (const std::string& measure : results.sweep().measures)
    {
        const std::vector<CostCurve> curves = results.curves(measure);
        for (const Cheapest& row : cheapest(curves))
        {
            text += fmt::format("{},{},{},{},{},{},{}\n", measure, numberText(row.error), cell(curves[row.curve].title),
                                cell(row.cost.cost), row.cost.atMost ? "yes" : "no",
                                row.second ? cell(curves[*row.second].title) : "",
                                row.secondCost ? cell(row.secondCost->cost) : "");
        }
    }
    return text;
}

/// Rows of cells as columns, the first one to the left, the others to the right.
std::string aligned(const std::vector<std::vector<std::string>>& rows)
{
    std::vector<std::size_t> widths;
    for (const auto& row : rows)
    {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) { widths[i] = std::max(widths[i], row[i].size()); }
    }
    std::string text;
    for (const auto& row : rows)
    {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i)
        {
            line += i == 0 ? fmt::format("    {:<{}}", row[i], widths[i]) : fmt::format("  {:>{}}", row[i], widths[i]);
        }
        text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    }
    return text;
}

std::string shown(double value, const char* format)
{
    return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

} // namespace

std::string slopeText(double slope)
{
    std::string text = fmt::format("{:.2f}", slope);
    return text == "-0.00" ? "0.00" : text;
}

void writeTables(const Results& results, const std::filesystem::path& folder)
{
    writeTextFile(folder / "workPrecision.csv", runTable(results));
    writeTextFile(folder / "slopes.csv", slopeTable(results));
    writeTextFile(folder / "cheapest.csv", cheapestTable(results));
}

std::string runsText(const Results& results)
{
    const Sweep& sweep = results.sweep();
    std::vector<std::vector<std::string>> rows{{"variant", sweep.resolutionName()}};
    for (const std::string& name : sweep.measures) { rows[0].push_back(name); }
    for (const std::string& name : sweep.collected) { rows[0].push_back(name); }
    rows[0].insert(rows[0].end(), {"cpuTime [s]", "memory [MB]", "steps"});
    std::string failures;
    for (std::size_t line = 0; line < sweep.lines.size(); ++line)
    {
        for (std::size_t run = 0; run < sweep.runs.size(); ++run)
        {
            if (sweep.runs[run].line != line) { continue; }
            const RunRecord& record = results.records()[run];
            std::vector<std::string> row{sweep.lines[line].title, sweep.runs[run].values[sweep.resolution]};
            const auto add = [&](const std::string& name)
            { row.push_back(shown(results.column(name)[run], "{:.3e}")); };
            std::ranges::for_each(sweep.measures, add);
            std::ranges::for_each(sweep.collected, add);
            row.push_back(shown(results.column("cpuTime")[run], "{:.3g}"));
            row.push_back(shown(results.column("peakMemory")[run] / 1e6, "{:.3g}"));
            row.push_back(shown(results.column("steps")[run], "{:.0f}"));
            rows.push_back(std::move(row));
            const auto complain = [&](const std::string& what)
            {
                failures += fmt::format("    {}, {} {}: {}\n", sweep.lines[line].title, sweep.resolutionName(),
                                        sweep.runs[run].values[sweep.resolution], what);
            };
            if (record.status != RunStatus::done)
            {
                complain(record.status == RunStatus::missing ? "has not been made" : record.message);
                continue;
            }
            for (const std::string& name : sweep.measures)
            {
                const double value = results.column(name)[run];
                if (!std::isfinite(value)) { complain(name + " is no number"); }
                else if (value <= 0) { complain(fmt::format("{} is {:g}, which has no logarithm", name, value)); }
            }
        }
    }
    return aligned(rows) + (failures.empty() ? "" : fmt::format("\nLeft out of fits and pictures\n{}", failures));
}

std::string slopesText(const Results& results)
{
    const Sweep& sweep = results.sweep();
    std::vector<std::vector<std::string>> rows{{"variant"}};
    for (const std::string& measure : sweep.measures)
    {
        const std::string name = sweep.measures.size() == 1 ? "" : fmt::format(" of {}", measure);
        rows[0].push_back(fmt::format("order{} in {}", name, sweep.resolutionName()));
        rows[0].push_back(fmt::format("slope{} in cpuTime", name));
    }
    for (const Picture* picture : otherPictures(sweep))
    {
        rows[0].push_back(fmt::format("slope of {} in {}", picture->y, picture->x));
    }
    const auto text = [](const std::optional<Slope>& fit) { return fit ? slopeText(fit->slope) : "-"; };
    for (std::size_t line = 0; line < sweep.lines.size(); ++line)
    {
        std::vector<std::string> row{sweep.lines[line].title};
        for (const std::string& measure : sweep.measures)
        {
            row.push_back(text(results.order(line, measure)));
            row.push_back(text(results.slope(line, "cpuTime", measure)));
        }
        for (const Picture* picture : otherPictures(sweep))
        {
            row.push_back(text(results.slope(line, picture->x, picture->y)));
        }
        rows.push_back(std::move(row));
    }
    return aligned(rows);
}

std::string cheapestText(const Results& results)
{
    std::string text;
    for (const std::string& measure : results.sweep().measures)
    {
        const std::vector<CostCurve> curves = results.curves(measure);
        const std::vector<Cheapest> table = cheapest(curves);
        if (table.empty()) { continue; }
        const auto cost = [](const CostOf& of) { return fmt::format("{}{:.3g}", of.atMost ? "<= " : "", of.cost); };
        std::vector<std::vector<std::string>> rows{{measure, "cheapest", "cpuTime [s]", "second", "cpuTime [s]"}};
        for (const Cheapest& row : table)
        {
            rows.push_back({fmt::format("{:.0e}", row.error), curves[row.curve].title, cost(row.cost),
                            row.second ? curves[*row.second].title : "-",
                            row.secondCost ? cost(*row.secondCost) : "-"});
        }
        if (!text.empty()) { text += '\n'; }
        text += aligned(rows);
    }
    return text;
}

} // namespace isph
