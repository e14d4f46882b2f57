// Few points, odd and prime counts, and fields with nothing in them: docs/theory/periodic.md, tests X4 and X5.

#include "support/flowRun.hpp"
#include "support/record.hpp"

#include <algorithm>
#include <array>
#include <vector>

using namespace isph;
using namespace isph::test;

namespace
{

bool finite(const RealField& field)
{
    for (int c = 0; c < field.components(); ++c)
    {
        if (!std::ranges::all_of(field[c], [](double value) { return std::isfinite(value); })) { return false; }
    }
    return true;
}

double largest(const RealField& field) { return largestDifference(field, RealField(field.components(), field.size())); }

/// Every way to march that differs in which modes it touches.
std::vector<std::function<FlowSettings()>> everyVariant()
{
    std::vector<std::function<FlowSettings()>> variants;
    for (const ConvectionForm form : {ConvectionForm::divergence, ConvectionForm::rotational, ConvectionForm::advective,
                                      ConvectionForm::skewSymmetric, ConvectionForm::none})
    {
        variants.push_back(
            [form]
            {
                FlowSettings settings = recommendedSettings(closedGaussian(10, 1.5));
                settings.convection = form;
                settings.exactMeanFlow = true;
                settings.filter = exponentialFilter();
                return settings;
            });
        variants.push_back(
            [form]
            {
                FlowSettings settings = plainSettings(exactKernel());
                settings.convection = form;
                return settings;
            });
        variants.push_back(
            [form]
            {
                FlowSettings settings = plainSettings(quinticSpline(1.5));
                settings.convection = form;
                settings.eigenvalues = Eigenvalues::fourthOrder;
                settings.incremental = true;
                return settings;
            });
    }
    return variants;
}

std::vector<Lattice> oddLattices()
{
    return {periodicBox({2, 2, 1}, {1, 1, 0}), periodicBox({3, 3, 1}, {1, 1, 0}), periodicBox({1, 8, 1}, {1, 1, 0}),
            periodicBox({8, 1, 1}, {1, 1, 0}), periodicBox({1, 1, 1}, {1, 1, 0}), periodicBox({2, 31, 1}, {1, 1, 0}),
            periodicBox({5, 4, 1}, {1, 2, 0}), periodicBox({2, 2, 2}, {1, 1, 1}), periodicBox({3, 2, 5}, {1, 2, 1}),
            periodicBox({7, 1, 6}, {1, 1, 1}), periodicBox({1, 7, 6}, {1, 1, 1}), periodicBox({6, 7, 1}, {1, 1, 1}),
            periodicBox({1, 1, 1}, {1, 1, 1})};
}

std::string nameOf(const Lattice& lattice)
{
    return std::to_string(lattice.axis(0).count) + "x" + std::to_string(lattice.axis(1).count) + "x" +
           std::to_string(lattice.axis(2).count);
}

/// Error of the moving vortex at t = 0.2 on nx x ny points, after 100 steps.
double movingVortexError(int nx, int ny, FlowSettings settings)
{
    const TaylorGreen exact{.nu = 0.01, .U0 = 1, .V0 = 0.5};
    FlowRun run(periodicBox({nx, ny, 1}, {1, 1, 0}), Fluid{.nu = exact.nu}, std::move(settings));
    run.start([&](int c, double x, double y, double) { return exact.velocity(c, x, y, 0); });
    run.march(0.2, 100);
    EXPECT_LE(divergenceNorms(run.flow).Linf, 1e-12);
    return relativeL2(
        run.flow.velocity(),
        fieldOf(run.lattice, 2, [&](int c, double x, double y, double) { return exact.velocity(c, x, y, 0.2); }));
}

} // namespace

