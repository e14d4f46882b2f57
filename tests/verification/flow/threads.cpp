// The number of threads is no part of the answer: the same bits every time at one number, round-off between two.

#include "flow/PhysicalFlow.hpp"
#include "support/flowRun.hpp"

#include <gtest/gtest.h>
#include <omp.h>

using namespace isph;
using namespace isph::test;

namespace
{

template<class Flow>
RealField endWith(int threads, const Lattice& lattice, FlowSettings settings)
{
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    RunOf<Flow> run(lattice, Fluid{.nu = 0.001}, std::move(settings));
    run.flow.start(noise(lattice, lattice.dimensions(), 1), true);
    for (int n = 0; n < 2; ++n) { run.step(0.3 * largestStableStep(*run.settings.time, run.flow.rates())); }
    omp_set_num_threads(before);
    return copyOf(run.flow.velocity());
}

template<class Flow>
void expectIndependentOfThreads(const Lattice& lattice, const std::function<FlowSettings()>& settings)
{
    const RealField one = endWith<Flow>(1, lattice, settings());
    EXPECT_EQ(largestDifference(endWith<Flow>(1, lattice, settings()), one), 0);
    // Two: more would wait for each other on a busy machine.
    const RealField two = endWith<Flow>(2, lattice, settings());
    EXPECT_EQ(largestDifference(endWith<Flow>(2, lattice, settings()), two), 0);
    EXPECT_LE(relativeL2(two, one), 1e-13);
}

} // namespace

TEST(Threads, theAnswerDoesNotDependOnTheirNumber)
{
    for (const Lattice& lattice : {periodicBox({64, 48, 1}, {1, 1, 0}), unitCube(12)})
    {
        expectIndependentOfThreads<SpectralFlow>(lattice,
                                                 []
                                                 {
                                                     FlowSettings settings =
                                                         recommendedSettings(closedGaussian(10, 1.5));
                                                     settings.convection = ConvectionForm::skewSymmetric;
                                                     settings.exactMeanFlow = true;
                                                     return settings;
                                                 });
    }
    expectIndependentOfThreads<PhysicalFlow>(unitSquare(24),
                                             []
                                             {
                                                 FlowSettings settings = plainSettings(quinticSpline(1));
                                                 settings.directSum = true;
                                                 return settings;
                                             });
    // To round-off again: the iteration is only cut off by its tolerance.
    expectIndependentOfThreads<SpectralFlow>(
        periodicBox({48, 40, 1}, {1, 1, 0}),
        []
        {
            FlowSettings settings = recommendedSettings(sampledGaussian(4, 2, 4));
            settings.iteration = {.solver = PressureSolver::cg, .krylov = {1e-12, 1000}};
            return settings;
        });
}
