// The classical iterative pressure against the solver by transforms in marching flows: the same discrete operator, so
// the same velocities, to what the tolerance of the iteration leaves (docs/theory/iterativePressure.md).

#include "fields/reductions.hpp"
#include "flow/PhysicalFlow.hpp"
#include "support/boundedRun.hpp"
#include "support/flowRun.hpp"

#include "continuation/Mirror.hpp"

#include <gtest/gtest.h>
#include <tuple>

using namespace isph;
using namespace isph::test;

namespace
{

constexpr double tolerance = 1e-10; ///< of the iterations, by default

/// The kernels of Fourtakas et al. 2021.
KernelSettings paperKernel(bool gaussian) { return gaussian ? sampledGaussian(4, 2, 4) : quinticSpline(2); }

/// Waves of several lengths and directions, free of divergence.
double manyWaves(int component, double x, double y, double)
{
    double u = 0;
    double v = 0;
    for (int k = 1; k <= 3; ++k)
    {
        for (int l = -2; l <= 2; ++l)
        {
            const double amplitude = 1.0 / (k * k + l * l);
            const double phase = 2 * pi * (k * x + l * y) + 1.7 * k + 0.6 * l * l;
            u += amplitude * l * std::cos(phase);
            v -= amplitude * k * std::cos(phase);
        }
    }
    return component == 0 ? u : v;
}

FlowSettings settingsOf(bool gaussian, const char* time, std::optional<PressureSolver> solver)
{
    FlowSettings settings = plainSettings(paperKernel(gaussian), time);
    settings.convection = ConvectionForm::advective;
    settings.eigenvalues = Eigenvalues::morris;
    if (solver) { settings.iteration = {.solver = *solver}; }
    return settings;
}

class IteratedFlow : public testing::TestWithParam<std::tuple<bool, const char*>>
{
};

std::string nameOf(const testing::TestParamInfo<std::tuple<bool, const char*>>& info)
{
    const auto& [gaussian, time] = info.param;
    return std::string(gaussian ? "gaussian4_" : "quinticSpline_") + time;
}

INSTANTIATE_TEST_SUITE_P(With, IteratedFlow,
                         testing::Combine(testing::Bool(), testing::Values("RK3", "firstOrderProjection")), nameOf);

template<class Flow>
void expectTheSameVelocities(const std::tuple<bool, const char*>& parameters,
                             const std::function<double(int, double, double, double)>& velocity, PressureSolver solver)
{
    const auto& [gaussian, time] = parameters;
    const auto make = [&, gaussian = gaussian, time = time](std::optional<PressureSolver> by)
    {
        FlowSettings settings = settingsOf(gaussian, time, by);
        settings.directSum = std::is_same_v<Flow, PhysicalFlow>;
        return std::make_unique<RunOf<Flow>>(unitSquare(40), Fluid{.nu = 0.01}, std::move(settings));
    };
    const auto transformed = make(std::nullopt);
    const auto iterated = make(solver);
    transformed->start(velocity);
    iterated->start(velocity);
    // Courant number 0.1.
    for (int n = 0; n < 4; ++n)
    {
        transformed->step(0.0025);
        iterated->step(0.0025);
    }
    EXPECT_LE(relativeL2(iterated->flow.velocity(), transformed->flow.velocity()), tolerance);
    const PressureRecord* record = iterated->flow.pressureRecord();
    ASSERT_NE(record, nullptr);
    EXPECT_EQ(record->solves, 4 * static_cast<long>(iterated->settings.time->substeps.size()));
    EXPECT_EQ(record->unconverged, 0);
    EXPECT_LE(record->largestResidual, tolerance);
    EXPECT_GT(record->iterations, 0);
    EXPECT_EQ(transformed->flow.pressureRecord(), nullptr);
}

double taylorGreen(int component, double x, double y, double) { return TaylorGreen().velocity(component, x, y, 0); }

} // namespace

