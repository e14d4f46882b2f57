#include "Flows.hpp"
#include "functions/FlowStatisticsFunction.hpp"

#include <algorithm>
#include <cmath>
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

Axis walls(char name, double from, double to, int intervals)
{
    return {name, from, to - from, intervals + 1, Axis::Ends::bounded};
}

// Two monopoles that collide with the wall y = -1 (Clercx & Bruneau 2006), at the start: E = 2, Z = 800.
TEST(FlowStatistics, OfADipoleBetweenWalls)
{
    const Lattice lattice({walls('x', -1, 1, 256), walls('y', -1, 1, 256), Axis{'z'}}, {});
    GivenFlow flow(lattice);
    constexpr double strength = 0.5 * 299.528385375226;
    const auto gauss = [](double x, double y) { return std::exp(-(x * x + y * y) / 0.01); };
    fill(flow.U, 0, lattice,
         [&](double x, double y, double) { return strength * y * (gauss(x + 0.1, y) - gauss(x - 0.1, y)); });
    fill(flow.U, 1, lattice,
         [&](double x, double y, double)
         { return strength * ((x - 0.1) * gauss(x - 0.1, y) - (x + 0.1) * gauss(x + 0.1, y)); });
    const Timings timings;
    const FlowStatistics statistics = FlowDiagnostics(lattice, 1.0 / 625).evaluate(flow, nullptr, 0);
    EXPECT_NEAR(statistics.kineticEnergy, 2, 1e-5 * 2);
    EXPECT_NEAR(statistics.enstrophy, 800, 1e-5 * 800);
    EXPECT_NEAR(statistics.boundaryPower, 0, 1e-30);
}

// A layer with vorticity u'(y) at the wall: no digit of its enstrophy is lost to the quadrature.
TEST(FlowStatistics, HoldALayerOfVorticityAtAWall)
{
    const auto error = [](int intervals)
    {
        const Lattice lattice({Axis{'x', 0, 1, 8}, walls('y', 0, 1, intervals), Axis{'z'}}, {});
        GivenFlow flow(lattice);
        constexpr double d = 1.0 / 32;
        fill(flow.U, 0, lattice, [](double, double y, double) { return 1 - std::exp(-y / d); });
        const double exact = (1 - std::exp(-2 / d)) / (4 * d);
        return std::abs(FlowDiagnostics(lattice, 1).evaluate(flow, nullptr, 0).enstrophy / exact - 1);
    };
    EXPECT_LT(error(128), 5e-3);
    EXPECT_LT(error(256), 2e-4);
    EXPECT_GT(std::log2(error(256) / error(512)), 4);
}

/// The largest difference between enstrophy and its budget in a flow that is known at all times, from the third row.
template<class Velocity, class Pressure>
double budgetGap(const Lattice& lattice, double nu, Velocity velocity, Pressure pressure)
{
    GivenFlow flow(lattice);
    const Fluid fluid{.nu = nu};
    const TemporaryFolder folder;
    const Timings timings;
    FlowStatisticsFunction statistics(folder.path / "flow.csv", lattice, fluid);
    for (int row = 0; row < 7; ++row)
    {
        const double t = 0.3 + 0.005 * row;
        velocity(flow.U, t);
        pressure(flow.p, t);
        statistics.execute(at(flow, timings, t));
    }
    auto table = readCsv(folder.path / "flow.csv");
    double gap = 0;
    for (std::size_t row = 3; row < 7; ++row)
    {
        const double enstrophy = table["enstrophy [m2/s2]"][row];
        gap = std::max(gap, std::abs(table["enstrophyBudget [m2/s2]"][row] / enstrophy - 1));
    }
    return gap;
}

// Stokes' layer: the wall y = 0 swings in its plane, u = exp(-k y) cos(w t - k y), w = 2 nu k^2, the one at y = 1
// follows.
TEST(FlowStatistics, TakeThePowerOfMovingWallsOutOfTheBudget)
{
    constexpr double nu = 0.1;
    constexpr double k = 5;
    const Lattice lattice({Axis{'x', 0, 1, 8}, walls('y', 0, 1, 80), Axis{'z'}}, {});
    EXPECT_LT(budgetGap(
                  lattice, nu,
                  [&](RealField& U, double t)
                  {
                      fill(U, 0, lattice,
                           [t](double, double y, double)
                           { return std::exp(-k * y) * std::cos(2 * nu * k * k * t - k * y); });
                  },
                  [](RealField&, double) {}),
              1e-4);
}

/// A lid that slides, or any velocity that is the same everywhere.
class Sliding : public FaceFunction
{
public:
    void evaluate(int component, std::span<const double>, std::span<const double>, std::span<const double>, double,
                  std::span<double> values) const override
    {
        std::ranges::fill(values, component == 0 ? 1.0 : 0.0);
    }
    bool dependsOnTime() const override { return false; }
};

// The lid's corners move, but they are no flow through the walls beside them.
TEST(FlowStatistics, LetCornersBelongToTheLid)
{
    const Lattice lattice({walls('x', 0, 1, 16), walls('y', 0, 1, 16), Axis{'z'}}, {});
    std::array<std::array<FaceCondition, 2>, 3> faces;
    for (std::size_t d = 0; d < 2; ++d)
    {
        for (FaceCondition& face : faces[d])
        {
            face.velocity = VelocityCondition::value;
            face.pressure = PressureCondition::zeroGradient;
        }
    }
    faces[1][1].U = std::make_unique<Sliding>();
    FlowBoundary boundary(lattice, std::move(faces));
    boundary.update(0);

    GivenFlow flow(lattice);
    fill(flow.U, 0, lattice, [](double, double y, double) { return y * y; });
    boundary.impose(flow.U);
    fill(flow.p, 0, lattice, [](double x, double, double) { return 1000 * x; });
    constexpr double nu = 0.5;
    const double power = FlowDiagnostics(lattice, nu, &boundary).evaluate(flow, nullptr, 0).boundaryPower;
    flow.p = RealField(1, lattice.points());
    EXPECT_EQ(FlowDiagnostics(lattice, nu, &boundary).evaluate(flow, nullptr, 0).boundaryPower, power);
    EXPECT_GT(power, 0);
}

// A piece of the decaying vortices of Taylor and Green: the boundary is flowed through, and the pressure does work.
TEST(FlowStatistics, TakeThePowerOfOpenBoundariesOutOfTheBudget)
{
    constexpr double nu = 0.05;
    const Lattice lattice({walls('x', 0.1, 0.6, 60), Axis{'y'}, walls('z', -0.3, 0.4, 80)}, {});
    const auto decay = [](double t) { return std::exp(-8 * pi * pi * nu * t); };
    EXPECT_LT(budgetGap(
                  lattice, nu,
                  [&](RealField& U, double t)
                  {
                      fill(U, 0, lattice,
                           [&](double x, double, double z)
                           { return -decay(t) * std::cos(2 * pi * x) * std::sin(2 * pi * z); });
                      fill(U, 1, lattice,
                           [&](double x, double, double z)
                           { return decay(t) * std::sin(2 * pi * x) * std::cos(2 * pi * z); });
                  },
                  [&](RealField& p, double t)
                  {
                      fill(p, 0, lattice,
                           [&](double x, double, double z)
                           { return -0.25 * decay(t) * decay(t) * (std::cos(4 * pi * x) + std::cos(4 * pi * z)); });
                  }),
              1e-4);
}

} // namespace
} // namespace isph
