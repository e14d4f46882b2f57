#include "Flows.hpp"
#include "functions/FlowStatisticsFunction.hpp"

#include <gtest/gtest.h>

namespace isph
{
namespace
{

using namespace test;

/// A force of (1, 0) everywhere.
class Wind : public BodyForce
{
public:
    void evaluate(double, RealField& force) const override
    {
        for (double& value : force[0]) { value = 1; }
    }
    bool dependsOnTime() const override { return false; }
};

TEST(FlowStatistics, OfDecayingVortices)
{
    const double nu = 0.01;
    TaylorGreen vortices(16, nu);
    const TemporaryFolder folder;
    FlowStatisticsFunction statistics(folder.path / "flow.csv", vortices.lattice, vortices.fluid);
    statistics.execute(vortices.now());
    for (int row = 0; row < 10; ++row)
    {
        vortices.step(0.01);
        statistics.execute(vortices.now());
    }
    EXPECT_EQ(linesOf(folder.path / "flow.csv")[0],
              "time [s],step,kineticEnergy [m4/s2],enstrophy [m2/s2],enstrophyBudget [m2/s2],palinstrophy [1/s2],"
              "maxSpeed [m/s],CoMean,CoMax,divL2 [1/s],divLinf [1/s]");
    auto columns = readCsv(folder.path / "flow.csv");
    ASSERT_EQ(columns["time [s]"].size(), 11u);
    for (std::size_t row = 0; row < 11; ++row)
    {
        const double squares = std::exp(-16 * pi * pi * nu * columns["time [s]"][row]); // of the velocity's decay
        EXPECT_NEAR(columns["kineticEnergy [m4/s2]"][row], 0.25 * squares, 1e-14);
        EXPECT_NEAR(columns["enstrophy [m2/s2]"][row], 2 * pi * pi * squares, 1e-11);
        EXPECT_NEAR(columns["palinstrophy [1/s2]"][row], 16 * std::pow(pi, 4) * squares, 1e-9);
        EXPECT_NEAR(columns["maxSpeed [m/s]"][row], std::sqrt(squares), 1e-12);
        EXPECT_LT(columns["divLinf [1/s]"][row], 1e-13);
        // (16 pi^2 nu 0.01)^2/3 of it at the second row, where the difference is of second order; then less.
        EXPECT_NEAR(columns["enstrophyBudget [m2/s2]"][row], 2 * pi * pi * squares, row < 2 ? 2e-3 : 2e-5);
    }
    // (|Ux| + |Uy|)/dx is largest where one of them is alone: 1/dx.
    EXPECT_EQ(columns["CoMax"][0], 0);
    EXPECT_NEAR(columns["CoMax"][1], 0.16 * columns["maxSpeed [m/s]"][1], 1e-12);
    EXPECT_LT(columns["CoMean"][1], columns["CoMax"][1]);
}

TEST(FlowStatistics, HaveNoBudgetWithoutViscosity)
{
    const Lattice lattice = square(8);
    GivenFlow flow(lattice);
    const Fluid fluid;
    const TemporaryFolder folder;
    const Timings timings;
    FlowStatisticsFunction statistics(folder.path / "flow.csv", lattice, fluid);
    statistics.execute(at(flow, timings, 0));
    EXPECT_EQ(linesOf(folder.path / "flow.csv")[0],
              "time [s],step,kineticEnergy [m4/s2],enstrophy [m2/s2],palinstrophy [1/s2],"
              "maxSpeed [m/s],CoMean,CoMax,divL2 [1/s],divLinf [1/s]");
    EXPECT_EQ(readCsv(folder.path / "flow.csv")["CoMax"][0], 4) << "8 1/s times a step of 0.5 s";
}

// A uniform flow that a force drives has no enstrophy, and a budget that says so: dE/dt is the power, U f.
TEST(FlowStatistics, TakeThePowerOfForcesOutOfTheBudget)
{
    const Lattice lattice = square(8);
    GivenFlow flow(lattice);
    const Fluid fluid{.nu = 0.1, .bodyForce = std::make_unique<Wind>()};
    const TemporaryFolder folder;
    const Timings timings;
    FlowStatisticsFunction statistics(folder.path / "flow.csv", lattice, fluid);
    for (const double t : {0.0, 0.5, 1.0})
    {
        fill(flow.U, 0, lattice, [t](double, double, double) { return 2 + t; });
        statistics.execute(at(flow, timings, t));
    }
    auto table = readCsv(folder.path / "flow.csv");
    for (const double budget : table["enstrophyBudget [m2/s2]"]) { EXPECT_NEAR(budget, 0, 1e-12); }
}

TEST(FlowStatistics, CarryTheUnitsOfSpace)
{
    const Lattice lattice({Axis{'x', 0, 1, 8}, Axis{'y', 0, 1, 8}, Axis{'z', 0, 2, 8}}, {});
    GivenFlow flow(lattice);
    fill(flow.U, 2, lattice, [](double x, double, double) { return std::sin(2 * pi * x); });
    const Fluid fluid{.nu = 1};
    const TemporaryFolder folder;
    const Timings timings;
    FlowStatisticsFunction statistics(folder.path / "flow.csv", lattice, fluid);
    statistics.execute(at(flow, timings, 0));
    auto columns = readCsv(folder.path / "flow.csv");
    EXPECT_NEAR(columns.at("kineticEnergy [m5/s2]")[0], 0.5, 1e-14);
    EXPECT_NEAR(columns.at("enstrophy [m3/s2]")[0], 2 * pi * pi, 1e-12);
    EXPECT_NEAR(columns.at("palinstrophy [m/s2]")[0], 8 * std::pow(pi, 4), 1e-9);
}

} // namespace
} // namespace isph
