// Taylor-Green vortices against their exact solution: the figures of docs/theory/periodic.md, section 6.

#include "support/flows.hpp"
#include "support/periodicBox.hpp"

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
        EXPECT_NEAR(explicitError(closedGaussian(4, 2), n) / expected, 1, 0.01) << "N = " << n;
    }
}

TEST(TaylorGreen, closedGaussianOrder6)
{
    for (const auto& [n, expected] : {std::pair{20, 2.25e-4}, {40, 3.84e-6}, {80, 6.13e-8}, {160, 9.60e-10}})
    {
        EXPECT_NEAR(explicitError(closedGaussian(6, 2), n) / expected, 1, 0.01) << "N = " << n;
    }
}

TEST(TaylorGreen, narrowKernels)
{
    EXPECT_NEAR(explicitError(closedGaussian(4, 1.3), 40) / 5.66e-5, 1, 0.01);
    EXPECT_NEAR(explicitError(closedGaussian(8, 2), 20) / 8.76e-6, 1, 0.01);
    EXPECT_NEAR(explicitError(closedGaussian(20, 2), 40) / 2.5e-10, 1, 0.03); // the time error of RK3 alone
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
    EXPECT_NEAR(explicitError(closedGaussian(8, 1.3), 20, "firstOrderProjection") / 1.56e-3, 1, 0.01);
    EXPECT_NEAR(explicitError(closedGaussian(8, 1.3), 40, "firstOrderProjection") / 7.8e-4, 1, 0.01);
}

TEST(TaylorGreen, integratingFactorWithExactLaplacianLeavesRoundOff)
{
    for (const int n : {20, 40, 80, 160})
    {
        FlowSettings settings = plainSettings(closedGaussian(4, 2));
        settings.integratingFactor = true;
        settings.laplacian = LaplacianForm::exact;
        EXPECT_LE(errorsOf({}, settings, n, 1, 10 * n).velocity, 1e-13) << "N = " << n;
    }
}

TEST(TaylorGreen, stiffStepsAreExact)
{
    // nu dt/dx^2 = 410 at N = 64 (theory: test T3).
    FlowSettings settings = plainSettings(exactKernel());
    settings.integratingFactor = true;
    settings.laplacian = LaplacianForm::exact;
    EXPECT_LE(errorsOf({.nu = 1}, settings, 64, 0.1, 1).velocity, 1e-13);
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

TEST(MovingTaylorGreen, spatialErrorsAtSmallSteps)
{
    const TaylorGreen exact{.nu = 0.01, .U0 = 1, .V0 = 0.5};
    EXPECT_NEAR(errorsOf(exact, plainSettings(closedGaussian(4, 2)), 40, 1, 800).velocity / 2.3e-3, 1, 0.03);
    EXPECT_NEAR(errorsOf(exact, plainSettings(closedGaussian(6, 2)), 40, 1, 800).velocity / 3.8e-5, 1, 0.03);
}

TEST(MovingTaylorGreen, aLargeMeanFlowIsCarriedExactly)
{
    FlowSettings settings = plainSettings(exactKernel());
    settings.integratingFactor = true;
    settings.laplacian = LaplacianForm::exact;
    settings.exactMeanFlow = true;
    // Mean Courant number 48 and 96 (theory: test T6).
    for (const int steps : {200, 100})
    {
        EXPECT_LE(errorsOf({.nu = 0.01, .U0 = 100, .V0 = 50}, settings, 64, 1, steps).vortex, 1e-12);
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
