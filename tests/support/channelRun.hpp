#pragma once

#include "kernels/Gaussian.hpp"
#include "support/boundedRun.hpp"

#include <algorithm>

namespace isph::test
{

/// A channel between y = 0 and y = 1 of period 1 along x, for flows along x that do not change along it.
struct Channel
{
    int intervals;           ///< across
    double nu;               ///< [m2/s]
    double force = 0;        ///< along x [m/s2]
    PlaceAndTime lower = {}; ///< velocity of the walls; none: at rest
    PlaceAndTime upper = {};
};

inline Lattice channelLattice(int intervals)
{
    Axis x{.name = 'x', .extent = 1, .count = 8};
    Axis y{.name = 'y', .extent = 1, .count = intervals + 1, .ends = Axis::Ends::bounded};
    return Lattice({x, y, Axis{.name = 'z'}}, {{"sides", Patch::Type::periodic, {"xMin", "xMax"}},
                                               {"lower", Patch::Type::wall, {"yMin"}},
                                               {"upper", Patch::Type::wall, {"yMax"}}});
}

inline Fluid channelFluid(const Lattice& lattice, const Channel& channel)
{
    Fluid fluid{.nu = channel.nu};
    if (channel.force != 0)
    {
        fluid.bodyForce = std::make_unique<PlainForce>(
            lattice, [force = channel.force](int c, double, double, double, double) { return c == 0 ? force : 0.0; });
    }
    return fluid;
}

inline std::array<std::array<FaceCondition, 2>, 3> channelWalls(const Channel& channel)
{
    std::array<std::array<FaceCondition, 2>, 3> faces;
    faces[1] = {channel.lower ? movingWall("lower", channel.lower, true) : wallAtRest("lower"),
                channel.upper ? movingWall("upper", channel.upper, true) : wallAtRest("upper")};
    return faces;
}

/// The defaults between walls with a Gaussian kernel: of order 20 and h/dx = 1.5 unless told otherwise.
inline FlowSettings gaussianSettings(const Lattice& lattice, int order = 20, double smoothingLength = 1.5)
{
    FlowSettings settings = boundedSettings(lattice);
    settings.kernel.kernel = std::make_unique<Gaussian>(order);
    settings.kernel.smoothingLength = smoothingLength;
    return settings;
}

inline BoundedRun channelRun(const Channel& channel, FlowSettings settings)
{
    Lattice lattice = channelLattice(channel.intervals);
    Fluid fluid = channelFluid(lattice, channel);
    return BoundedRun(std::move(lattice), std::move(fluid), std::move(settings), channelWalls(channel));
}

inline BoundedRun channelRun(const Channel& channel)
{
    return channelRun(channel, gaussianSettings(channelLattice(channel.intervals)));
}

/// Marches in equal steps of at most 0.2 h^2/nu, h the smallest spacing.
inline void marchExplicitly(BoundedRun& run, double end)
{
    double h = 1;
    for (int d = 0; d < run.lattice.dimensions(); ++d) { h = std::min(h, run.lattice.activeAxis(d).spacing()); }
    run.march(end, static_cast<int>(std::ceil((end - run.t) * run.fluid.nu / (0.2 * h * h))));
}

/// Root mean square over the points of the distance of the velocity from a flow along x.
inline double errorOf(BoundedRun& run, const std::function<double(double, double)>& exact)
{
    const auto [x, y, z] = run.lattice.coordinates();
    const RealField& u = run.flow.velocity();
    double sum = 0;
    for (std::size_t i = 0; i < u.size(); ++i)
    {
        sum += std::pow(u[0][i] - exact(y[i], z[i]), 2);
        for (int c = 1; c < u.components(); ++c) { sum += u[c][i] * u[c][i]; }
    }
    return std::sqrt(sum / static_cast<double>(u.size()));
}

inline double observedOrder(double before, double now, double ratio = 2)
{
    return std::log(before / now) / std::log(ratio);
}

} // namespace isph::test
