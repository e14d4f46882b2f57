// What pressureCost races against each other is the same thing.

#include "pressureRace.hpp"

#include <gtest/gtest.h>

using namespace isph;
using namespace isph::test;

TEST(PressureCost, everySolverFindsTheSamePressure)
{
    for (const char* kernel : racingKernels)
    {
        const PressureRace race(32, kernel, 2);
        RealField byTransforms(1, race.lattice().points());
        race.byTransforms(PlanEffort::estimated).solve(race.source(), byTransforms);
        for (const PressureSolver kind : {PressureSolver::biCGStab, PressureSolver::cg})
        {
            IterativePoisson solver = race.iterative(kind);
            RealField phi(1, race.lattice().points());
            solver.solve(race.source(), phi);
            EXPECT_TRUE(solver.result().converged) << kernel;
            EXPECT_GT(solver.result().iterations, 10) << kernel << ": the source is too easy";
            EXPECT_LE(largestDifference(phi, byTransforms), 1e-8) << kernel;
        }
    }
}
