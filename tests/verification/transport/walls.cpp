// Diffusion and transport between faces that prescribe values and derivatives, at the order of the continuation.

#include "support/record.hpp"
#include "support/transportRun.hpp"

#include <gtest/gtest.h>
#include <numbers>

using namespace isph;
using namespace isph::test;

namespace
{

constexpr double DT = 0.1;
constexpr double kx = 2.1;
constexpr double ky = 1.7;
constexpr double kz = 1.3;

/// A wave that decays by diffusion and drifts with U, whatever the box.
struct DriftingWave
{
    std::array<double, 3> U{0, 0, 0};
    bool three = false;

    double decay(double t) const { return std::exp(-DT * (kx * kx + ky * ky + (three ? kz * kz : 0)) * t); }
    double X(double x, double t) const { return std::sin(kx * (x - U[0] * t) + 0.4); }
    double Y(double y, double t) const { return std::sin(ky * (y - U[1] * t) + 0.7); }
    double Z(double z, double t) const { return three ? std::sin(kz * (z - U[2] * t) + 0.2) : 1; }
    double operator()(double x, double y, double z, double t) const { return decay(t) * X(x, t) * Y(y, t) * Z(z, t); }
    double dy(double x, double y, double z, double t) const
    {
        return decay(t) * X(x, t) * ky * std::cos(ky * (y - U[1] * t) + 0.7) * Z(z, t);
    }
};

/// Values at the ends of x and z, derivatives at those of y.
ScalarFaces facesOf(const DriftingWave& wave)
{
    ScalarFaces faces;
    faces[0] = {valueFace(wave), valueFace(wave)};
    faces[1] = {gradientFace([wave](double x, double y, double z, double t) { return -wave.dy(x, y, z, t); }),
                gradientFace([wave](double x, double y, double z, double t) { return wave.dy(x, y, z, t); })};
    faces[2] = {valueFace(wave), valueFace(wave)};
    return faces;
}

double errorOf(const DriftingWave& wave, const Lattice& lattice, double end)
{
    TransportRun run(lattice, DT, transportSettings(lattice), uniformVelocity(wave.U), facesOf(wave));
    run.start(wave);
    const StepRates rates = run.transport.rates(0);
    const double dt = 0.9 * largestStableStep(*run.settings.time, rates);
    run.march(end, static_cast<int>(std::ceil(end / dt)));
    return run.error(wave);
}

double order(double coarse, double fine) { return std::log2(coarse / fine); }

} // namespace

TEST(WallTransport, diffusionBetweenValuesAndDerivatives)
{
    const DriftingWave wave;
    std::array<double, 3> errors{};
    for (std::size_t i = 0; i < 3; ++i)
    {
        const int n = 16 << i;
        errors[i] = errorOf(wave, boxOf({n, n, 0}, {true, true, false}), 0.2);
        record("L2." + std::to_string(n), errors[i]);
    }
    EXPECT_GE(order(errors[0], errors[1]), 3.5);
    EXPECT_GE(order(errors[1], errors[2]), 3.5);
    EXPECT_LE(errors[2], 1e-7);
}

TEST(WallTransport, insulatedWallsKeepTheMean)
{
    const auto exact = [](double x, double y, double, double t)
    {
        const double k = std::numbers::pi;
        return 1 + std::exp(-DT * 2 * k * k * t) * std::cos(k * x) * std::cos(k * y);
    };
    const Lattice lattice = boxOf({24, 24, 0}, {true, true, false});
    ScalarFaces faces;
    for (std::size_t d = 0; d < 2; ++d) { faces[d] = {insulatedFace(), insulatedFace()}; }
    TransportRun run(lattice, DT, transportSettings(lattice), uniformVelocity({0, 0, 0}), std::move(faces));
    run.start(exact);
    run.march(2,
              static_cast<int>(std::ceil(2 / (0.9 * largestStableStep(*run.settings.time, run.transport.rates(0))))));
    record("L2", run.error(exact));
    EXPECT_LE(run.error(exact), 1e-6);
}