TEST_P(IteratedFlow, goesAsByTransformsWithManyWaves)
{
    expectTheSameVelocities<SpectralFlow>(GetParam(), manyWaves, PressureSolver::biCGStab);
    expectTheSameVelocities<SpectralFlow>(GetParam(), manyWaves, PressureSolver::cg);
}

TEST_P(IteratedFlow, goesAsByTransformsAtThePoints)
{
    expectTheSameVelocities<PhysicalFlow>(GetParam(), manyWaves, PressureSolver::biCGStab);
}

TEST_P(IteratedFlow, goesAsByTransformsInTheTaylorGreenVortex)
{
    expectTheSameVelocities<SpectralFlow>(GetParam(), taylorGreen, PressureSolver::biCGStab);
    expectTheSameVelocities<PhysicalFlow>(GetParam(), taylorGreen, PressureSolver::cg);
}

TEST(IteratedFlow, theFirstSourceOfTheTaylorGreenVortexIsAnEigenvector)
{
    // cos 4 pi x + cos 4 pi y: one iteration, whatever the number of points. Other flows need tens.
    const auto iterations = [](auto velocity)
    {
        FlowRun run(unitSquare(40), Fluid{.nu = 0.01},
                    settingsOf(true, "firstOrderProjection", PressureSolver::biCGStab));
        run.start(velocity);
        run.step(0.0025);
        return run.flow.pressureRecord()->iterations;
    };
    EXPECT_EQ(iterations(taylorGreen), 1);
    EXPECT_GE(iterations(manyWaves), 10);
}

TEST(IteratedFlow, dealiasesAndKnowsTheOldPressureAsByTransforms)
{
    for (const bool incremental : {false, true})
    {
        const auto end = [incremental](std::optional<PressureSolver> solver)
        {
            FlowSettings settings = recommendedSettings(paperKernel(true));
            settings.eigenvalues = Eigenvalues::morris;
            settings.incremental = incremental;
            settings.exactMeanFlow = true;
            settings.filter = exponentialFilter();
            settings.convection = ConvectionForm::rotational;
            if (solver) { settings.iteration = {.solver = *solver}; }
            FlowRun run(periodicBox({24, 30, 1}, {1, 1, 0}), Fluid{.nu = 0.001}, std::move(settings));
            run.start([](int c, double x, double y, double z) { return 1 - 2 * c + manyWaves(c, x, y, z); });
            run.march(0.02, 8);
            return copyOf(run.flow.velocity());
        };
        EXPECT_LE(relativeL2(end(PressureSolver::biCGStab), end(std::nullopt)), tolerance) << incremental;
    }
}

TEST(IteratedFlow, goesAsByTransformsInThreeDimensions)
{
    const auto end = [](std::optional<PressureSolver> solver)
    {
        FlowSettings settings = settingsOf(false, "RK3", solver);
        settings.kernel.smoothingLength = 1.3;
        FlowRun run(unitCube(12), Fluid{.nu = 0.01}, std::move(settings));
        run.start([](int c, double x, double y, double z)
                  { return c == 2 ? std::sin(2 * pi * x) : manyWaves(c, x, y, z) * std::cos(2 * pi * z); });
        run.march(0.02, 4);
        return copyOf(run.flow.velocity());
    };
    EXPECT_LE(relativeL2(end(PressureSolver::cg), end(std::nullopt)), tolerance);
}

TEST(IteratedFlow, saysWhatItCouldNotReach)
{
    FlowSettings settings = settingsOf(true, "RK3", PressureSolver::biCGStab);
    settings.iteration->krylov.maxIterations = 3;
    FlowRun run(unitSquare(24), Fluid{.nu = 0.01}, std::move(settings));
    run.start(manyWaves);
    run.step(0.002);
    const PressureRecord& record = *run.flow.pressureRecord();
    EXPECT_EQ(record.unconverged, 3);
    EXPECT_EQ(record.mostIterations, 3);
    EXPECT_GT(record.largestResidual, tolerance);
    EXPECT_TRUE(allFinite(run.flow.velocity()[0]));
}
