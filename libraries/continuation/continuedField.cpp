#include "continuation/continuedField.hpp"

#include "continuation/ContinuedTransform.hpp"

#include <utility>
#include <vector>

namespace isph
{

namespace
{

/// The axis with its new points.
Axis extendedAxis(Axis axis, int newPoints)
{
    const double spacing = axis.spacing();
    axis.origin = axis.coordinate(0);
    axis.count += newPoints;
    axis.extent = axis.count * spacing;
    axis.ends = Axis::Ends::periodic;
    axis.staggered = false;
    return axis;
}

} // namespace

Lattice extendedLattice(const Lattice& lattice, const Continuations& continuations)
{
    std::array<Axis, 3> axes;
    for (std::size_t d = 0; d < 3; ++d)
    {
        axes[d] = lattice.axis(static_cast<int>(d));
        if (continuations[d]) { axes[d] = extendedAxis(axes[d], continuations[d]->newPoints()); }
    }
    std::vector<Patch> patches;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const std::string name(1, lattice.activeAxis(d).name);
        patches.push_back({name, Patch::Type::periodic, {name + "Min", name + "Max"}});
    }
    return {axes, std::move(patches)};
}

RealField continuedField(const RealField& field, const Lattice& lattice, const Continuations& continuations)
{
    RealField values = copyOf(field);
    std::array<std::size_t, 3> counts{};
    for (std::size_t d = 0; d < 3; ++d)
    {
        counts[d] = static_cast<std::size_t>(lattice.axis(static_cast<int>(d)).count);
    }
    for (std::size_t d = 0; d < 3; ++d)
    {
        if (!continuations[d]) { continue; }
        LineLayout layout;
        layout.count = counts[d];
        for (std::size_t other = 0; other < 3; ++other)
        {
            if (other < d) { layout.inner *= counts[other]; }
            if (other > d) { layout.outer *= counts[other]; }
        }
        const LineContinuation continuation(*continuations[d], static_cast<int>(counts[d]));
        const auto extendedCount = static_cast<std::size_t>(continuation.extendedPoints());
        ContinuedTransform transform(layout, continuation);
        const LineLayout extendedLayout = layout.withCount(extendedCount);
        RealField extended(values.components(), extendedLayout.points());
        for (int component = 0; component < values.components(); ++component)
        {
            for (std::size_t batch = 0; batch < transform.batches(); ++batch)
            {
                const RealField& lines = transform.extended(batch, values[component]);
                scatterLines(lines, extendedLayout, batch * static_cast<std::size_t>(lines.components()),
                             extended[component]);
            }
        }
        values = std::move(extended);
        counts[d] = extendedCount;
    }
    return values;
}

} // namespace isph
