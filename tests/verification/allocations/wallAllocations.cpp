// A step between walls allocates nothing either.

#include "countedAllocations.hpp"
#include "flow/readFlowSettings.hpp"
#include "support/channelRun.hpp"

#include <gtest/gtest.h>

using namespace isph;
using namespace isph::test;

namespace
{

/// Allocations of some steps after the first, and of what chooses their length.
long allocationsOfSteps(BoundedRun& run)
{
    run.start([](int c, double x, double y, double) { return c == 0 ? std::sin(6 * x) * y * (1 - y) : 0.0; });
    run.march(1e-4, 1);
    const CountedAllocations counted;
    for (int n = 1; n < 5; ++n)
    {
        run.flow.rates();
        run.march(run.t + 1e-4 * n, 1);
    }
    run.flow.stepBack();
    return counted.count();
}

} // namespace

TEST(Allocations, noneInAStepBetweenWalls)
{
    const PlaceAndTime lid = [](int c, double x, double, double, double t)
    { return c == 0 ? std::pow(std::sin(3 * x), 2) * t : 0.0; };
    for (const WallTreatment treatment :
         {WallTreatment::consistent, WallTreatment::paper, WallTreatment::incremental, WallTreatment::rotational,
          WallTreatment::slip, WallTreatment::pressurePoisson})
    {
        for (const bool xBounded : {false, true})
        {
            const Lattice lattice = unitBox(24, 20, xBounded);
            FlowSettings settings = gaussianSettings(lattice);
            settings.walls = treatment;
            std::array<std::array<FaceCondition, 2>, 3> faces;
            if (xBounded) { faces[0] = {wallAtRest("sides"), wallAtRest("sides")}; }
            faces[1] = {wallAtRest("walls"), movingWall("walls", lid, true)};
            BoundedRun run(lattice, Fluid{.nu = 0.01}, std::move(settings), std::move(faces));
            EXPECT_EQ(allocationsOfSteps(run), 0) << wallTreatments().nameOf(treatment) << ", box " << xBounded;
        }
    }
}

TEST(Allocations, noneInAStepOfMirrorParticles)
{
    for (const bool iterated : {false, true})
    {
        FlowSettings settings = gaussianSettings(channelLattice(20), 4, 1.2);
        settings.kernel.supportRadius = 5;
        settings.eigenvalues = Eigenvalues::morris;
        if (iterated) { settings.iteration = {.solver = PressureSolver::cg}; }
        BoundedRun run = channelRun({.intervals = 20, .nu = 1}, std::move(settings));
        EXPECT_EQ(allocationsOfSteps(run), 0) << iterated;
    }
}

TEST(Allocations, noneInAStepOfCrankNicolson)
{
    FlowSettings settings = gaussianSettings(channelLattice(20));
    settings.crankNicolson = true;
    BoundedRun run = channelRun({.intervals = 20, .nu = 1}, std::move(settings));
    EXPECT_EQ(allocationsOfSteps(run), 0);
}