TEST(Extremes, X4_oddPrimeAndUnequalCountsAreAsGoodAsTheirNeighbours)
{
    Bounds bounds;
    const auto kernel = [] { return plainSettings(closedGaussian(4, 1.5)); };
    // The error is proportional to N^-4, whatever N is.
    const double at32 = movingVortexError(32, 32, kernel());
    for (const int n : {15, 16, 17, 21, 30, 31, 33, 49, 96, 97, 100})
    {
        const double error = movingVortexError(n, n, kernel());
        EXPECT_TRUE(bounds.near(error * std::pow(n / 32.0, 4) / at32, 1, n < 20 ? 0.15 : 0.05)) << n;
        record(std::string("N") + std::to_string(n), error);
    }
    // With nx != ny it lies between those of the two.
    for (const auto& [nx, ny] : {std::pair{31, 64}, {97, 32}, {24, 37}})
    {
        const double error = movingVortexError(nx, ny, kernel());
        const double x = movingVortexError(nx, nx, kernel());
        const double y = movingVortexError(ny, ny, kernel());
        EXPECT_TRUE(bounds.atMost(error, 1.01 * std::max(x, y)));
        EXPECT_TRUE(bounds.atLeast(error, 0.99 * std::min(x, y)));
        // Turned by a right angle it is the same flow but for the direction of the mean.
        EXPECT_TRUE(bounds.near(movingVortexError(nx, ny, recommendedSettings(exactKernel())) /
                                    movingVortexError(32, 32, recommendedSettings(exactKernel())),
                                1, 0.01));
    }
    // Four points resolve the vortex, not its convection.
    EXPECT_TRUE(std::isfinite(movingVortexError(4, 4, kernel())));
}

TEST(Extremes, X4_fewPointsStayFinite)
{
    Bounds bounds;
    for (const Lattice& lattice : oddLattices())
    {
        for (const auto& variant : everyVariant())
        {
            FlowRun run(lattice, Fluid{.nu = 0.01}, variant());
            const RealField start = noise(lattice, lattice.dimensions(), 1);
            run.flow.start(start, true);
            const double before = norm(run.flow.velocity());
            run.march(0.01, 20);
            EXPECT_TRUE(finite(run.flow.velocity())) << nameOf(lattice);
            EXPECT_TRUE(bounds.atMost(norm(run.flow.velocity()), 1.05 * before + 1e-15)) << nameOf(lattice);
            EXPECT_TRUE(finite(run.flow.pressure(run.t))) << nameOf(lattice);
            EXPECT_TRUE(std::isfinite(run.flow.rates().courant)) << nameOf(lattice);
            EXPECT_GE(largestStableStep(*run.settings.time, run.flow.rates()), 0) << nameOf(lattice);
            const FlowStatistics statistics = run.statistics();
            EXPECT_TRUE(std::isfinite(statistics.enstrophy + statistics.palinstrophy + statistics.divLinf));
        }
    }
}

TEST(Extremes, X4_anAxisWithOnePointCarriesItsComponentAlong)
{
    Bounds bounds;
    // 24 x 1 x 24: u and w are the flow of 24 x 24, v is a scalar that they carry.
    const auto velocity = [](int c, double x, double z)
    {
        return c == 0   ? std::sin(2 * pi * z) + 0.5 * std::cos(2 * pi * (x + z))
               : c == 1 ? std::cos(2 * pi * x)
                        : std::sin(2 * pi * x) - 0.5 * std::cos(2 * pi * (x + z));
    };
    for (const auto& variant : everyVariant())
    {
        FlowSettings settings = variant();
        FlowSettings same = variant();
        // Samples of a kernel wrap along the thin axis: other operators. And v grad v, which the rotational form holds,
        // is a gradient for exact derivatives without aliasing only.
        if (settings.kernel.symbol == KernelSettings::Symbol::sampled) { continue; }
        if (settings.convection == ConvectionForm::rotational)
        {
            settings.kernel = exactKernel();
            settings.dealiasing = Dealiasing::twoThirds;
            same.kernel = exactKernel();
            same.dealiasing = Dealiasing::twoThirds;
        }
        FlowRun thin(periodicBox({24, 1, 24}, {1, 1, 1}), Fluid{.nu = 0.01}, std::move(settings));
        FlowRun plane(periodicBox({24, 1, 24}, {1, 0, 1}), Fluid{.nu = 0.01}, std::move(same));
        thin.start([&](int c, double x, double, double z) { return velocity(c, x, z); });
        plane.start([&](int c, double x, double, double z) { return velocity(2 * c, x, z); });
        thin.march(0.2, 20);
        plane.march(0.2, 20);
        RealField inPlane(2, plane.lattice.points());
        for (int c = 0; c < 2; ++c) { std::ranges::copy(thin.flow.velocity()[2 * c], inPlane[c].begin()); }
        EXPECT_TRUE(bounds.atMost(largestDifference(inPlane, plane.flow.velocity()), 1e-14))
            << convectionForms().nameOf(thin.settings.convection);
        EXPECT_TRUE(bounds.atMost(
            norm(thin.flow.velocity()),
            norm(fieldOf(thin.lattice, 3, [&](int c, double x, double, double z) { return velocity(c, x, z); }))));
    }
}

