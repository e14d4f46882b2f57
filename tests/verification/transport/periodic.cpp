// A scalar in periodic boxes: what transport does to a mode is known to round-off.

#include "support/record.hpp"
#include "support/transportRun.hpp"

#include <complex>
#include <gtest/gtest.h>
#include <numbers>

using namespace isph;
using namespace isph::test;

namespace
{

using std::numbers::pi;

/// What a step of RK3 multiplies a mode by.
std::complex<double> growth(std::complex<double> z) { return 1.0 + z + z * z / 2.0 + z * z * z / 6.0; }

} // namespace

TEST(PeriodicTransport, aModeGrowsAsTheTimeSchemeSays)
{
    const Lattice lattice = boxOf({24, 20, 0}, {false, false, false});
    const double DT = 0.003;
    const std::array<double, 3> U{1.3, -0.7, 0};
    TransportRun run(lattice, DT, transportSettings(lattice), uniformVelocity(U), {});
    const auto wave = [](double x, double y, double, double) { return std::sin(2 * pi * (3 * x - 2 * y) + 0.4); };
    run.start(wave);
    const int steps = 40;
    const double dt = 0.01;
    run.march(steps * dt, steps);
    const double k2 = 4 * pi * pi * (9 + 4);
    const std::complex<double> z(-DT * k2 * dt, -dt * 2 * pi * (3 * U[0] - 2 * U[1]));
    const std::complex<double> factor = std::pow(growth(z), steps);
    const double error = run.error(
        [&](double x, double y, double, double)
        {
            const std::complex<double> phase(0, 2 * pi * (3 * x - 2 * y) + 0.4);
            return std::imag(factor * std::exp(phase));
        });
    record("error", error);
    EXPECT_LE(error, 1e-13);
}

TEST(PeriodicTransport, aSmoothBlobIsTranslated)
{
    const auto exact = [](double x, double y, double, double t)
    { return std::exp(std::cos(2 * pi * (x - t)) + std::sin(2 * pi * (y - 0.5 * t))); };
    std::array<double, 2> errors{};
    for (std::size_t i = 0; i < 2; ++i)
    {
        const Lattice lattice = boxOf({48, 48, 0}, {false, false, false});
        TransportRun run(lattice, 0, transportSettings(lattice), uniformVelocity({1, 0.5, 0}), {});
        run.start(exact);
        run.march(2, 400 << i); // twice through the box
        errors[i] = run.error(exact);
    }
    record("error", errors[1]);
    EXPECT_LE(errors[1], 1e-4);
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 3, 0.05);
}

TEST(PeriodicTransport, aVelocityThatChangesIsEvaluatedInEverySubstep)
{
    const auto exact = [](double x, double y, double, double t)
    { return std::sin(2 * pi * (x - 0.3 * std::sin(2 * t))) * std::cos(2 * pi * (y + t * t / 2)); };
    std::array<double, 2> errors{};
    for (std::size_t i = 0; i < 2; ++i)
    {
        const Lattice lattice = boxOf({16, 16, 0}, {false, false, false});
        TransportRun run(
            lattice, 0, transportSettings(lattice),
            [](int direction, double, double, double, double t) { return direction == 0 ? 0.6 * std::cos(2 * t) : -t; },
            {}, true);
        run.start(exact);
        run.march(1, 50 << i);
        errors[i] = run.error(exact);
    }
    record("order", std::log2(errors[0] / errors[1]));
    EXPECT_GE(std::log2(errors[0] / errors[1]), 2.9);
}

TEST(PeriodicTransport, dealiasingKeepsAShearedScalarBounded)
{
    const Lattice lattice = boxOf({32, 32, 0}, {false, false, false});
    FlowSettings settings = transportSettings(lattice);
    settings.dealiasing = Dealiasing::twoThirds;
    TransportRun run(lattice, 0, std::move(settings),
                     [](int direction, double x, double y, double, double) {
                         return direction == 0 ? -std::sin(2 * pi * y) * std::cos(2 * pi * x)
                                               : std::sin(2 * pi * x) * std::cos(2 * pi * y);
                     },
                     {});
    EXPECT_TRUE(run.transport.dealiases());
    run.start([](double x, double, double, double) { return std::cos(2 * pi * x); });
    run.marchAtCourant(4, 0.4);
    EXPECT_TRUE(run.transport.sound(3));
}

TEST(PeriodicTransport, aUniformVelocityNeedsNoDealiasing)
{
    const Lattice lattice = boxOf({32, 32, 0}, {false, false, false});
    FlowSettings settings = transportSettings(lattice);
    settings.dealiasing = Dealiasing::twoThirds;
    const TransportRun run(lattice, 0, std::move(settings), uniformVelocity({1, 0.5, 0}), {});
    EXPECT_FALSE(run.transport.dealiases());
}

TEST(PeriodicTransport, forwardEulerIsFirstOrder)
{
    const double DT = 0.02;
    const auto exact = [&](double x, double y, double, double t)
    { return std::exp(-8 * pi * pi * DT * t) * std::sin(2 * pi * (x - 0.3 * t)) * std::cos(2 * pi * (y - 0.2 * t)); };
    std::array<double, 2> errors{};
    for (std::size_t i = 0; i < 2; ++i)
    {
        const Lattice lattice = boxOf({16, 16, 0}, {false, false, false});
        FlowSettings settings = transportSettings(lattice);
        settings.time = timeSchemes()[Word{"firstOrderProjection", {}}];
        TransportRun run(lattice, DT, std::move(settings), uniformVelocity({0.3, 0.2, 0}), {});
        run.start(exact);
        run.march(0.5, 200 << i);
        errors[i] = run.error(exact);
    }
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 1, 0.05);
}
