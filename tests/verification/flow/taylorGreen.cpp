// Taylor-Green vortices against their exact solution: the figures of docs/theory/periodic.md, section 6.

#include "support/flows.hpp"
#include "support/periodicBox.hpp"
#include "support/record.hpp"

#include <array>
#include <gtest/gtest.h>

using namespace isph;
using namespace isph::test;

namespace
{

/// Relative L2 errors at the end of a run.
struct Errors
{
    double velocity; ///< relative to the whole velocity
    double vortex;   ///< relative to the velocity without its mean
    double pressure;
};

Errors errorsOf(const TaylorGreen& exact, const FlowSettings& settings, int n, double end, int steps)
{
    const Lattice lattice = unitSquare(n);
    const Fluid fluid{.nu = exact.nu};
    Timings timings;
    SpectralFlow flow(lattice, fluid, settings, timings, PlanEffort::estimated);
    flow.start(fieldOf(lattice, 2, [&](int c, double x, double y, double) { return exact.velocity(c, x, y, 0); }),
               true);
    march(flow, *settings.time, end, steps);
    const RealField velocity =
        fieldOf(lattice, 2, [&](int c, double x, double y, double) { return exact.velocity(c, x, y, end); });
    const double ofVelocity = relativeL2(flow.velocity(), velocity);
    const double vortexNorm = norm(fieldOf(lattice, 2,
                                           [&](int c, double x, double y, double)
                                           { return exact.velocity(c, x, y, end) - (c == 0 ? exact.U0 : exact.V0); }));
    const RealField pressure =
        fieldOf(lattice, 1, [&](int, double x, double y, double) { return exact.pressure(x, y, end); });
    return {ofVelocity, ofVelocity * norm(velocity) / vortexNorm, relativeL2(flow.pressure(end), pressure)};
}

double explicitError(KernelSettings kernel, int n, const char* time = "RK3")
{
    return errorsOf({}, plainSettings(std::move(kernel), time), n, 1, 10 * n).velocity;
}

} // namespace

TEST(TaylorGreen, closedGaussianOrder4)
{
    for (const auto& [n, expected] : {std::pair{20, 4.66e-3}, {40, 3.13e-4}, {80, 1.99e-5}, {160, 1.25e-6}})
    {
        const double error = explicitError(closedGaussian(4, 2), n);
        EXPECT_NEAR(error / expected, 1, 0.01) << "N = " << n;
        record("error" + std::to_string(n), error);
    }
}

TEST(TaylorGreen, closedGaussianOrder6)
{
    for (const auto& [n, expected] : {std::pair{20, 2.25e-4}, {40, 3.84e-6}, {80, 6.13e-8}, {160, 9.60e-10}})
    {
        const double error = explicitError(closedGaussian(6, 2), n);
        EXPECT_NEAR(error / expected, 1, 0.01) << "N = " << n;
        record("error" + std::to_string(n), error);
    }
}

