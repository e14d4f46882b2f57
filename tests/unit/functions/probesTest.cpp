#include "functions/Probes.hpp"
#include "Flows.hpp"
#include "functions/SampleLinesFunction.hpp"

#include <gtest/gtest.h>

namespace isph
{
namespace
{

using namespace test;

class ProbesTest : public testing::Test
{
protected:
    TemporaryFolder folder;
    std::filesystem::path file = folder.path / "probes.csv";
    Timings timings;
};

TEST_F(ProbesTest, HitLatticePointsToTheBit)
{
    const Lattice lattice = square(8);
    GivenFlow flow(lattice);
    fill(flow.U, 0, lattice, [](double x, double y, double) { return std::exp(x) * y; });
    fill(flow.U, 1, lattice, [](double x, double y, double) { return std::log(1 + x + y); });
    fill(flow.p, 0, lattice, [](double x, double y, double) { return x * x - y; });
    const Points points{{{0.25, 0.875}, {0.5, 0}, {0, 0}}};
    Probes probes(file, lattice, {lattice, points, Interpolation::spectral}, FlowFields(lattice, {}),
                  {FlowQuantity::U, FlowQuantity::p});
    probes.execute(at(flow, timings, 0.5));
    EXPECT_EQ(linesOf(file)[0], "time [s],U.x(0) [m/s],U.y(0) [m/s],U.z(0) [m/s],p(0) [m2/s2],"
                                "U.x(1) [m/s],U.y(1) [m/s],U.z(1) [m/s],p(1) [m2/s2]");
    auto columns = readCsv(file);
    const std::size_t first = 2 + 8 * 4;
    EXPECT_EQ(columns["time [s]"].at(0), 0.5);
    EXPECT_EQ(columns["U.x(0) [m/s]"].at(0), flow.U[0][first]);
    EXPECT_EQ(columns["U.y(0) [m/s]"].at(0), flow.U[1][first]);
    EXPECT_EQ(columns["U.z(0) [m/s]"].at(0), 0);
    EXPECT_EQ(columns["p(0) [m2/s2]"].at(0), flow.p[0][first]);
    EXPECT_EQ(columns["U.x(1) [m/s]"].at(0), flow.U[0][7]);
    EXPECT_EQ(columns["p(1) [m2/s2]"].at(0), flow.p[0][7]);
}

TEST_F(ProbesTest, TakeFieldsThatFollowFromTheVelocity)
{
    const Lattice lattice = upright(16);
    GivenFlow flow(lattice);
    fill(flow.U, 0, lattice, [](double, double, double z) { return std::sin(2 * pi * z); });
    fill(flow.U, 1, lattice, [](double x, double, double) { return std::sin(4 * pi * x); });
    fill(flow.p, 0, lattice, [](double x, double, double) { return std::cos(2 * pi * x); });
    const Points points{{{0.2}, {0}, {0.7}}};
    Probes probes(
        file, lattice, {lattice, points, Interpolation::spectral}, FlowFields(lattice, {.scale = 1000, .unit = "Pa"}),
        {FlowQuantity::vorticity, FlowQuantity::divergence, FlowQuantity::Q, FlowQuantity::p, FlowQuantity::U});
    probes.execute(at(flow, timings, 0));
    EXPECT_EQ(linesOf(file)[0], "time [s],vorticity(0) [1/s],divergence(0) [1/s],Q(0) [1/s2],p(0) [Pa],"
                                "U.x(0) [m/s],U.y(0) [m/s],U.z(0) [m/s]");
    auto columns = readCsv(file);
    const double dUdz = 2 * pi * std::cos(2 * pi * 0.7);
    const double dWdx = 4 * pi * std::cos(4 * pi * 0.2);
    EXPECT_NEAR(columns["vorticity(0) [1/s]"].at(0), dUdz - dWdx, 1e-12); // about y
    EXPECT_NEAR(columns["divergence(0) [1/s]"].at(0), 0, 1e-12);
    EXPECT_NEAR(columns["Q(0) [1/s2]"].at(0), -dUdz * dWdx, 1e-11);
    EXPECT_NEAR(columns["p(0) [Pa]"].at(0), 1000 * std::cos(2 * pi * 0.2), 1e-10);
    EXPECT_EQ(columns["U.y(0) [m/s]"].at(0), 0);
    EXPECT_NEAR(columns["U.z(0) [m/s]"].at(0), std::sin(4 * pi * 0.2), 1e-13);
}

TEST_F(ProbesTest, OfLinesWriteAFolderATime)
{
    const Lattice lattice = square(8);
    GivenFlow flow(lattice);
    fill(flow.U, 0, lattice, [](double, double y, double) { return std::sin(2 * pi * y); });
    SampleSet samples(lattice, {{"rise", {0, 0, 0}, {0, 1, 0}, 5}}, {}, {{"vorticity", {}}, {"U", {}}},
                      Interpolation::spectral);
    SampleLinesFunction lines(folder.path / "profiles", std::move(samples), FlowFields(lattice, {}));
    lines.execute(at(flow, timings, 0.25, "0.25"));
    EXPECT_EQ(linesOf(folder.path / "profiles/0.25/rise.csv")[0],
              "distance [m],x [m],y [m],z [m],vorticity [1/s],U.x [m/s],U.y [m/s],U.z [m/s]");
    auto columns = readCsv(folder.path / "profiles/0.25/rise.csv");
    EXPECT_NEAR(columns["vorticity [1/s]"].at(2), 2 * pi, 1e-12);
    EXPECT_NEAR(columns["U.x [m/s]"].at(1), 1, 1e-14);
}

TEST_F(ProbesTest, OfLinesRefuseFieldsThatAFlowDoesNotHave)
{
    const Lattice lattice = square(8);
    SampleSet samples(lattice, {{"rise", {0, 0, 0}, {0, 1, 0}, 5}}, {}, {{"T", {"system/sampleDict", 4, "fields"}}},
                      Interpolation::spectral);
    try
    {
        const SampleLinesFunction lines(folder.path, std::move(samples), FlowFields(lattice, {}));
        FAIL();
    }
    catch (const Error& error)
    {
        EXPECT_STREQ(error.what(), "system/sampleDict:4: fields: 'T' is not a known field\n"
                                   "    known are: U, p, vorticity, divergence, Q");
    }
}

} // namespace
} // namespace isph
