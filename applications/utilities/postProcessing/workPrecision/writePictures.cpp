#include "writePictures.hpp"

#include "ChildProcess.hpp"
#include "core/numberText.hpp"
#include "core/writeTextFile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fstream>

namespace isph
{

namespace fs = std::filesystem;

namespace
{

/// A curve with its points.
struct Series
{
    std::string title;
    std::vector<double> x;
    std::vector<double> y;
    bool external;
};

// Colours that people with any kind of sight can tell apart (Okabe & Ito 2008), yellow left out on white.
constexpr std::array<const char*, 7> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                             "#e69f00", "#56b4e9", "#404040"};
constexpr std::array<int, 7> marks{7, 5, 9, 11, 13, 15, 3};
constexpr std::array<int, 5> openMarks{6, 4, 8, 10, 12};

std::string quoted(std::string text)
{
    std::string result;
    for (const char c : text) { result += c == '\'' ? std::string("''") : std::string(1, c); }
    return fmt::format("'{}'", result);
}

bool drawn(double x, double y, const Picture& picture)
{
    // A logarithmic axis has room for what margins do not bring out of the range of numbers.
    const auto fits = [](double value, bool logarithmic)
    { return std::isfinite(value) && (!logarithmic || (value > 1e-250 && value < 1e250)); };
    return fits(x, picture.logX) && fits(y, picture.logY);
}

std::string legend(const Results& results, const Picture& picture, std::size_t line)
{
    const Sweep& sweep = results.sweep();
    const bool measure = std::ranges::find(sweep.measures, picture.y) != sweep.measures.end();
    std::string title = sweep.lines[line].title;
    if (!picture.logX || !picture.logY) { return title; }
    const auto fit = measure ? results.order(line, picture.y) : results.slope(line, picture.x, picture.y);
    if (fit) { title += fmt::format(" ({} {})", measure ? "order" : "slope", slopeText(fit->slope)); }
    return title;
}

std::vector<Series> seriesOf(const Results& results, const Picture& picture)
{
    const Sweep& sweep = results.sweep();
    std::vector<Series> series;
    for (std::size_t line = 0; line < sweep.lines.size(); ++line)
    {
        series.push_back(
            {legend(results, picture, line), results.along(line, picture.x), results.along(line, picture.y), false});
    }
    for (const External& external : sweep.externals)
    {
        const auto x = external.columns.find(picture.x);
        const auto y = external.columns.find(picture.y);
        if (x == external.columns.end() || y == external.columns.end()) { continue; }
        series.push_back({external.title, x->second, y->second, true});
    }
    for (Series& one : series)
    {
        for (std::size_t i = one.x.size(); i-- > 0;)
        {
            if (drawn(one.x[i], one.y[i], picture)) { continue; }
            one.x.erase(one.x.begin() + static_cast<std::ptrdiff_t>(i));
            one.y.erase(one.y.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
    std::erase_if(series, [](const Series& one) { return one.x.empty(); });
    return series;
}

/// An axis a little longer than the data.
std::string axis(const std::vector<Series>& series, bool ofX, bool logarithmic)
{
    const char* name = ofX ? "x" : "y";
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Series& one : series)
    {
        for (const double value : ofX ? one.x : one.y)
        {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    if (!(low <= high)) { return ""; }
    if (!logarithmic)
    {
        const double margin = high > low ? 0.05 * (high - low) : 1;
        return fmt::format("set {}range [{:.6g}:{:.6g}]\n", name, low - margin, high + margin);
    }
    // At least a decade, so that the axis has numbers on it.
    const double decades = std::log10(high / low);
    const double margin = std::pow(10.0, 0.06 * std::max(1.0, decades) + 0.5 * std::max(0.0, 1 - decades));
    low /= margin;
    high *= margin;
    const std::string text =
        fmt::format("set {0}range [{1:.6g}:{2:.6g}]\nset logscale {0} 10\nset m{0}tics 10\n", name, low, high);
    // Powers of ten where there are many decades or plain numbers would be long; 1, 2, 5 where decades are few.
    const bool plain = low >= 1e-4 && high < 1e5;
    const bool few = high / low <= 100;
    if ((!plain && !few) || high / low > 1e5) { return text + fmt::format("set format {} '10^{{%T}}'\n", name); }
    if (!few) { return text + fmt::format("set format {} '%g'\n", name); }
    std::vector<std::string> tics;
    for (int power = static_cast<int>(std::floor(std::log10(low))); std::pow(10.0, power) <= high; ++power)
    {
        for (const int digit : {1, 2, 5})
        {
            const double tic = digit * std::pow(10.0, power);
            if (tic < low || tic > high) { continue; }
            const std::string digits = digit == 1 ? "" : fmt::format("{}·", digit);
            const std::string shown = plain ? fmt::format("{:g}", tic) : fmt::format("{}10^{{{}}}", digits, power);
            tics.push_back(fmt::format("'{}' {:g}", shown, tic));
        }
    }
    return text + fmt::format("set {}tics ({})\n", name, fmt::join(tics, ", "));
}

/// Columns of the key below the picture: as many as gnuplot finds room for, which counts some ten pixels a letter.
int keyColumns(const std::vector<Series>& series)
{
    std::size_t longest = 0;
    for (const Series& one : series) { longest = std::max(longest, one.title.size()); }
    return longest > 36 || series.size() < 2 ? 1 : longest > 22 || series.size() < 3 ? 2 : 3;
}

/// The commands of gnuplot that draw a picture, data included; ready to be run by hand in the folder of the picture.
std::string pictureScript(const Results& results, const Picture& picture)
{
    const std::vector<Series> series = seriesOf(results, picture);
    std::string text = "# drawn by workPrecision; run by hand: gnuplot " + picture.name + ".gp\n";
    std::vector<std::string> curves;
    std::size_t ours = 0;
    std::size_t theirs = 0;
    for (std::size_t i = 0; i < series.size(); ++i)
    {
        text += fmt::format("$data{} << END\n", i);
        for (std::size_t k = 0; k < series[i].x.size(); ++k)
        {
            text += fmt::format("{} {}\n", numberText(series[i].x[k]), numberText(series[i].y[k]));
        }
        text += "END\n";
        if (series[i].external)
        {
            curves.push_back(fmt::format("$data{} with linespoints lw 1.4 dt 3 pt {} ps 1.3 lc '#707070' title {}", i,
                                         openMarks[theirs % openMarks.size()], quoted(series[i].title)));
            ++theirs;
            continue;
        }
        const std::size_t round = ours / colours.size();
        curves.push_back(fmt::format("$data{} with linespoints lw 2 dt {} pt {} ps 1.3 lc '{}' title {}", i, round + 1,
                                     marks[(ours + round) % marks.size()], colours[ours % colours.size()],
                                     quoted(series[i].title)));
        ++ours;
    }
    const int columns = keyColumns(series);
    const int rows = (static_cast<int>(series.size()) + columns - 1) / columns;
    text += fmt::format("set title {} noenhanced offset 0,0.3\nset xlabel {} noenhanced\n"
                        "set ylabel {} noenhanced offset -0.5\n",
                        quoted(picture.title), quoted(picture.xLabel), quoted(picture.yLabel));
    // Below the picture, where it hides no data.
    text += fmt::format("set key outside below center Left reverse noenhanced samplen 2.5 spacing 1.25 maxrows {}\n"
                        "set bmargin {:.2f}\n",
                        rows, 4.2 + 1.25 * rows);
    text += "set border 3 lw 1.2\nset tics nomirror\nset grid xtics ytics lc '#dddddd' lt 1 lw 0.8\n";
    text += axis(series, true, picture.logX) + axis(series, false, picture.logY);
    if (picture.x == results.sweep().resolutionName())
    {
        // The values that were run are the numbers one looks for.
        std::vector<std::string> tics;
        for (const std::string& value : results.sweep().parameters[results.sweep().resolution].values)
        {
            tics.push_back(fmt::format("'{0}' {0}", numberText(resolutionValue(value).value_or(1))));
        }
        text += fmt::format("set xtics ({})\nunset mxtics\n", fmt::join(tics, ", "));
    }
    text += "set encoding utf8\n";
    for (const char* kind : {"png", "svg"})
    {
        text += fmt::format("set terminal {} enhanced size 1000,{} font 'sans,13'\nset output {}\n",
                            kind == std::string("png") ? "pngcairo" : "svg background 'white'", 560 + 24 * rows,
                            quoted(fmt::format("{}.{}", picture.name, kind)));
        text += fmt::format("plot {}\n", fmt::join(curves, ", \\\n     "));
    }
    return text;
}

} // namespace

Drawing writePictures(const Results& results, const fs::path& folder)
{
    const fs::path gnuplot = findProgram("gnuplot");
    Drawing drawing{.gnuplot = !gnuplot.empty(), .drawn = {}, .empty = {}};
    for (const Picture& picture : results.sweep().pictures)
    {
        if (seriesOf(results, picture).empty())
        {
            for (const char* kind : {".gp", ".svg", ".png"}) { fs::remove(folder / (picture.name + kind)); }
            drawing.empty.push_back(picture.name);
            continue;
        }
        const fs::path script = folder / (picture.name + ".gp");
        writeTextFile(script, pictureScript(results, picture));
        if (gnuplot.empty()) { continue; }
        const fs::path log = folder / (picture.name + ".log");
        fs::remove(log);
        ChildProcess child(
            {.words = {gnuplot.string(), picture.name + ".gp"}, .folder = folder, .log = log, .environment = {}});
        child.wait();
        if (child.exitCode() != 0)
        {
            std::ifstream said(log);
            std::string first;
            std::getline(said, first);
            throw Error(Fault::input, {script.string(), 0, ""},
                        fmt::format("gnuplot failed with exit code {}", child.exitCode()), first);
        }
        fs::remove(log);
        drawing.drawn.push_back(picture.name);
    }
    return drawing;
}

} // namespace isph
