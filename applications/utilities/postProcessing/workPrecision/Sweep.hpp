#pragma once

#include "dictionary/Dictionary.hpp"

#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace isph
{

/// A number got from what a run leaves behind.
struct Quantity
{
    enum class Source
    {
        report,   ///< a number of postProcessing/report.json
        function, ///< a column of a function's CSV, reduced to a number
        line,     ///< a sampled profile, reduced to a number or compared with a reference profile
        command,  ///< what a command of the shell prints
        largestOf ///< the largest of other quantities
    };
    enum class Reduction
    {
        last,
        first,
        max,
        min,
        peak ///< vertex of the parabola through the largest local maximum and its neighbours
    };
    enum class Norm
    {
        max,
        rms
    };
    /// Two columns of a CSV file.
    struct Profile
    {
        std::filesystem::path file; ///< relative to the case of the sweep
        std::string abscissa;
        std::string column;
    };

    std::string name;
    Source source = Source::report;
    std::string from;                ///< key of the report, function, line, or command
    std::vector<std::string> others; ///< of largestOf: their names
    std::string column;              ///< of the function or the line
    std::string abscissa;
    Reduction reduction = Reduction::last;
    Norm norm = Norm::max;
    std::optional<double> at; ///< time of the row that counts [s]
    double begin = -std::numeric_limits<double>::infinity();
    double end = std::numeric_limits<double>::infinity();
    bool overFirst = false;          ///< divide by the first row
    std::optional<double> reference; ///< relative difference to it
    std::optional<Profile> profile;
    std::string per;       ///< key of the report to divide by
    bool optional = false; ///< not-a-number where a run has no such number
    std::string label;
    Origin origin;
};

/// One number of the lattice, the schemes, ... that is varied.
struct Parameter
{
    std::string name;
    std::vector<std::string> values; ///< as they are written into dictionaries
    std::string entry;               ///< "system/latticeDict.count" if it is set directly
    Origin origin;
};

/// One calculation of the sweep.
struct Run
{
    std::size_t line = 0;            ///< of Sweep::lines
    std::vector<std::string> values; ///< of Sweep::parameters
    double resolution = 0;           ///< value of the parameter along the line
    std::filesystem::path folder;    ///< relative to the case
    Dictionary settings;             ///< file -> entries to set
    Dictionary replacements;         ///< file -> its whole content
    std::vector<Quantity> quantities;
};

/// Resolutions that slopes are fitted to.
struct FitRange
{
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
};

/// What one curve of the picture is made of: a variant with the values of all parameters but the resolution.
struct Line
{
    std::string name;
    std::string title;
    FitRange fit;
};

/// Results that were not made here, read from a CSV file.
struct External
{
    std::string name;
    std::string title;
    std::map<std::string, std::vector<double>, std::less<>> columns; ///< named as ours
};

/// A picture: y against x, both names of columns of the table.
struct Picture
{
    std::string name;
    std::string x;
    std::string y;
    std::string title;
    std::string xLabel;
    std::string yLabel;
    bool logX = true;
    bool logY = true;
    Origin origin;
};

/// The number that a value of the resolution stands for: itself, or the largest of a list, "(40 20 1)"; none if it is
/// no number.
std::optional<double> resolutionValue(const std::string& value);

/// A whole sweep, as system/workPrecisionDict describes it.
struct Sweep
{
    std::filesystem::path baseCase;
    std::vector<std::string> commands; ///< the last one is the solver, whose time counts
    std::vector<std::string> after;    ///< what else is run for its results
    int threads = 1;
    int jobs = 1;
    int repetitions = 1;
    double timeLimit = std::numeric_limits<double>::infinity(); ///< of the solver in one run [s]
    std::vector<Parameter> parameters;
    std::size_t resolution = 0; ///< the parameter along a line
    std::vector<Line> lines;
    std::vector<Run> runs; ///< coarse ones of all lines first
    std::vector<std::string> measures;
    std::vector<std::string> collected;
    std::vector<External> externals;
    std::vector<Picture> pictures;
    std::string title;
    bool reduced = false;

    const std::string& resolutionName() const { return parameters[resolution].name; }
};

} // namespace isph
