// Orders in time, incremental coupling and mismatched eigenvalues: docs/theory/periodic.md, section 5, on the moving
// Taylor-Green vortex (U0 = (1, 0.5), Re 100, t = 0.5, N = 32).

#include "support/flowRun.hpp"
#include "support/record.hpp"

#include <array>
#include <vector>

using namespace isph;
using namespace isph::test;

namespace
{

const TaylorGreen movingVortex{.nu = 0.01, .U0 = 1, .V0 = 0.5};
constexpr std::array<int, 4> stepCounts{50, 100, 200, 400};

/// What a run ends with.
struct LastState
{
    RealField velocity;
    RealField pressure;
    double divergence; ///< largest magnitude
};

LastState endOf(FlowSettings settings, int steps)
{
    FlowRun run(unitSquare(32), Fluid{.nu = movingVortex.nu}, std::move(settings));
    run.start([](int c, double x, double y, double) { return movingVortex.velocity(c, x, y, 0); });
    run.march(0.5, steps);
    return {copyOf(run.flow.velocity()), copyOf(run.flow.pressure(0.5)), divergenceNorms(run.flow).Linf};
}

RealField exactVelocity()
{
    return fieldOf(unitSquare(32), 2,
                   [](int c, double x, double y, double) { return movingVortex.velocity(c, x, y, 0.5); });
}

RealField exactPressure()
{
    return fieldOf(unitSquare(32), 1, [](int, double x, double y, double) { return movingVortex.pressure(x, y, 0.5); });
}

double order(double coarse, double fine) { return std::log2(coarse / fine); }

/// The samples of the 2021 paper: G4, support 4h, h/dx = 2.
FlowSettings paperKernel(Eigenvalues eigenvalues, bool incremental)
{
    FlowSettings settings = plainSettings(sampledGaussian(4, 2, 4));
    settings.eigenvalues = eigenvalues;
    settings.incremental = incremental;
    settings.convection = ConvectionForm::advective;
    return settings;
}

} // namespace

TEST(TimeOrder, T2_rungeKuttaIsThirdOrder)
{
    for (const bool integratingFactor : {false, true})
    {
        const std::array<double, 4> expected = integratingFactor ? std::array{4.6e-5, 5.75e-6, 7.15e-7, 8.9e-8}
                                                                 : std::array{4.7e-5, 5.8e-6, 7.2e-7, 9.0e-8};
        const std::array<double, 4> pressures{1.7e-4, 2.1e-5, 2.6e-6, 3.3e-7};
        std::vector<double> velocity;
        std::vector<double> pressure;
        for (std::size_t i = 0; i < stepCounts.size(); ++i)
        {
            FlowSettings settings = plainSettings(exactKernel());
            settings.integratingFactor = integratingFactor;
            const LastState end = endOf(std::move(settings), stepCounts[i]);
            velocity.push_back(relativeL2(end.velocity, exactVelocity()));
            pressure.push_back(relativeL2(end.pressure, exactPressure()));
            EXPECT_NEAR(velocity.back() / expected[i], 1, 0.02);
            EXPECT_NEAR(pressure.back() / pressures[i], 1, 0.04);
            if (i == 0) { continue; }
            EXPECT_NEAR(order(velocity[i - 1], velocity[i]), 3, 0.05);
            EXPECT_NEAR(order(pressure[i - 1], pressure[i]), 3, 0.1);
            record("velocityOrder", order(velocity[i - 1], velocity[i]));
            record("pressureOrder", order(pressure[i - 1], pressure[i]));
        }
    }
}

TEST(TimeOrder, T2_firstOrderProjection)
{
    std::vector<double> velocity;
    std::vector<double> pressure;
    for (const int steps : stepCounts)
    {
        const LastState end = endOf(plainSettings(exactKernel(), "firstOrderProjection"), steps);
        velocity.push_back(relativeL2(end.velocity, exactVelocity()));
        pressure.push_back(relativeL2(end.pressure, exactPressure()));
    }
    record("velocityOrder", order(velocity[2], velocity[3]));
    EXPECT_NEAR(velocity.front() / 7.0e-2, 1, 0.02);
    EXPECT_NEAR(velocity.back() / 7.9e-3, 1, 0.02);
    EXPECT_NEAR(pressure.front() / 2.8e-1, 1, 0.02);
    EXPECT_NEAR(pressure.back() / 3.1e-2, 1, 0.02);
    EXPECT_NEAR(order(velocity[2], velocity[3]), 1, 0.05);
    EXPECT_NEAR(order(pressure[2], pressure[3]), 1, 0.1);
}

