#include "continuationFiles.hpp"

#include "case/CsvWriter.hpp"
#include "continuation/LineLayout.hpp"
#include "continuation/LineSymbol.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numbers>
#include <vector>

namespace isph
{

namespace
{

constexpr std::size_t linesLookedAt = 200; ///< spread over the field: all of them would take longer than to continue it

std::vector<double> lineOf(std::span<const double> values, const LineLayout& layout, std::size_t line)
{
    std::vector<double> points(layout.count);
    for (std::size_t i = 0; i < layout.count; ++i) { points[i] = values[layout.start(line) + i * layout.inner]; }
    return points;
}

Smoothness worstOf(std::span<const double> values, const LineLayout& layout, int points)
{
    Smoothness worst;
    const auto raise = [](auto& to, const auto& by)
    { std::ranges::transform(to, by, to.begin(), [](double a, double b) { return std::max(a, b); }); };
    const std::size_t stride = std::max<std::size_t>(layout.lines() / linesLookedAt, 1);
    for (std::size_t line = 0; line < layout.lines(); line += stride)
    {
        const Smoothness found = smoothnessOf(lineOf(values, layout, line), points);
        raise(worst.upperJump, found.upperJump);
        raise(worst.lowerJump, found.lowerJump);
        worst.tail = std::max(worst.tail, found.tail);
    }
    return worst;
}

/// The line along an axis through the middle of the points that are not new.
std::size_t middleLine(const Lattice& lattice, const Lattice& extended, int direction)
{
    std::size_t line = 0;
    for (int d = 2; d >= 0; --d)
    {
        if (d == direction) { continue; }
        line = line * static_cast<std::size_t>(extended.axis(d).count) +
               static_cast<std::size_t>(lattice.axis(d).count / 2);
    }
    return line;
}

std::filesystem::path fileOf(const Case& theCase, const std::string& time, const std::string& file)
{
    return postProcessingFile(theCase.directory(), "fcExtend", time, file);
}

void writeLine(const FieldFiles& files, const Axis& axis, std::span<const double> line, int points)
{
    const std::string place(1, axis.name);
    CsvWriter csv(fileOf(files.theCase, files.time, fmt::format("line_{}_{}.csv", files.name, axis.name)),
                  {{place, "m"}, {files.name, files.unit}, {"new"}});
    for (int i = 0; i < static_cast<int>(line.size()); ++i)
    {
        csv.row({axis.coordinate(i), line[static_cast<std::size_t>(i)], i < points ? 0.0 : 1.0});
    }
    // The point where the period closes, so that a curve through the rows shows that seam too.
    csv.row({axis.origin + axis.extent, line[0], 1.0});

    const std::vector<double> spectrum = spectrumOf(line);
    CsvWriter modes(fileOf(files.theCase, files.time, fmt::format("spectrum_{}_{}.csv", files.name, axis.name)),
                    {{"mode"}, {"k", "rad/m"}, {"amplitude", files.unit}});
    for (std::size_t m = 0; m < spectrum.size(); ++m)
    {
        modes.row({static_cast<double>(m), 2 * std::numbers::pi * static_cast<double>(m) / axis.extent, spectrum[m]});
    }
}

} // namespace

void reportSmoothness(const FieldFiles& files, const Lattice& lattice, const Lattice& extended,
                      const Continuations& continuations, std::span<const double> continued, Log& log)
{
    for (int direction = 0; direction < 3; ++direction)
    {
        if (!continuations[static_cast<std::size_t>(direction)]) { continue; }
        const Axis& axis = extended.axis(direction);
        const int points = lattice.axis(direction).count;
        const LineLayout layout = linesAlong(extended, direction);
        const Smoothness worst = worstOf(continued, layout, points);
        const auto text = [](const auto& jumps) { return fmt::format("{:9.1e}", fmt::join(jumps, " ")); };
        log.line(fmt::format("    {} along {}: {} + {} points", files.name, axis.name, points, axis.count - points));
        log.line(fmt::format("        jumps of derivatives 1 ... {} at {}Max {}", Smoothness::derivatives, axis.name,
                             text(worst.upperJump)));
        log.line(fmt::format("                                     at {}Min {}", axis.name, text(worst.lowerJump)));
        log.line(fmt::format("        spectrum: upper third of the wavenumbers below {:.1e} of the largest mode",
                             worst.tail));

        CsvWriter csv(fileOf(files.theCase, files.time, fmt::format("smoothness_{}_{}.csv", files.name, axis.name)),
                      {{"derivative"}, {"jumpMax"}, {"jumpMin"}, {"spectrumTail"}});
        for (std::size_t p = 0; p < Smoothness::derivatives; ++p)
        {
            csv.row({static_cast<double>(p + 1), worst.upperJump[p], worst.lowerJump[p], worst.tail});
        }
        writeLine(files, axis, lineOf(continued, layout, middleLine(lattice, extended, direction)), points);
    }
}

void writeSymbol(const Case& theCase, const std::string& time, const Axis& extendedAxis, const KernelSettings& kernel)
{
    const LineSymbol symbol = lineSymbol(kernel, extendedAxis.count, extendedAxis.spacing());
    const double nyquist = std::numbers::pi / extendedAxis.spacing();
    CsvWriter csv(fileOf(theCase, time, fmt::format("symbol_{}.csv", extendedAxis.name)),
                  {{"k/kNyquist"}, {"W"}, {"gradient/kNyquist"}, {"laplacian/kNyquist2"}});
    for (std::size_t m = 0; m < symbol.first.size(); ++m)
    {
        const double k = 2.0 * static_cast<double>(m) / extendedAxis.count;
        const double second = symbol.second[m] / (nyquist * nyquist);
        csv.row({k, m == 0 ? 1 : second / (k * k), symbol.first[m] / nyquist, second});
    }
}

} // namespace isph
