#include "flow/OutflowCondition.hpp"

#include "flow/faceConditions.hpp"

#include <algorithm>

namespace isph
{

OutflowCondition::OutflowCondition(const Lattice& lattice, const FlowBoundary& boundary)
{
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const Axis& axis = lattice.activeAxis(d);
        if (axis.periodic() || axis.staggered) { continue; }
        for (const Side side : {Side::low, Side::high})
        {
            if (boundary.face(lattice.direction(d), side).velocity != VelocityCondition::outflow) { continue; }
            const LineLayout lines = linesAlong(lattice, lattice.direction(d));
            outlets_.push_back({d, lines, side == Side::high, axis.spacing(), std::vector<double>(lines.lines())});
        }
    }
}

void OutflowCondition::keep(int d, std::span<const double> rate)
{
    for (Outlet& outlet : outlets_)
    {
        if (outlet.d != d) { continue; }
        const std::size_t end = outlet.high ? (outlet.lines.count - 1) * outlet.lines.inner : 0;
        for (std::size_t l = 0; l < outlet.kept.size(); ++l) { outlet.kept[l] = rate[outlet.lines.start(l) + end]; }
    }
}

void OutflowCondition::replace(int d, std::span<const double> u, std::span<const double> carrier,
                               std::span<double> rate) const
{
    for (const Outlet& outlet : outlets_)
    {
        if (outlet.d != d) { continue; }
        const std::size_t end = outlet.high ? (outlet.lines.count - 1) * outlet.lines.inner : 0;
        const std::size_t inner = outlet.lines.inner;
        for (std::size_t l = 0; l < outlet.kept.size(); ++l)
        {
            const std::size_t point = outlet.lines.start(l) + end;
            rate[point] = outlet.kept[l];
            const double outwards = carrier.empty() ? 0 : (outlet.high ? carrier[point] : -carrier[point]);
            if (outwards <= 0) { continue; }
            const auto inside = [&](std::size_t k) { return u[outlet.high ? point - k * inner : point + k * inner]; };
            double difference = 0;
            for (std::size_t k = 0; k < outletDifference.size(); ++k) { difference += outletDifference[k] * inside(k); }
            rate[point] -= outwards * difference / outlet.spacing;
        }
    }
}

} // namespace isph
