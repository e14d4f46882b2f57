// Friction that rules: Couette flow at Re 0.01 whose wall changes its speed smoothly, in steps far beyond the limit of
// an explicit scheme, and channels that are a hundred times as long as wide.

#include "flow/stableNumbers.hpp"
#include "support/channelRun.hpp"
#include "support/record.hpp"

#include <complex>
#include <numbers>
#include <vector>

using namespace isph;
using namespace isph::test;
using std::numbers::pi;

namespace
{

constexpr double nu = 100; // of the speed and the distance 1 of the plates: Re = 0.01
constexpr double omega = 2 * pi / 0.1;

constexpr double width = 0.01; // of the long channels
constexpr double longChannelViscosity = 0.01;

/// The upper wall gathers speed and loses it again, with the velocity of the fluid that goes with it.
double wallSpeed(double t) { return (1 - std::cos(omega * t)) / 2; }

double exact(double y, double t)
{
    using namespace std::complex_literals;
    const std::complex<double> m = std::sqrt(1i * omega / nu);
    return (y - std::real(std::sinh(m * y) / std::sinh(m) * std::exp(1i * omega * t))) / 2;
}

BoundedRun couetteRun(int intervals)
{
    FlowSettings settings = gaussianSettings(channelLattice(intervals));
    settings.crankNicolson = true;
    return channelRun({.intervals = intervals,
                       .nu = nu,
                       .upper = [](int c, double, double, double, double t) { return c == 0 ? wallSpeed(t) : 0.0; }},
                      std::move(settings));
}

double explicitLimit(int intervals)
{
    const BoundedRun run = couetteRun(intervals);
    return run.settings.time->realLimit / (nu * run.flow.bounds().laplacian);
}

/// A channel with a length of 1 and a hundredth of it between the walls, as many points as wanted along both.
BoundedRun longChannel(int along, int across, double force, bool implicit)
{
    Axis x{.name = 'x', .extent = 1, .count = along};
    Axis y{.name = 'y', .extent = width, .count = across + 1, .ends = Axis::Ends::bounded};
    Lattice lattice({x, y, Axis{.name = 'z'}}, {{"sides", Patch::Type::periodic, {"xMin", "xMax"}},
                                                {"walls", Patch::Type::wall, {"yMin", "yMax"}}});
    FlowSettings settings = gaussianSettings(lattice);
    settings.crankNicolson = implicit;
    Fluid fluid = channelFluid(lattice, {.intervals = across, .nu = longChannelViscosity, .force = force});
    return BoundedRun(std::move(lattice), std::move(fluid), std::move(settings), channelWalls({}));
}

/// Vortices as wide as the channel, of speed 1 along it, and a little noise.
double vortices(int c, double x, double y, double)
{
    const double k = 2 * pi;
    const double l = pi / width;
    const double noise = 1e-3 * std::sin(1e4 * x + 3e5 * y * y);
    return c == 0 ? std::sin(k * x) * std::sin(2 * l * y) + noise
                  : -k / l * std::cos(k * x) * std::pow(std::sin(l * y), 2);
}

double energy(BoundedRun& run)
{
    const double size = norm(run.flow.velocity());
    return size * size;
}

} // namespace

TEST(StiffWalls, couetteInStepsBeyondTheExplicitLimit)
{
    constexpr int intervals = 32;
    const double limit = explicitLimit(intervals);
    std::vector<double> errors;
    for (const double times : {1000.0, 500.0, 250.0, 125.0})
    {
        BoundedRun run = couetteRun(intervals);
        run.start([](int c, double, double y, double) { return c == 0 ? exact(y, 0) : 0.0; });
        constexpr double end = 0.1;
        const int steps = static_cast<int>(std::ceil(end / (times * limit)));
        double worst = 0;
        for (int step = 1; step <= steps; ++step)
        {
            run.march(end * step / steps, 1);
            worst = std::max(worst, errorOf(run, [&](double y, double) { return exact(y, run.t); }));
        }
        errors.push_back(worst);
        record("dt over the explicit limit " + std::to_string(times), worst);
    }
    EXPECT_LE(errors[0], 5e-6);
    // Forty steps a period are not many: the order rises to 2.
    for (std::size_t i = 1; i < errors.size(); ++i) { EXPECT_GE(observedOrder(errors[i - 1], errors[i]), 1.7) << i; }
    EXPECT_GE(observedOrder(errors[2], errors[3]), 1.9);
}

TEST(StiffWalls, aJumpOfTheWallDiesInAnyStep)
{
    for (const double times : {1.0, 10.0, 1000.0, 1e5})
    {
        BoundedRun run = channelRun({.intervals = 32,
                                     .nu = nu,
                                     .upper = [](int c, double, double, double, double) { return c == 0 ? 1.0 : 0.0; }},
                                    std::move(couetteRun(32).settings));
        run.start([](int, double, double, double) { return 0.0; });
        const double before = errorOf(run, [](double y, double) { return y; });
        run.march(400 * times * explicitLimit(32), 400);
        const double after = errorOf(run, [](double y, double) { return y; });
        record("dt over the explicit limit " + std::to_string(times), after);
        EXPECT_LE(after, before) << times;
    }
}

TEST(StiffWalls, explicitInChannelsOfAspectRatioHundred)
{
    for (const auto& [along, across] : {std::pair{16, 32}, {1024, 16}})
    {
        BoundedRun run = longChannel(along, across, 0, false);
        run.start(vortices);
        const double dt = 0.95 * run.settings.time->realLimit / (longChannelViscosity * run.flow.bounds().laplacian);
        const double start = energy(run);
        double before = start;
        for (int step = 1; step <= 300; ++step)
        {
            run.march(run.t + dt, 1);
            const double now = energy(run);
            ASSERT_LE(now, before * (1 + 1e-9)) << along << " x " << across << ", step " << step;
            before = now;
        }
        record(std::to_string(along) + " x " + std::to_string(across), before / start);
        EXPECT_LT(before, 0.5 * start);
    }
}

TEST(StiffWalls, implicitInChannelsOfAspectRatioHundred)
{
    struct Asked
    {
        int along;
        int across;
        double times; // of the explicit limit
    };
    // Vortices and noise die, slowly as under Crank-Nicolson, and the force drives a parabola of speed 1.
    for (const auto& [along, across, times] : {Asked{16, 32, 1000}, {1024, 16, 50}})
    {
        BoundedRun run = longChannel(along, across, 8 * longChannelViscosity / (width * width), true);
        run.start(vortices);
        const double limit = run.settings.time->realLimit / (longChannelViscosity * run.flow.bounds().laplacian);
        run.march(200 * times * limit, 200);
        const double error = errorOf(run, [](double y, double) { return 4 * y / width * (1 - y / width); });
        record(std::to_string(along) + " x " + std::to_string(across), error);
        EXPECT_LE(error, 1e-5) << along;
    }
}
