#include "continuation/LineLayout.hpp"

namespace isph
{

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
