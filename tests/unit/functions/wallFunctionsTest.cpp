#include "Flows.hpp"
#include "functions/Forces.hpp"
#include "functions/PatchFlux.hpp"
#include "functions/WallProfile.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

using namespace test;

Axis walls(char name, double from, double to, int intervals, bool staggered = false)
{
    return {name, from, to - from, staggered ? intervals : intervals + 1, Axis::Ends::bounded, staggered};
}

const Patch floorPatch{"floor", Patch::Type::wall, {"yMin"}};
const Patch lidPatch{"lid", Patch::Type::wall, {"yMax"}};
const Patch sidesPatch{"sides", Patch::Type::wall, {"xMin", "xMax"}};

/// A box 2 x 1 with a floor, a lid and sides.
Lattice box(int n, bool staggered = false)
{
    return Lattice({walls('x', 0, 2, 2 * n, staggered), walls('y', 0, 1, n, staggered), Axis{'z'}},
                   {floorPatch, lidPatch, sidesPatch});
}

// U = (exp(x) cos(2 y), -exp(x) sin(2 y)/2), p = x + y^2; on the floor the wall is pulled by nu (du/dy + dv/dx) = 0, on
// the lid pushed on by 2.5 nu exp(x) sin(2).
void flowThroughBox(GivenFlow& flow, const Lattice& lattice)
{
    fill(flow.U, 0, lattice, [](double x, double y, double) { return std::exp(x) * std::cos(2 * y); });
    fill(flow.U, 1, lattice, [](double x, double y, double) { return -0.5 * std::exp(x) * std::sin(2 * y); });
    fill(flow.p, 0, lattice, [](double x, double y, double) { return x + y * y; });
}

constexpr double nu = 0.25;

TEST(WallProfile, HoldsVorticityShearAndPressurePointByPoint)
{
    for (const bool staggered : {false, true})
    {
        std::array<double, 3> coarse{};
        for (const int n : {40, 80})
        {
            const Lattice lattice = box(n, staggered);
            GivenFlow flow(lattice);
            flowThroughBox(flow, lattice);
            const TemporaryFolder folder;
            const Timings timings;
            WallProfile profile(folder.path, lattice, nu,
                                {{"lid", facesOf(lidPatch, lattice)}, {"sides", facesOf(sidesPatch, lattice)}},
                                {.scale = 2, .unit = "Pa"});
            profile.execute(at(flow, timings, 0.5, "0.5"));
            EXPECT_EQ(linesOf(folder.path / "0.5/lid.csv")[0],
                      "x [m],y [m],z [m],vorticity [1/s],shearStress.x [Pa],shearStress.y [Pa],shearStress.z [Pa],"
                      "p [Pa]");
            auto lid = readCsv(folder.path / "0.5/lid.csv");
            std::array<double, 3> errors{};
            ASSERT_EQ(lid["x [m]"].size(), static_cast<std::size_t>(lattice.axis(0).count));
            for (std::size_t i = 0; i < lid["x [m]"].size(); ++i)
            {
                const double x = lid["x [m]"][i];
                EXPECT_EQ(lid["y [m]"][i], 1);
                EXPECT_EQ(lid["shearStress.y [Pa]"][i], 0);
                const double e = std::exp(x) * std::sin(2);
                errors[0] = std::max(errors[0], std::abs(lid["vorticity [1/s]"][i] - 1.5 * e));
                errors[1] = std::max(errors[1], std::abs(lid["shearStress.x [Pa]"][i] - 2 * nu * 2.5 * e));
                errors[2] = std::max(errors[2], std::abs(lid["p [Pa]"][i] - 2 * (x + 1)));
            }
            EXPECT_LT(errors[2], 1e-12);
            for (std::size_t i = 0; n == 80 && i < 2; ++i)
            {
                EXPECT_LT(errors[i], 1e-3);
                EXPECT_GT(std::log2(coarse[i] / errors[i]), 3.5) << staggered;
            }
            coarse = errors;

            // Both sides, the lower one first.
            auto sides = readCsv(folder.path / "0.5/sides.csv");
            const auto rows = static_cast<std::size_t>(lattice.axis(1).count);
            ASSERT_EQ(sides["x [m]"].size(), 2 * rows);
            EXPECT_EQ(sides["x [m]"][rows - 1], 0);
            EXPECT_EQ(sides["x [m]"][rows], 2);
            const double y = sides["y [m]"][rows / 2];
            EXPECT_NEAR(sides["shearStress.y [Pa]"][rows / 2], -2 * nu * 2.5 * std::sin(2 * y), 1e-4)
                << "against the slope of v inwards";
        }
    }
}

TEST(WallProfile, HasThreeComponentsOfVorticityInSpace)
{
    const Lattice lattice({Axis{'x', 0, 1, 8}, walls('y', 0, 1, 16), Axis{'z', 0, 1, 8}}, {floorPatch, lidPatch});
    GivenFlow flow(lattice);
    fill(flow.U, 2, lattice, [](double, double y, double) { return 3 * y * (1 - y); });
    const TemporaryFolder folder;
    const Timings timings;
    WallProfile(folder.path, lattice, nu, {{"floor", facesOf(floorPatch, lattice)}}, {})
        .execute(at(flow, timings, 0, "0"));
    auto floor = readCsv(folder.path / "0/floor.csv");
    ASSERT_EQ(floor["x [m]"].size(), 64u);
    EXPECT_NEAR(floor["vorticity.x [1/s]"][10], 3, 1e-7);
    EXPECT_NEAR(floor["vorticity.z [1/s]"][10], 0, 1e-7);
    EXPECT_NEAR(floor["shearStress.z [m2/s2]"][10], 3 * nu, 1e-7);
}

