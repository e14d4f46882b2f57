#include "quantities.hpp"

#include "case/TimeDirectories.hpp"
#include "ChildProcess.hpp"
#include "core/nearestWord.hpp"
#include "core/readJson.hpp"
#include "csvTable.hpp"
#include "dictionary/Lexer.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>

namespace isph
{

namespace fs = std::filesystem;

namespace
{

constexpr double none = std::numeric_limits<double>::quiet_NaN();

[[noreturn]] void throwNone(const Quantity& quantity, const std::string& what, const std::string& advice)
{
    throw Error(Fault::input, quantity.origin, what, advice);
}

double reported(const Quantity& quantity, const JsonValues& report, const std::string& key)
{
    if (const auto value = report.number(key)) { return *value; }
    throwNone(quantity, fmt::format("report.json has no number '{}'", key),
              fmt::format("it has: {}", listOfWords(key, report.numberNames())));
}

JsonValues reportOf(const Quantity& quantity, const fs::path& folder)
{
    const fs::path file = folder / "postProcessing" / "report.json";
    if (!fs::exists(file))
    {
        throwNone(quantity, "the solver wrote no postProcessing/report.json", "use function, line or command instead");
    }
    return readJson(file, file.string());
}

/// The folder with the latest time in its name.
fs::path latestFolder(const Quantity& quantity, const fs::path& folder)
{
    const std::vector<TimeDirectory> times =
        fs::exists(folder) ? timeDirectories(folder) : std::vector<TimeDirectory>{};
    if (times.empty())
    {
        throwNone(quantity, fmt::format("there are no results of '{}' in postProcessing", folder.filename().string()),
                  "the name must be that of a function of controlDict; lines need sampleLines in commands or after");
    }
    return folder / times.back().name;
}

double ofFunction(const Quantity& quantity, const fs::path& folder)
{
    const fs::path results = latestFolder(quantity, folder / "postProcessing" / quantity.from);
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(results))
    {
        if (entry.path().extension() == ".csv") { files.push_back(entry.path()); }
    }
    if (files.empty()) { throwNone(quantity, fmt::format("{} holds no CSV file", results.string()), ""); }
    std::ranges::sort(files);
    const CsvTable table(files.front(), files.front().filename().string());
    const std::vector<double> values = table.column(quantity.column, quantity.origin);
    return reduce(quantity, table.column("time", quantity.origin), values);
}

double ofLine(const Quantity& quantity, const fs::path& caseDirectory, const fs::path& folder)
{
    const fs::path results = latestFolder(quantity, folder / "postProcessing" / "sampleLines");
    const CsvTable line(results / (quantity.from + ".csv"), quantity.from + ".csv");
    const auto finite = [&](const CsvTable& table, const std::string& abscissa, const std::string& column)
    {
        std::pair pair{table.column(abscissa, quantity.origin), table.column(column, quantity.origin)};
        for (std::size_t i = pair.first.size(); i-- > 0;)
        {
            if (std::isfinite(pair.first[i]) && std::isfinite(pair.second[i])) { continue; }
            pair.first.erase(pair.first.begin() + static_cast<std::ptrdiff_t>(i));
            pair.second.erase(pair.second.begin() + static_cast<std::ptrdiff_t>(i));
        }
        return pair;
    };
    const auto [x, y] = finite(line, quantity.abscissa, quantity.column);
    if (!quantity.profile) { return reduce(quantity, x, y); }
    const CsvTable reference(caseDirectory / quantity.profile->file, quantity.profile->file.string());
    const auto [xReference, yReference] = finite(reference, quantity.profile->abscissa, quantity.profile->column);
    return deviation(quantity.norm, x, y, xReference, yReference);
}

double ofCommand(const Quantity& quantity, const fs::path& folder)
{
    const std::string said = outputOf(quantity.from, folder);
    const std::size_t begin = said.find_last_not_of(" \t\r\n");
    const std::size_t last = begin == std::string::npos ? 0 : said.find_last_of(" \t\r\n", begin) + 1;
    const std::string word = begin == std::string::npos ? "" : said.substr(last, begin + 1 - last);
    if (word == "nan" || word == "-nan" || word == "inf") { return none; }
    const std::optional<double> number = numberFrom(word);
    if (!number)
    {
        throwNone(quantity, fmt::format("the command printed '{}' in {}, which is no number", word, folder.string()),
                  "the last word that it prints is taken");
    }
    return *number;
}

/// What `per` and `reference` make of a number.
double related(const Quantity& quantity, double value, const fs::path& folder)
{
    if (!quantity.per.empty()) { value /= reported(quantity, reportOf(quantity, folder), quantity.per); }
    return quantity.reference ? std::abs(value - *quantity.reference) / std::abs(*quantity.reference) : value;
}

/// Vertex of the parabola through three points.
double vertex(const std::vector<double>& t, const std::vector<double>& y, std::size_t m)
{
    const double a = t[m - 1] - t[m];
    const double b = t[m + 1] - t[m];
    const double curvature = ((y[m - 1] - y[m]) / a - (y[m + 1] - y[m]) / b) / (a - b);
    const double slope = (y[m + 1] - y[m]) / b - curvature * b;
    return curvature < 0 ? y[m] - slope * slope / (4 * curvature) : y[m];
}

double peakOf(const std::vector<double>& t, const std::vector<double>& y)
{
    std::size_t largest = 0;
    for (std::size_t i = 1; i + 1 < y.size(); ++i)
    {
        if (y[i] < y[i - 1] || y[i] < y[i + 1]) { continue; }
        if (largest == 0 || y[i] > y[largest]) { largest = i; }
    }
    return largest == 0 ? none : vertex(t, y, largest);
}

} // namespace

