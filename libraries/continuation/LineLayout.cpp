#include "continuation/LineLayout.hpp"

#include <algorithm>

namespace isph
{

namespace
{

/// Calls visit(place in the values, place in the data of lines) for every point of the batch. Neighbouring lines go
/// together: along the slower axes their points lie side by side.
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

} // namespace

LineLayout linesAlong(const Lattice& lattice, int direction)
{
    LineLayout layout;
    for (int d = 0; d < 3; ++d)
    {
        const auto n = static_cast<std::size_t>(lattice.axis(d).count);
        if (d < direction) { layout.inner *= n; }
        else if (d == direction) { layout.count = n; }
        else { layout.outer *= n; }
    }
    return layout;
}

void gatherLines(std::span<const double> values, const LineLayout& layout, std::size_t first, RealField& lines)
{
    double* to = lines.data();
    forEachPoint(layout, first, lines.stride(), static_cast<std::size_t>(lines.components()),
                 [values, to](std::size_t from, std::size_t place) { to[place] = values[from]; });
}

void scatterLines(const RealField& lines, const LineLayout& layout, std::size_t first, std::span<double> values)
{
    const double* from = lines.data();
    forEachPoint(layout, first, lines.stride(), static_cast<std::size_t>(lines.components()),
                 [values, from](std::size_t to, std::size_t place) { values[to] = from[place]; });
}

} // namespace isph
