#pragma once

#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"

#include <algorithm>
#include <span>

namespace isph
{

/// Where the lines along one axis lie in a component of a field. Line l has its point i at start(l) + i*inner.
struct LineLayout
{
    std::size_t inner = 1; ///< points of the faster axes: the distance of neighbours on a line
    std::size_t count = 1; ///< points of a line
    std::size_t outer = 1; ///< points of the slower axes

    std::size_t lines() const { return inner * outer; }
    std::size_t points() const { return inner * count * outer; }
    std::size_t start(std::size_t line) const { return line / inner * inner * count + line % inner; }

    /// The same lines with another number of points.
    LineLayout withCount(std::size_t points) const { return {inner, points, outer}; }
};

/// The lines along a direction (0, 1, 2) of a lattice.
LineLayout linesAlong(const Lattice& lattice, int direction);

/// Calls visit(point, place in the data of a field of lines) for every point of a batch of lines: batch of them from
/// first on, stride the distance of lines in their field. Neighbouring lines go together: along the slower axes their
/// points lie side by side.
template<class Visit>
void forEachPoint(const LineLayout& layout, std::size_t first, std::size_t stride, std::size_t batch, Visit visit)
{
    const std::size_t end = std::min(first + batch, layout.lines());
    for (std::size_t line = first; line < end;)
    {
        const std::size_t together = std::min(end - line, layout.inner - line % layout.inner);
        const std::size_t start = layout.start(line);
        for (std::size_t i = 0; i < layout.count; ++i)
        {
            for (std::size_t l = 0; l < together; ++l)
            {
                visit(start + i * layout.inner + l, (line - first + l) * stride + i);
            }
        }
        line += together;
    }
}

/// Copies lines first, first + 1, ... of values into the first values of the components of lines, as many as there are.
void gatherLines(std::span<const double> values, const LineLayout& layout, std::size_t first, RealField& lines);

/// The reverse: puts the first layout.count values of each component into lines first, first + 1, ... of values.
void scatterLines(const RealField& lines, const LineLayout& layout, std::size_t first, std::span<double> values);

} // namespace isph
