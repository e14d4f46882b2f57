#include "core/nearestWord.hpp"
#include "csvTable.hpp"
#include "quantities.hpp"
#include "readSweep.hpp"
#include "workPrecisionSchema.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace isph
{

namespace
{

/// Columns of the table that can be drawn.
std::vector<std::string> drawable(const Sweep& sweep)
{
    std::vector<std::string> names = sweep.measures;
    names.insert(names.end(), sweep.collected.begin(), sweep.collected.end());
    for (const std::string& name : runColumns()) { names.push_back(name); }
    for (const Parameter& parameter : sweep.parameters) { names.push_back(parameter.name); }
    return names;
}

std::string labelOf(const std::string& column, const Sweep& sweep)
{
    for (const Quantity& quantity : sweep.runs.front().quantities)
    {
        if (quantity.name == column) { return quantity.label; }
    }
    if (column == "cpuTime") { return "processor time [s]"; }
    if (column == "wallTime") { return "run time [s]"; }
    if (column == "peakMemory") { return "memory [bytes]"; }
    return column;
}

Picture readPicture(const std::string& name, const Dictionary& written, const Sweep& sweep)
{
    const Dictionary dictionary = pictureSchema().complete(written);
    const auto textOr = [&](const char* key, const std::string& otherwise)
    { return dictionary.has(key) ? dictionary.text(key) : otherwise; };
    Picture picture{.name = name,
                    .x = dictionary.text("x"),
                    .y = dictionary.text("y"),
                    .title = textOr("title", sweep.title),
                    .xLabel = "",
                    .yLabel = "",
                    .logX = dictionary.flag("logX"),
                    .logY = dictionary.flag("logY"),
                    .origin = written.origin()};
    const std::vector<std::string> known = drawable(sweep);
    for (const char* key : {"x", "y"})
    {
        const std::string column = dictionary.text(key);
        if (std::ranges::find(known, column) == known.end())
        {
            throw dictionary.error(key, fmt::format("'{}' is no column of the table", column),
                                   fmt::format("known are: {}", listOfWords(column, known)));
        }
    }
    picture.xLabel = textOr("xLabel", labelOf(picture.x, sweep));
    picture.yLabel = textOr("yLabel", labelOf(picture.y, sweep));
    return picture;
}

void readColumns(const Dictionary& columns, const CsvTable& table, const std::vector<std::string>& known,
                 External& external)
{
    for (const Entry& column : columns.entries())
    {
        const std::string& ours = column.keyword();
        if (std::ranges::find(known, ours) == known.end())
        {
            throw Error(Fault::input, column.origin(), "is no column of the table",
                        fmt::format("known are: {}", listOfWords(ours, known)));
        }
        external.columns[ours] = table.column(columns.text(ours), column.origin());
    }
}

} // namespace

void readPictures(const Dictionary& dictionary, Sweep& sweep)
{
    if (!dictionary.hasDictionary("plot"))
    {
        for (const std::string& measure : sweep.measures)
        {
            const bool only = sweep.measures.size() == 1;
            sweep.pictures.push_back({.name = only ? "workPrecision" : fmt::format("workPrecision_{}", measure),
                                      .x = "cpuTime",
                                      .y = measure,
                                      .title = sweep.title,
                                      .xLabel = labelOf("cpuTime", sweep),
                                      .yLabel = labelOf(measure, sweep),
                                      .logX = true,
                                      .logY = true,
                                      .origin = dictionary.origin()});
        }
        return;
    }
    const Dictionary& plot = dictionary.dictionary("plot");
    const bool named =
        !plot.entries().empty() && std::ranges::all_of(plot.entries(), [](const Entry& e) { return e.isDictionary(); });
    if (!named) { sweep.pictures.push_back(readPicture("workPrecision", plot, sweep)); }
    for (const Entry& entry : plot.entries())
    {
        if (named) { sweep.pictures.push_back(readPicture(entry.keyword(), entry.dictionary(), sweep)); }
    }
}

void readExternals(const Case& theCase, const Dictionary& dictionary, Sweep& sweep)
{
    if (!dictionary.hasDictionary("external")) { return; }
    const std::vector<std::string> known = drawable(sweep);
    for (const Entry& entry : dictionary.dictionary("external").entries())
    {
        const Dictionary& series = entry.dictionary();
        const std::string file = series.text("file");
        if (!theCase.has(file))
        {
            throw series.error("file", fmt::format("there is no {}", file), "write the way to it from the case");
        }
        const CsvTable table(theCase.path(file), file);
        External external{entry.keyword(), series.has("title") ? series.text("title") : entry.keyword(), {}};
        if (series.hasDictionary("columns")) { readColumns(series.dictionary("columns"), table, known, external); }
        else
        {
            for (const std::string& name : known)
            {
                const bool there = std::ranges::find(table.names(), name) != table.names().end();
                if (there) { external.columns[name] = table.column(name, series.origin()); }
            }
        }
        const auto shows = [&external](const Picture& picture)
        { return external.columns.contains(picture.x) && external.columns.contains(picture.y); };
        if (std::ranges::none_of(sweep.pictures, shows))
        {
            const Picture& picture = sweep.pictures.front();
            throw series.error(
                series.has("columns") ? "columns" : "file",
                fmt::format("gives no picture both its columns, e.g. {} and {}", picture.x, picture.y),
                fmt::format("write columns {{ {} ...; {} ...; }} (our name, column of the file); it has: {}", picture.x,
                            picture.y, fmt::join(table.names(), ", ")));
        }
        const auto empty = [](const auto& column)
        { return std::ranges::none_of(column.second, [](double value) { return std::isfinite(value); }); };
        if (const auto found = std::ranges::find_if(external.columns, empty); found != external.columns.end())
        {
            throw series.error("file", fmt::format("{} has no number for {}", file, found->first),
                               "its columns are numbers, separated by commas");
        }
        sweep.externals.push_back(std::move(external));
    }
}

} // namespace isph