TEST(TaylorGreen, everyKernelOfTheTable)
{
    Bounds bounds;
    struct Row
    {
        const char* name;
        std::function<KernelSettings()> kernel;
        std::array<double, 3> expected; ///< at N = 20, 40, 80
        double tolerance = 0.02;        ///< the digits printed; 0.08: the table has one row for several kernels
    };
    const std::array<Row, 9> table{
        {{"G4 1.3", [] { return closedGaussian(4, 1.3); }, {8.78e-4, 5.66e-5, 3.57e-6}},
         {"G6 1.3", [] { return closedGaussian(6, 1.3); }, {1.82e-5, 2.94e-7, 4.61e-9}},
         {"G8 2", [] { return closedGaussian(8, 2); }, {8.76e-6, 3.75e-8, 1.2e-10}, 0.05},
         {"G10 2", [] { return closedGaussian(10, 2); }, {2.84e-7, 5.6e-11, 3.1e-11}, 0.15},
         {"G10 1.3", [] { return closedGaussian(10, 1.3); }, {2.0e-9, 2.5e-10, 3.2e-11}, 0.08},
         {"G20 2", [] { return closedGaussian(20, 2); }, {2.0e-9, 2.5e-10, 3.2e-11}, 0.03},
         {"G4 4h 2", [] { return sampledGaussian(4, 2, 4); }, {4.7e-3, 2.9e-4, 7.7e-6}},
         {"G4 4h 1.3", [] { return sampledGaussian(4, 1.3, 4); }, {9.2e-4, 9.4e-5, 3.9e-5}},
         {"quintic 1.3", [] { return quinticSpline(1.3); }, {3.1e-2, 7.5e-3, 1.5e-3}, 0.035}}};
    for (const Row& row : table)
    {
        for (std::size_t i = 0; i < row.expected.size(); ++i)
        {
            const double error = explicitError(row.kernel(), 20 << i);
            EXPECT_TRUE(bounds.near(error / row.expected[i], 1, row.tolerance)) << row.name << " N = " << (20 << i);
        }
    }
}

TEST(TaylorGreen, quinticSplineIsSecondOrder)
{
    for (const auto& [n, expected] : {std::pair{20, 7.4e-2}, {40, 1.9e-2}, {80, 4.7e-3}})
    {
        EXPECT_NEAR(explicitError(quinticSpline(2), n) / expected, 1, 0.02) << "N = " << n;
    }
}

TEST(TaylorGreen, firstOrderProjectionIsFirstOrder)
{
    const std::array<double, 4> smooth{1.56e-3, 7.8e-4, 3.9e-4, 1.95e-4};
    const std::array<double, 3> order4{3.1e-3, 4.7e-4, 3.7e-4}; // errors in space and time of opposite signs
    for (std::size_t i = 0; i < order4.size(); ++i)
    {
        EXPECT_NEAR(explicitError(closedGaussian(8, 1.3), 20 << i, "firstOrderProjection") / smooth[i], 1, 0.01);
        EXPECT_NEAR(explicitError(closedGaussian(4, 2), 20 << i, "firstOrderProjection") / order4[i], 1, 0.02);
    }
}

TEST(TaylorGreen, theConfigurationOfThePaper)
{
    const auto error = [](KernelSettings kernel, int n, const char* time)
    {
        FlowSettings settings = plainSettings(std::move(kernel), time);
        settings.convection = ConvectionForm::advective;
        settings.eigenvalues = Eigenvalues::exact;
        return errorsOf({}, settings, n, 1, 10 * n).velocity;
    };
    const std::array<double, 3> euler{3.5e-3, 7.2e-4, 4.0e-4};
    const std::array<double, 3> rungeKutta{3.4e-3, 2.5e-4, 9.0e-6};
    const std::array<double, 3> spline{6.4e-2, 1.8e-2, 4.6e-3};
    for (std::size_t i = 0; i < euler.size(); ++i)
    {
        const int n = 20 << i;
        EXPECT_NEAR(error(sampledGaussian(4, 2, 4), n, "firstOrderProjection") / euler[i], 1, 0.03) << n;
        EXPECT_NEAR(error(sampledGaussian(4, 2, 4), n, "RK3") / rungeKutta[i], 1, 0.03) << n;
        EXPECT_NEAR(error(quinticSpline(2), n, "RK3") / spline[i], 1, 0.03) << n;
    }
}

TEST(TaylorGreen, integratingFactorWithExactLaplacianLeavesRoundOff)
{
    Bounds bounds;
    for (const int n : {20, 40, 80, 160})
    {
        FlowSettings settings = plainSettings(closedGaussian(4, 2));
        settings.integratingFactor = true;
        settings.laplacian = LaplacianForm::exact;
        EXPECT_TRUE(bounds.atMost(errorsOf({}, settings, n, 1, 10 * n).velocity, 1e-13)) << "N = " << n;
    }
}

