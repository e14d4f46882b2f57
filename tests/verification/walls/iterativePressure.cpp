// The classical iterative pressure between walls, mirror particles beyond them, against the same operator by transforms
// (docs/theory/iterativePressure.md).

#include "continuation/Mirror.hpp"
#include "flow/readFlowSettings.hpp"
#include "support/boundedRun.hpp"
#include "support/kernels.hpp"

#include <gtest/gtest.h>
#include <numbers>
#include <optional>

using namespace isph;
using namespace isph::test;

namespace
{

constexpr double pi = std::numbers::pi;

struct Scene
{
    WallTreatment walls;
    bool xBounded;
    bool staggered;
};

std::string nameOf(const testing::TestParamInfo<Scene>& info)
{
    const auto& [walls, xBounded, staggered] = info.param;
    return std::string(wallTreatments().nameOf(walls)) + (xBounded ? "_box" : "_channel") +
           (staggered ? "_staggered" : "_collocated");
}

Lattice latticeOf(const Scene& scene)
{
    Lattice lattice = unitBox(20, 24, scene.xBounded);
    if (!scene.staggered) { return lattice; }
    std::array<Axis, 3> axes{lattice.axis(0), lattice.axis(1), lattice.axis(2)};
    for (Axis& axis : axes) { axis.staggered = !axis.periodic(); }
    return {axes, lattice.patches()};
}

/// The lid's speed varies in space and time; its normal velocity stays zero.
std::unique_ptr<BoundedRun> runOf(const Scene& scene, std::optional<PressureSolver> solver)
{
    const Lattice lattice = latticeOf(scene);
    FlowSettings settings = boundedSettings(lattice);
    settings.kernel = sampledGaussian(4, 2, 4);
    settings.walls = scene.walls;
    settings.continuation = "mirror";
    for (int d = 0; d < 2; ++d)
    {
        const Axis& axis = lattice.activeAxis(d);
        if (axis.periodic()) { continue; }
        settings.continuations[static_cast<std::size_t>(d)] = std::make_unique<Mirror>(axis.count - 2, axis.staggered);
    }
    settings.eigenvalues = Eigenvalues::morris;
    if (solver) { settings.iteration = {.solver = *solver}; }
    const PlaceAndTime lid = [](int c, double x, double, double, double t)
    { return c == 0 ? std::pow(std::sin(pi * x), 2) * (1 + t) : 0.0; };
    std::array<std::array<FaceCondition, 2>, 3> faces;
    if (scene.xBounded) { faces[0] = {wallAtRest("sides"), wallAtRest("sides")}; }
    faces[1] = {wallAtRest("walls"), movingWall("walls", lid, true)};
    auto run = std::make_unique<BoundedRun>(lattice, Fluid{.nu = 0.01}, std::move(settings), std::move(faces));
    run->start(
        [](int c, double x, double y, double)
        {
            return c == 0 ? std::pow(std::sin(pi * x), 2) * std::sin(2 * pi * y)
                          : -std::sin(2 * pi * x) * std::pow(std::sin(pi * y), 2);
        });
    return run;
}

class IteratedWalls : public testing::TestWithParam<Scene>
{
};

INSTANTIATE_TEST_SUITE_P(
    With, IteratedWalls,
    testing::Values(Scene{WallTreatment::consistent, false, false}, Scene{WallTreatment::consistent, true, false},
                    Scene{WallTreatment::paper, true, false}, Scene{WallTreatment::paper, false, true},
                    Scene{WallTreatment::paper, true, true}, Scene{WallTreatment::rotational, true, false},
                    Scene{WallTreatment::incremental, true, true}, Scene{WallTreatment::pressurePoisson, false, false}),
    nameOf);

} // namespace

TEST_P(IteratedWalls, giveTheFlowThatTransformsGive)
{
    const auto transformed = runOf(GetParam(), std::nullopt);
    transformed->march(0.1, 10);
    for (const PressureSolver solver : {PressureSolver::biCGStab, PressureSolver::cg})
    {
        const auto iterated = runOf(GetParam(), solver);
        iterated->march(0.1, 10);
        EXPECT_LE(relativeL2(iterated->flow.velocity(), transformed->flow.velocity()), 1e-10);
        EXPECT_LE(relativeL2(iterated->flow.pressure(0.1), transformed->flow.pressure(0.1)), 3e-9);
        const PressureRecord& record = *iterated->flow.pressureRecord();
        EXPECT_EQ(record.solves, 30); // those for the start and for the pressure do not count
        EXPECT_EQ(record.unconverged, 0);
    }
}

TEST_P(IteratedWalls, writtenPressuresChangeNothing)
{
    const auto silent = runOf(GetParam(), PressureSolver::cg);
    const auto asked = runOf(GetParam(), PressureSolver::cg);
    for (int n = 1; n <= 4; ++n)
    {
        silent->march(0.01 * n, 1);
        asked->march(0.01 * n, 1);
        asked->flow.pressure(asked->t);
    }
    for (int c = 0; c < 2; ++c)
    {
        EXPECT_TRUE(std::ranges::equal(silent->flow.velocity()[c], asked->flow.velocity()[c]));
    }
}