TEST(WallTransport, driftThroughABoxInThreeDimensions)
{
    const DriftingWave wave{{0.5, 0, -0.3}, true};
    std::array<double, 2> errors{};
    for (std::size_t i = 0; i < 2; ++i)
    {
        const int n = 12 << i;
        errors[i] = errorOf(wave, boxOf({n, n, n}, {true, true, true}), 0.1);
        record("L2." + std::to_string(n), errors[i]);
    }
    EXPECT_GE(order(errors[0], errors[1]), 3.5);
    EXPECT_LE(errors[1], 1e-5);
}

TEST(WallTransport, channelInThreeDimensions)
{
    using std::numbers::pi;
    const double k2 = 4 * pi * pi + pi * pi + 4 * pi * pi;
    const auto exact = [&](double x, double y, double z, double t)
    {
        return std::exp(-DT * k2 * t) * std::sin(2 * pi * (x - 0.7 * t)) * std::sin(pi * y) *
               std::cos(2 * pi * (z + 0.2 * t));
    };
    const Lattice lattice = boxOf({12, 24, 12}, {false, true, false});
    ScalarFaces faces;
    faces[1] = {valueFace(exact), valueFace(exact)};
    TransportRun run(lattice, DT, transportSettings(lattice), uniformVelocity({0.7, 0, -0.2}), std::move(faces));
    run.start(exact);
    run.march(0.1, 400);
    record("L2", run.error(exact));
    EXPECT_LE(run.error(exact), 1e-6);
}

// Mirrored walls are second order.
TEST(WallTransport, staggeredPoints)
{
    const DriftingWave wave;
    std::array<double, 3> errors{};
    for (std::size_t i = 0; i < 3; ++i)
    {
        const int n = 16 << i;
        errors[i] = errorOf(wave, boxOf({n, n, 0}, {true, true, false}, true), 0.2);
        record("L2." + std::to_string(n), errors[i]);
    }
    EXPECT_GE(order(errors[0], errors[1]), 1.8);
    EXPECT_GE(order(errors[1], errors[2]), 1.8);
}

TEST(WallTransport, aHotWallWarmsABoxUpToItsOwnValue)
{
    const Lattice lattice = boxOf({12, 12, 0}, {true, true, false});
    ScalarFaces faces;
    faces[0] = {valueFace([](double, double, double, double) { return 2; }), insulatedFace()};
    faces[1] = {insulatedFace(), insulatedFace()};
    TransportRun run(lattice, DT, transportSettings(lattice), uniformVelocity({0, 0, 0}), std::move(faces));
    run.start([](double, double, double, double) { return 0; });
    run.march(60,
              static_cast<int>(std::ceil(60 / (0.9 * largestStableStep(*run.settings.time, run.transport.rates(0))))));
    EXPECT_LE(run.error([](double, double, double, double) { return 2; }), 1e-5);
}

TEST(WallTransport, theStepIsStableUpToItsLimitAndNotBeyond)
{
    const auto largestAfter = [](double part)
    {
        const Lattice lattice = boxOf({20, 20, 0}, {true, true, false});
        ScalarFaces faces;
        faces[0] = {valueFace([](double, double, double, double) { return 0; }), insulatedFace()};
        faces[1] = {insulatedFace(), insulatedFace()};
        TransportRun run(lattice, DT, transportSettings(lattice), uniformVelocity({0, 0, 0}), std::move(faces));
        run.start([](double x, double y, double, double) { return std::sin(1e4 * x * (1 + y)); });
        const double dt = part * largestStableStep(*run.settings.time, run.transport.rates(0));
        run.march(3000 * dt, 3000);
        return run.transport.largest();
    };
    EXPECT_LE(largestAfter(0.98), 1);
    EXPECT_FALSE(largestAfter(1.1) <= 1e3);
}