TEST(TaylorGreen, stiffStepsAreExact)
{
    Bounds bounds;
    // nu dt/dx^2 = 410 at N = 64 (theory: test T3).
    FlowSettings settings = plainSettings(exactKernel());
    settings.integratingFactor = true;
    settings.laplacian = LaplacianForm::exact;
    EXPECT_TRUE(bounds.atMost(errorsOf({.nu = 1}, settings, 64, 0.1, 1).velocity, 1e-13));
}

TEST(MovingTaylorGreen, velocityAndPressureAreThirdOrderInTime)
{
    const TaylorGreen exact{.nu = 0.01, .U0 = 1, .V0 = 0.5};
    Errors before{};
    for (const int steps : {50, 100, 200, 400})
    {
        const Errors now = errorsOf(exact, plainSettings(exactKernel()), 32, 0.5, steps);
        if (steps > 50)
        {
            EXPECT_NEAR(std::log2(before.velocity / now.velocity), 3, 0.05) << steps;
            EXPECT_GE(std::log2(before.pressure / now.pressure), 2.9) << steps;
        }
        before = now;
    }
    EXPECT_NEAR(before.velocity / 9.0e-8, 1, 0.02);
    EXPECT_NEAR(before.pressure / 3.3e-7, 1, 0.02);
}

TEST(MovingTaylorGreen, errorsOfTheTable)
{
    const TaylorGreen exact{.nu = 0.01, .U0 = 1, .V0 = 0.5};
    struct Row
    {
        int order; ///< 0: exact
        double smoothingLength;
        std::array<double, 3> expected; ///< at N = 20, 40, 80
    };
    for (const Row& row : {Row{4, 2, {3.3e-2, 2.3e-3, 1.5e-4}}, Row{6, 2, {2.2e-3, 3.8e-5, 6.1e-7}},
                           Row{10, 2, {4.5e-6, 1.3e-7, 1.6e-8}}, Row{10, 1.3, {1.0e-6, 1.27e-7, 1.59e-8}},
                           Row{0, 1, {1.0e-6, 1.27e-7, 1.59e-8}}})
    {
        for (std::size_t i = 0; i < row.expected.size(); ++i)
        {
            const int n = 20 << i; // a Courant number of 0.1 at the largest speed, 2
            KernelSettings kernel = row.order == 0 ? exactKernel() : closedGaussian(row.order, row.smoothingLength);
            const double error = errorsOf(exact, plainSettings(std::move(kernel)), n, 1, 20 * n).velocity;
            EXPECT_NEAR(error / row.expected[i], 1, 0.04) << row.order << " " << row.smoothingLength << " N = " << n;
        }
    }
}

TEST(MovingTaylorGreen, aLargeMeanFlowIsCarriedExactly)
{
    Bounds bounds;
    FlowSettings settings = plainSettings(exactKernel());
    settings.integratingFactor = true;
    settings.laplacian = LaplacianForm::exact;
    settings.exactMeanFlow = true;
    // Mean Courant number 48 and 96 (theory: test T6).
    for (const int steps : {200, 100})
    {
        EXPECT_TRUE(bounds.atMost(errorsOf({.nu = 0.01, .U0 = 100, .V0 = 50}, settings, 64, 1, steps).vortex, 1e-12));
    }
}

TEST(MovingTaylorGreen, everyConvectionFormCarriesTheVortex)
{
    const TaylorGreen exact{.nu = 0.01, .U0 = 1, .V0 = 0.5};
    for (const ConvectionForm form : {ConvectionForm::divergence, ConvectionForm::rotational, ConvectionForm::advective,
                                      ConvectionForm::skewSymmetric})
    {
        FlowSettings settings = plainSettings(exactKernel());
        settings.convection = form;
        EXPECT_LE(errorsOf(exact, settings, 32, 0.5, 400).velocity, 1e-7) << convectionForms().nameOf(form);
    }
}
