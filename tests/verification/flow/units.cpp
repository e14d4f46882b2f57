// Nothing depends on units or on the shape of the box: docs/theory/periodic.md, tests X1 and X2.

#include "support/flowRun.hpp"
#include "support/record.hpp"

#include <array>
#include <vector>

using namespace isph;
using namespace isph::test;

namespace
{

/// Velocity over U and pressure over U^2 of a flow in a box of side L.
struct Scaled
{
    RealField velocity;
    RealField pressure;
    StartReport start;
};

/// Two vortices that are no exact solution, Re 100, carried by a mean flow; 40 steps at a Courant number of 0.2.
Scaled scaledFlow(double L, double U, FlowSettings settings)
{
    FlowRun run(periodicBox({32, 24, 1}, {L, L, 0}), Fluid{.nu = U * L / 100}, std::move(settings));
    Scaled result;
    result.start = run.start(
        [&](int c, double x, double y, double)
        {
            const double a = 2 * pi * (x / L);
            const double b = 2 * pi * (y / L);
            return U * (c == 0 ? 0.5 + std::sin(b) + 0.3 * std::cos(2 * a + b)
                               : 0.25 + std::sin(a) - 0.6 * std::cos(2 * a + b));
        });
    const double dt = 0.2 * (L / U) / 32;
    run.march(40 * dt, 40);
    result.velocity = copyOf(run.flow.velocity());
    result.pressure = copyOf(run.flow.pressure(run.t));
    for (int c = 0; c < 2; ++c)
    {
        for (double& u : result.velocity[c]) { u /= U; }
    }
    for (double& p : result.pressure[0]) { p = p / U / U; }
    return result;
}

} // namespace

TEST(Units, X1_sameFlowInAnyUnits)
{
    const std::vector<std::pair<const char*, std::function<FlowSettings()>>> variants{
        {"recommended",
         []
         {
             FlowSettings settings = recommendedSettings(closedGaussian(10, 1.5));
             settings.exactMeanFlow = true;
             settings.filter = exponentialFilter();
             return settings;
         }},
        {"explicit", [] { return plainSettings(closedGaussian(4, 2)); }},
        {"paper",
         []
         {
             FlowSettings settings = plainSettings(sampledGaussian(4, 2, 4));
             settings.convection = ConvectionForm::advective;
             settings.eigenvalues = Eigenvalues::exact;
             settings.incremental = true;
             return settings;
         }},
        {"rotational",
         []
         {
             FlowSettings settings = recommendedSettings(quinticSpline(1.5));
             settings.convection = ConvectionForm::rotational;
             settings.eigenvalues = Eigenvalues::fourthOrder;
             return settings;
         }},
        {"skew", []
         {
             FlowSettings settings = plainSettings(exactKernel());
             settings.convection = ConvectionForm::skewSymmetric;
             settings.eigenvalues = Eigenvalues::morris;
             return settings;
         }}};
    double worstVelocity = 0;
    double worstPressure = 0;
    for (const auto& [name, settings] : variants)
    {
        const Scaled reference = scaledFlow(1, 1, settings());
        for (const auto& [L, U] :
             {std::pair{1e-6, 1e3}, {1e6, 1e-3}, {1e-150, 1e-150}, {1e-9, 1e9}, {1e100, 1e100}, {3.7, 0.11}})
        {
            const Scaled scaled = scaledFlow(L, U, settings());
            const double velocity = relativeL2(scaled.velocity, reference.velocity);
            const double pressure = relativeL2(scaled.pressure, reference.pressure);
            EXPECT_LE(velocity, 2e-14) << name << " " << L << " " << U;
            EXPECT_LE(pressure, 5e-14) << name << " " << L << " " << U;
            worstVelocity = std::max(worstVelocity, velocity);
            worstPressure = std::max(worstPressure, pressure);
            EXPECT_NEAR(scaled.start.projected, reference.start.projected, 1e-13);
        }
    }
    record("velocity", worstVelocity);
    record("pressure", worstPressure);
}

TEST(Units, X2_stretchedLatticesDecayAsTheirSymbol)
{
    // psi = cos(kx x) cos(ky y) decays under viscosity alone: its convective term is a gradient. Slowly, or the shear,
    // which is unstable to waves along x, would lift round-off into sight.
    const double nu = 1e-3;
    const double end = 5;
    const std::array<double, 2> extent{1000, 1};
    const std::array<double, 2> k{2 * pi / extent[0], 2 * pi / extent[1]};
    for (const auto& [nx, ny, printed] : {std::tuple{32, 32, 6.06e-5}, {64, 16, 2.67e-4}, {1024, 8, 3.35e-3}})
    {
        for (const int order : {4, 10})
        {
            for (const bool turned : {false, true})
            {
                FlowSettings settings = recommendedSettings(closedGaussian(order, 1.5));
                const Lattice lattice = turned ? periodicBox({ny, nx, 1}, {extent[1], extent[0], 0})
                                               : periodicBox({nx, ny, 1}, {extent[0], extent[1], 0});
                FlowRun run(lattice, Fluid{.nu = nu}, std::move(settings));
                const auto velocity = [&](int c, double x, double y, double)
                {
                    const double a = k[0] * (turned ? y : x);
                    const double b = k[1] * (turned ? x : y);
                    const bool along = turned ? c == 1 : c == 0;
                    return along ? -std::cos(a) * std::sin(b) : k[0] / k[1] * std::sin(a) * std::cos(b);
                };
                run.start(velocity);
                run.march(end, 50);

                const double s = 0.25 * 1.5 * 1.5 * (std::pow(2 * pi / nx, 2) + std::pow(2 * pi / ny, 2));
                const double k2 = k[0] * k[0] + k[1] * k[1];
                const double predicted = std::expm1(nu * k2 * end * (1 - Gaussian(order).morrisSymbol(s)));
                const double decay = std::exp(-nu * k2 * end);
                RealField exact = fieldOf(lattice, 2, velocity);
                for (int c = 0; c < 2; ++c)
                {
                    for (double& u : exact[c]) { u *= decay; }
                }
                const double error = relativeL2(run.flow.velocity(), exact);
                EXPECT_NEAR(error, predicted, 1e-11);
                if (order == 4) { EXPECT_NEAR(error / printed, 1, 0.005); }
                record(std::string("G") + std::to_string(order) + "_" + std::to_string(nx) + "x" + std::to_string(ny),
                       error);
            }
        }
    }
}