std::vector<std::string> runColumns()
{
    return {"variant", "status", "cpuTime", "wallTime", "peakMemory", "steps", "points", "time"};
}

double reduce(const Quantity& quantity, const std::vector<double>& times, const std::vector<double>& values)
{
    std::vector<double> t;
    std::vector<double> y;
    for (std::size_t i = 0; i < times.size(); ++i)
    {
        if (times[i] < quantity.begin || times[i] > quantity.end || !std::isfinite(values[i])) { continue; }
        t.push_back(times[i]);
        y.push_back(quantity.overFirst ? values[i] / values.front() : values[i]);
    }
    if (y.empty()) { return none; }
    if (quantity.at)
    {
        // Between two rows linearly: functions may be written every so many steps.
        const auto after = std::ranges::lower_bound(t, *quantity.at - 1e-9 * std::abs(*quantity.at));
        if (after == t.end()) { return none; }
        const auto i = static_cast<std::size_t>(after - t.begin());
        if (i == 0) { return std::abs(t[0] - *quantity.at) <= 1e-9 * std::abs(*quantity.at) ? y[0] : none; }
        const double part = std::min(1.0, (*quantity.at - t[i - 1]) / (t[i] - t[i - 1]));
        return y[i - 1] + part * (y[i] - y[i - 1]);
    }
    switch (quantity.reduction)
    {
    case Quantity::Reduction::last:
        return y.back();
    case Quantity::Reduction::first:
        return y.front();
    case Quantity::Reduction::max:
        return std::ranges::max(y);
    case Quantity::Reduction::min:
        return std::ranges::min(y);
    case Quantity::Reduction::peak:
        break;
    }
    return peakOf(t, y);
}

double deviation(Quantity::Norm norm, const std::vector<double>& abscissae, const std::vector<double>& values,
                 const std::vector<double>& referenceAbscissae, const std::vector<double>& reference)
{
    if (abscissae.size() < 2) { return none; }
    // Profiles may be sampled in either direction.
    std::vector<std::size_t> order(abscissae.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&abscissae](std::size_t i) { return abscissae[i]; });
    const double slack = 1e-9 * (abscissae[order.back()] - abscissae[order.front()]);
    double largest = 0;
    double squares = 0;
    std::size_t count = 0;
    for (std::size_t k = 0; k < reference.size(); ++k)
    {
        const double x = referenceAbscissae[k];
        if (x < abscissae[order.front()] - slack || x > abscissae[order.back()] + slack) { continue; }
        const auto next = std::ranges::lower_bound(order.begin() + 1, order.end() - 1, x, {},
                                                   [&](std::size_t i) { return abscissae[i]; });
        const std::size_t b = *next;
        const std::size_t a = *(next - 1);
        const double part = abscissae[b] > abscissae[a] ? (x - abscissae[a]) / (abscissae[b] - abscissae[a]) : 0;
        const double difference = std::abs(values[a] + part * (values[b] - values[a]) - reference[k]);
        largest = std::max(largest, difference);
        squares += difference * difference;
        ++count;
    }
    if (count == 0) { return none; }
    return norm == Quantity::Norm::max ? largest : std::sqrt(squares / static_cast<double>(count));
}

double evaluate(const Quantity& quantity, const fs::path& caseDirectory, const fs::path& folder)
{
    double value = none;
    switch (quantity.source)
    {
    case Quantity::Source::report:
        value = reported(quantity, reportOf(quantity, folder), quantity.from);
        break;
    case Quantity::Source::function:
        value = ofFunction(quantity, folder);
        break;
    case Quantity::Source::line:
        value = ofLine(quantity, caseDirectory, folder);
        break;
    case Quantity::Source::command:
        value = ofCommand(quantity, folder);
        break;
    case Quantity::Source::largestOf:
        break; // evaluateAll
    }
    return related(quantity, value, folder);
}

std::vector<double> evaluateAll(const std::vector<Quantity>& quantities, const fs::path& caseDirectory,
                                const fs::path& folder)
{
    std::vector<double> values;
    for (const Quantity& quantity : quantities)
    {
        try
        {
            values.push_back(evaluate(quantity, caseDirectory, folder));
        }
        catch (const Error&)
        {
            if (!quantity.optional) { throw; }
            values.push_back(none);
        }
    }
    for (std::size_t i = 0; i < quantities.size(); ++i)
    {
        if (quantities[i].others.empty()) { continue; }
        double largest = -std::numeric_limits<double>::infinity();
        for (const std::string& name : quantities[i].others)
        {
            const auto other = std::ranges::find(quantities, name, &Quantity::name);
            const double value = values[static_cast<std::size_t>(other - quantities.begin())];
            // One that is missing makes the whole missing.
            largest = std::isnan(value) || std::isnan(largest) ? none : std::max(largest, value);
        }
        values[i] = related(quantities[i], largest, folder);
    }
    return values;
}

} // namespace isph
