// The schemes of the papers as their presets have them, between walls: what they reach, and from how many points on
// they are stable (docs/theory/errata.md).

#include "flow/readFlowSettings.hpp"
#include "operators/continuedBounds.hpp"
#include "schemes/TimeScheme.hpp"
#include "support/channelRun.hpp"
#include "support/record.hpp"

#include <numbers>

using namespace isph;
using namespace isph::test;
using std::numbers::pi;

namespace
{

/// A channel whose lines along it are longer than the reach of the papers' kernel.
Lattice channelOf(int intervals, bool staggered)
{
    Axis x{.name = 'x', .extent = 1, .count = 24};
    Axis y{.name = 'y', .extent = 1, .count = staggered ? intervals : intervals + 1, .ends = Axis::Ends::bounded};
    y.staggered = staggered;
    return Lattice({x, y, Axis{.name = 'z'}}, {{"sides", Patch::Type::periodic, {"xMin", "xMax"}},
                                               {"lower", Patch::Type::wall, {"yMin"}},
                                               {"upper", Patch::Type::wall, {"yMax"}}});
}

FlowSettings preset(const std::string& name, const Lattice& lattice)
{
    return readFlowSettings(Dictionary::parse("preset " + name + ";", "schemes"), Dictionary::parse("", "solution"),
                            lattice, Fluid{.nu = 0.01});
}

/// Lattices of the papers: mirrors act between points half a spacing off the walls, polynomials from points on them.
BoundedRun paperRun(const std::string& name, const Channel& channel)
{
    Lattice lattice = channelOf(channel.intervals, name == "paper2021");
    Fluid fluid = channelFluid(lattice, channel);
    FlowSettings settings = preset(name, lattice);
    return BoundedRun(std::move(lattice), std::move(fluid), std::move(settings), channelWalls(channel));
}

void marchStably(BoundedRun& run, double end)
{
    const double dt = 0.8 * largestStableStep(*run.settings.time, run.flow.rates());
    run.march(end, static_cast<int>(std::ceil((end - run.t) / dt)));
}

double parabola(double y) { return 4 * y * (1 - y); }

/// Poiseuille's flow, Re 100, from its steady profile: how far the profile has moved off.
double offTheParabola(const std::string& name, int intervals, double end)
{
    BoundedRun run = paperRun(name, {.intervals = intervals, .nu = 0.01, .force = 0.08});
    run.start([](int c, double, double y, double) { return c == 0 ? parabola(y) : 0.0; });
    marchStably(run, end);
    return errorOf(run, [](double y, double) { return parabola(y); });
}

double couette(double y, double diffused)
{
    double u = y;
    for (int n = 1; n < 60; ++n)
    {
        u += 2 / (n * pi) * (n % 2 == 0 ? 1 : -1) * std::sin(n * pi * y) * std::exp(-n * n * pi * pi * diffused);
    }
    return u;
}

} // namespace

TEST(Paper2021, poiseuilleIsOfSecondOrder)
{
    double before = 0;
    for (const auto& [intervals, most] : {std::pair{20, 1.7e-3}, {40, 3.2e-4}, {80, 6.3e-5}})
    {
        const double error = offTheParabola("paper2021", intervals, 11);
        record("N " + std::to_string(intervals), error);
        EXPECT_LE(error, most) << intervals;
        if (before > 0) { EXPECT_GE(observedOrder(before, error), 2.0) << intervals; }
        before = error;
    }
}

TEST(Paper2021, mirrorsTakeTheVelocityOfAMovingWall)
{
    double before = 0;
    for (const int intervals : {20, 40, 80})
    {
        BoundedRun run = paperRun(
            "paper2021", {.intervals = intervals, .nu = 0.01, .upper = [](int c, double, double, double, double) {
                              return c == 0 ? 1.0 : 0.0;
                          }});
        run.start([](int, double, double, double) { return 0.0; });
        marchStably(run, 10);
        const double error = errorOf(run, [](double y, double) { return couette(y, 0.1); });
        record("N " + std::to_string(intervals), error);
        EXPECT_LE(error, 0.6 / intervals / intervals);
        if (before > 0) { EXPECT_GE(observedOrder(before, error), 1.7) << intervals; }
        before = error;
    }
}

// Of fitted polynomials through few points the second derivative has positive eigenvalues.
TEST(Paper2026, viscosityMakesModesGrowBelow56Intervals)
{
    for (const auto& [intervals, stable] :
         {std::pair{20, false}, {32, false}, {40, false}, {48, false}, {56, true}, {64, true}, {80, true}, {128, true}})
    {
        const Lattice lattice = channelOf(intervals, false);
        const FlowSettings settings = preset("paper2026", lattice);
        const OperatorBounds bounds =
            continuedBounds(lattice, settings.continuations, settings.kernel, settings.laplacian);
        record("N " + std::to_string(intervals), -bounds.leastLaplacian);
        EXPECT_EQ(bounds.leastLaplacian >= 0, stable) << intervals;
    }
    EXPECT_FALSE(offTheParabola("paper2026", 40, 3) < 1);
}

TEST(Paper2026, poiseuilleStaysFrom80Intervals)
{
    const double coarse = offTheParabola("paper2026", 80, 11);
    record("N 80", coarse);
    EXPECT_LE(coarse, 5e-4);
    const double fine = offTheParabola("paper2026", 112, 3);
    record("N 112, t 3", fine);
    EXPECT_LE(fine, 0.7 * coarse);
}
