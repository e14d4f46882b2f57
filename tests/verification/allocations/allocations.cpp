// A step allocates nothing, from the first one on, whatever is switched on.

#include "countedAllocations.hpp"
#include "flow/PhysicalFlow.hpp"
#include "flow/readFluid.hpp"
#include "support/flowRun.hpp"
#include "support/TemporaryFolder.hpp"

#include <gtest/gtest.h>
#include <memory>
#include <vector>

using namespace isph;
using namespace isph::test;

namespace
{

/// A fluid as dictionaries give it.
Fluid readFrom(const std::string& properties, const Lattice& lattice)
{
    const TemporaryFolder folder;
    folder.write("constant/transportProperties", properties);
    return readFluid(Case(folder.path()), lattice);
}

const std::vector<std::string>& fluids()
{
    static const std::vector<std::string> texts{
        "nu 0.01;", "nu 0;", "nu 0.01; bodyForce uniform (1 2 3);",
        "nu 0.01; bodyForce expression (\"sin(2*pi*y)*cos(t)\" \"x > 0.5 ? 1 : 0\" \"sum(n, 1, 3, sin(n*x))\");"};
    return texts;
}

/// Allocations of some steps of changing length, and of what chooses them.
template<class Flow>
long allocationsOfSteps(const Lattice& lattice, const std::string& properties, FlowSettings settings)
{
    RunOf<Flow> run(lattice, readFrom(properties, lattice), std::move(settings));
    run.flow.start(noise(lattice, lattice.dimensions(), 1), true);
    RealField force(lattice.dimensions(), lattice.points());
    if (run.fluid.bodyForce) { run.fluid.bodyForce->evaluate(0, force); } // a formula is compiled when first evaluated

    const CountedAllocations counted;
    for (int n = 0; n < 4; ++n)
    {
        const StepRates rates = run.flow.rates();
        run.step(std::min(1e-3 / (1 + n % 2), 0.5 * largestStableStep(*run.settings.time, rates)));
    }
    run.flow.rates();
    run.flow.stepBack();
    run.step(1e-4);
    return counted.count();
}

} // namespace

TEST(Allocations, theCounterCounts)
{
    const CountedAllocations counted;
    const auto plain = std::make_unique<int>(1);
    EXPECT_EQ(counted.count(), 1);
    const AlignedVector<double> aligned(100);
    EXPECT_EQ(counted.count(), 2);
    const std::vector<char> array(1000);
    EXPECT_EQ(counted.count(), 3);
    EXPECT_EQ(*plain + aligned[0] + array[0], 1);
}

TEST(Allocations, noneInAStepOfTheSpectralFlow)
{
    for (const Lattice& lattice : {unitSquare(16), unitSquare(160), periodicBox({30, 21, 1}, {1, 2, 0}), unitCube(12),
                                   periodicBox({32, 20, 28}, {1, 1, 1})})
    {
        for (const ConvectionForm form :
             {ConvectionForm::divergence, ConvectionForm::rotational, ConvectionForm::advective,
              ConvectionForm::skewSymmetric, ConvectionForm::none})
        {
            for (const std::string& properties : fluids())
            {
                SCOPED_TRACE(std::to_string(lattice.points()) + " points, " +
                             std::string(convectionForms().nameOf(form)) + ", " + properties);
                FlowSettings everything = recommendedSettings(closedGaussian(10, 1.5));
                everything.convection = form;
                everything.exactMeanFlow = true;
                everything.filter = exponentialFilter();
                EXPECT_EQ(allocationsOfSteps<SpectralFlow>(lattice, properties, std::move(everything)), 0);

                FlowSettings paper = plainSettings(sampledGaussian(4, 1.2, 4));
                paper.convection = form;
                paper.eigenvalues = Eigenvalues::exact;
                paper.incremental = true;
                EXPECT_EQ(allocationsOfSteps<SpectralFlow>(lattice, properties, std::move(paper)), 0);
            }
        }
    }
}

TEST(Allocations, noneInAStepWhosePressureIsIterated)
{
    for (const PressureSolver solver : {PressureSolver::biCGStab, PressureSolver::cg})
    {
        FlowSettings spectral = plainSettings(sampledGaussian(4, 1.2, 4));
        spectral.iteration = {.solver = solver};
        EXPECT_EQ(allocationsOfSteps<SpectralFlow>(unitSquare(16), fluids().back(), std::move(spectral)), 0);
        FlowSettings classical = plainSettings(quinticSpline(1));
        classical.directSum = true;
        classical.iteration = {.solver = solver, .preconditioner = Preconditioning::none};
        EXPECT_EQ(allocationsOfSteps<PhysicalFlow>(unitCube(8), fluids().front(), std::move(classical)), 0);
    }
}

TEST(Allocations, noneInAStepOfFirstOrderProjection)
{
    EXPECT_EQ(allocationsOfSteps<SpectralFlow>(unitSquare(16), fluids().front(),
                                               plainSettings(exactKernel(), "firstOrderProjection")),
              0);
}

TEST(Allocations, noneInAStepOfTheDirectSum)
{
    for (const Lattice& lattice : {unitSquare(16), unitCube(8)})
    {
        for (const std::string& properties : fluids())
        {
            for (const ConvectionForm form : {ConvectionForm::divergence, ConvectionForm::rotational,
                                              ConvectionForm::advective, ConvectionForm::skewSymmetric})
            {
                SCOPED_TRACE(std::string(convectionForms().nameOf(form)) + ", " + properties);
                FlowSettings settings = plainSettings(quinticSpline(1));
                settings.directSum = true;
                settings.convection = form;
                settings.incremental = form == ConvectionForm::advective;
                EXPECT_EQ(allocationsOfSteps<PhysicalFlow>(lattice, properties, std::move(settings)), 0);
            }
        }
    }
}