TEST(Coupling, consistentEigenvaluesMakeTheIncrementIrrelevant)
{
    for (const ConvectionForm form : {ConvectionForm::divergence, ConvectionForm::advective})
    {
        std::vector<LastState> ends;
        for (const bool incremental : {false, true})
        {
            FlowSettings settings = paperKernel(Eigenvalues::consistent, incremental);
            settings.convection = form;
            ends.push_back(endOf(std::move(settings), 50));
            EXPECT_LE(ends.back().divergence, 1e-13);
        }
        EXPECT_LE(relativeL2(ends[0].velocity, ends[1].velocity), 1e-14);
        EXPECT_LE(relativeL2(ends[0].pressure, ends[1].pressure), 1e-13);
    }
}

TEST(Coupling, mismatchedEigenvalues)
{
    // The table's limit of small steps is a run with 800 of them.
    const RealField limit = endOf(paperKernel(Eigenvalues::consistent, false), 800).velocity;
    struct Row
    {
        Eigenvalues eigenvalues;
        bool incremental;
        double coarse;           ///< velocity error at dt = 0.01
        double fine;             ///< at 0.00125
        double coarseDivergence; ///< 0: not in the table
        double fineDivergence;
    };
    for (const Row& row : {Row{Eigenvalues::consistent, false, 4.6e-5, 7.8e-8, 0, 0},
                           Row{Eigenvalues::exact, false, 1.7e-4, 1.8e-5, 2.5e-3, 3e-4},
                           Row{Eigenvalues::exact, true, 4.7e-5, 1.5e-7, 1.9e-4, 3e-6},
                           Row{Eigenvalues::secondOrder, false, 9.0e-5, 7.2e-6, 1.0e-3, 0},
                           Row{Eigenvalues::secondOrder, true, 4.6e-5, 9.7e-8, 8e-5, 0},
                           Row{Eigenvalues::fourthOrder, false, 1.7e-4, 1.8e-5, 2.5e-3, 0},
                           Row{Eigenvalues::fourthOrder, true, 4.7e-5, 1.5e-7, 1.9e-4, 0}})
    {
        SCOPED_TRACE(std::string(eigenvalueForms().nameOf(row.eigenvalues)) + (row.incremental ? " incremental" : ""));
        const LastState coarse = endOf(paperKernel(row.eigenvalues, row.incremental), 50);
        const LastState fine = endOf(paperKernel(row.eigenvalues, row.incremental), 400);
        EXPECT_NEAR(relativeL2(coarse.velocity, limit) / row.coarse, 1, 0.1);
        EXPECT_NEAR(relativeL2(fine.velocity, limit) / row.fine, 1, 0.1);
        if (row.coarseDivergence > 0) { EXPECT_NEAR(coarse.divergence / row.coarseDivergence, 1, 0.1); }
        if (row.fineDivergence > 0) { EXPECT_NEAR(fine.divergence / row.fineDivergence, 1, 0.1); }
    }
}

TEST(Coupling, divergenceLeftByOneProjection)
{
    struct Row
    {
        const char* name;
        std::function<KernelSettings()> kernel;
        double exact;
        double secondOrder;
        double fourthOrder;
    };
    const std::array<Row, 4> table{{{"quintic", [] { return quinticSpline(2); }, 0.75, 0.77, 0.76},
                                    {"G4 4h", [] { return sampledGaussian(4, 2, 4); }, 0.65, 0.64, 0.67},
                                    {"G10 closed", [] { return closedGaussian(10, 1.5); }, 0.48, 0.37, 0.42},
                                    {"exact", exactKernel, 0.11, 0.73, 0.38}}};
    for (const Row& row : table)
    {
        const std::vector<std::pair<Eigenvalues, double>> columns{{Eigenvalues::exact, row.exact},
                                                                  {Eigenvalues::secondOrder, row.secondOrder},
                                                                  {Eigenvalues::fourthOrder, row.fourthOrder},
                                                                  {Eigenvalues::consistent, 0}};
        for (const auto& [eigenvalues, expected] : columns)
        {
            SCOPED_TRACE(std::string(row.name) + " " + std::string(eigenvalueForms().nameOf(eigenvalues)));
            FlowSettings settings = plainSettings(row.kernel(), "firstOrderProjection");
            settings.convection = ConvectionForm::none;
            settings.eigenvalues = eigenvalues;
            FlowRun run(unitSquare(64), Fluid{}, std::move(settings));
            run.flow.start(noise(run.lattice, 2, 5), false);
            const double before = divergenceNorms(run.flow).L2;
            run.step(1);
            const double left = divergenceNorms(run.flow).L2 / before;
            if (eigenvalues == Eigenvalues::consistent) { EXPECT_LE(left, 1e-15); }
            else { EXPECT_NEAR(left, expected, 0.03) << "one realisation of white noise"; }
        }
    }
}