/// The row of forces.csv.
std::map<std::string, double> forcesOn(const Patch& patch, const Lattice& lattice, GivenFlow& flow, const double* rho,
                                       std::array<double, 3> centre = {})
{
    const TemporaryFolder folder;
    const Timings timings;
    Forces forces(folder.path / "forces.csv", lattice, facesOf(patch, lattice), nu, rho, centre);
    forces.execute(at(flow, timings, 0.5));
    std::map<std::string, double> row;
    for (const auto& [head, values] : readCsv(folder.path / "forces.csv")) { row[head] = values.at(0); }
    return row;
}

TEST(Forces, AreThoseOfTheFluidOnThePatch)
{
    const Lattice lattice = box(40);
    GivenFlow flow(lattice);
    flowThroughBox(flow, lattice);
    auto lid = forcesOn(lidPatch, lattice, flow, nullptr);
    const double s = std::sin(2);
    const double e = std::exp(2) - 1;
    EXPECT_NEAR(lid["pressureForce.y [m3/s2]"], 4, 1e-12) << "pushed outwards";
    EXPECT_NEAR(lid["pressureForce.x [m3/s2]"], 0, 1e-12);
    EXPECT_NEAR(lid["viscousForce.x [m3/s2]"], nu * 2.5 * s * e, 1e-4);
    EXPECT_NEAR(lid["viscousForce.y [m3/s2]"], nu * 2 * std::cos(2) * e, 1e-4) << "-2 nu dv/dy";
    // (x, 1) x (0, x + 1): the integral of x (x + 1).
    EXPECT_NEAR(lid["pressureMoment.z [m4/s2]"], 8.0 / 3 + 2, 1e-11);
    EXPECT_NEAR(lid["pressureMoment.x [m4/s2]"], 0, 1e-12);

    const double rho = 1000;
    auto inNewton = forcesOn(lidPatch, lattice, flow, &rho, {1, 0, 5});
    EXPECT_NEAR(inNewton["pressureForce.y [N/m]"], 4000, 1e-9);
    EXPECT_NEAR(inNewton["pressureMoment.z [N]"], 1000 * (8.0 / 3 + 2 - 4), 1e-8);
    EXPECT_NEAR(inNewton["viscousForce.x [N/m]"], 1000 * lid["viscousForce.x [m3/s2]"], 1e-9);
}

TEST(Forces, PullTheWallsOfAChannelAlong)
{
    const Lattice lattice({Axis{'x', 0, 2, 8}, walls('y', 0, 1, 24), Axis{'z', 0, 3, 8}}, {floorPatch, lidPatch});
    GivenFlow flow(lattice);
    fill(flow.U, 0, lattice, [](double, double y, double) { return y * (1 - y); });
    const double rho = 2;
    EXPECT_NEAR(forcesOn(floorPatch, lattice, flow, &rho)["viscousForce.x [N]"], rho * nu * 6, 1e-7);
    EXPECT_NEAR(forcesOn(lidPatch, lattice, flow, &rho)["viscousForce.x [N]"], rho * nu * 6, 1e-7);
    // About the middle of the floor, the lid's force has the arm (., 1, .).
    EXPECT_NEAR(forcesOn(lidPatch, lattice, flow, nullptr, {1, 0, 1.5})["viscousMoment.z [m5/s2]"], -nu * 6, 1e-7);
}

TEST(PatchFlux, IsPositiveOutwards)
{
    const Lattice lattice = box(16);
    GivenFlow flow(lattice);
    fill(flow.U, 0, lattice, [](double x, double y, double) { return 6 * y * (1 - y) + x; });
    fill(flow.U, 1, lattice, [](double, double y, double) { return -y; });
    const TemporaryFolder folder;
    const Timings timings;
    PatchFlux(folder.path / "flux.csv", lattice,
              {{"floor", facesOf(floorPatch, lattice)},
               {"lid", facesOf(lidPatch, lattice)},
               {"sides", facesOf(sidesPatch, lattice)}},
              nullptr)
        .execute(at(flow, timings, 0.5));
    EXPECT_EQ(linesOf(folder.path / "flux.csv")[0], "time [s],floor [m2/s],lid [m2/s],sides [m2/s]");
    auto flux = readCsv(folder.path / "flux.csv");
    EXPECT_EQ(flux["time [s]"].at(0), 0.5);
    EXPECT_NEAR(flux["floor [m2/s]"].at(0), 0, 1e-14);
    EXPECT_NEAR(flux["lid [m2/s]"].at(0), -2, 1e-14);
    EXPECT_NEAR(flux["sides [m2/s]"].at(0), 2, 1e-14) << "3 leave, 1 enters";
}

TEST(PatchFlux, TakesWhatAFaceItselfPrescribes)
{
    // A lid owns its corners, yet nothing flows through the walls beside it.
    const Lattice lattice = box(16);
    std::array<std::array<FaceCondition, 2>, 3> faces;
    for (auto& axis : faces)
    {
        for (FaceCondition& face : axis)
        {
            face.velocity = VelocityCondition::value;
            face.pressure = PressureCondition::zeroGradient;
        }
    }
    const FlowBoundary boundary(lattice, std::move(faces));
    GivenFlow flow(lattice);
    fill(flow.U, 0, lattice, [](double, double y, double) { return y < 1 ? 0 : 1; });
    const TemporaryFolder folder;
    const Timings timings;
    PatchFlux(folder.path / "flux.csv", lattice, {{"right", facesOf({"right", Patch::Type::wall, {"xMax"}}, lattice)}},
              &boundary)
        .execute(at(flow, timings, 0));
    EXPECT_EQ(readCsv(folder.path / "flux.csv")["right [m2/s]"].at(0), 0);
}

} // namespace
} // namespace isph