TEST(Extremes, X5_zeroStaysExactlyZero)
{
    for (const Lattice& lattice : {unitSquare(16), periodicBox({9, 8, 10}, {1, 2, 3})})
    {
        for (const auto& variant : everyVariant())
        {
            FlowRun run(lattice, Fluid{.nu = 0.01}, variant());
            const StartReport report = run.start([](int, double, double, double) { return 0.0; });
            EXPECT_EQ(report.projected + report.dealiased + report.nyquist, 0);
            run.march(1, 10);
            EXPECT_EQ(largest(run.flow.velocity()), 0);
            EXPECT_EQ(largest(run.flow.pressure(1)), 0);
            EXPECT_EQ(run.flow.rates().courant, 0);
        }
    }
}

TEST(Extremes, X5_constantStaysConstant)
{
    Bounds bounds;
    for (const Lattice& lattice : {unitSquare(16), unitSquare(15), periodicBox({9, 8, 10}, {1, 2, 3})})
    {
        const std::array<double, 3> constant{1, -0.3, 0.7};
        for (const auto& variant : everyVariant())
        {
            FlowRun run(lattice, Fluid{.nu = 0.01}, variant());
            const auto velocity = [&](int c, double, double, double) { return constant[static_cast<std::size_t>(c)]; };
            run.start(velocity);
            run.march(0.1, 10);
            EXPECT_TRUE(bounds.atMost(
                largestDifference(run.flow.velocity(), fieldOf(lattice, lattice.dimensions(), velocity)), 1e-14));
            EXPECT_TRUE(bounds.atMost(largest(run.flow.pressure(0.1)), 1e-14));
            EXPECT_TRUE(bounds.atMost(divergenceNorms(run.flow).Linf, 1e-13));
        }
    }
}

TEST(Extremes, X5_checkerboardsAreRemovedAndReported)
{
    Bounds bounds;
    // (-1)^(i+j), (-1)^i, (-1)^j: no derivative of the scheme sees them.
    for (const std::array<int, 2>& waves : {std::array{8, 8}, std::array{8, 0}, std::array{0, 8}})
    {
        for (const auto& variant : everyVariant())
        {
            FlowSettings settings = variant();
            settings.dealiasing = Dealiasing::none;
            FlowRun run(unitSquare(16), Fluid{.nu = 0.01}, std::move(settings));
            const StartReport report = run.start([&](int, double x, double y, double)
                                                 { return std::cos(2 * pi * (waves[0] * x + waves[1] * y)); });
            EXPECT_TRUE(bounds.near(report.nyquist, 1, 1e-14));
            EXPECT_TRUE(bounds.near(report.projected, 0, 1e-14));
            run.march(0.1, 10);
            EXPECT_TRUE(bounds.atMost(largest(run.flow.velocity()), 1e-15));
        }
    }
    // With dealiasing they are among the modes that are dropped anyhow.
    FlowRun dealiased(unitSquare(16), Fluid{.nu = 0.01}, recommendedSettings(exactKernel()));
    const StartReport report =
        dealiased.start([](int, double x, double y, double) { return std::cos(16 * pi * (x + y)); });
    EXPECT_TRUE(bounds.near(report.dealiased, 1, 1e-14));
    EXPECT_EQ(largest(dealiased.flow.velocity()), 0);
}

TEST(Extremes, X5_aWaveAtNyquistOfOneAxisIsMarched)
{
    Bounds bounds;
    // (-1)^i cos(2 pi y): its y derivative is seen, its x derivative is not; u alone is free of divergence.
    for (const auto& variant : everyVariant())
    {
        FlowSettings settings = variant();
        settings.dealiasing = Dealiasing::none;
        settings.filter = {};
        FlowRun run(unitSquare(16), Fluid{.nu = 0.01}, std::move(settings));
        const StartReport report = run.start([](int c, double x, double y, double)
                                             { return c == 0 ? std::cos(16 * pi * x) * std::cos(2 * pi * y) : 0.0; });
        EXPECT_TRUE(bounds.near(report.nyquist, 0, 1e-14));
        EXPECT_TRUE(bounds.near(report.projected, 0, 1e-14));
        const double before = norm(run.flow.velocity());
        run.march(0.01, 10);
        EXPECT_TRUE(finite(run.flow.velocity()));
        EXPECT_TRUE(bounds.atMost(norm(run.flow.velocity()), before * (1 + 1e-6)));
        EXPECT_TRUE(bounds.atMost(divergenceNorms(run.flow).Linf,
                                  run.settings.eigenvalues == Eigenvalues::consistent ? 1e-13 : 1));
    }
}
