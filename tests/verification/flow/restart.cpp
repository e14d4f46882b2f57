// A flow that is saved, restored or stepped back goes on in the same bits.

#include "flow/PhysicalFlow.hpp"
#include "support/flowRun.hpp"
#include "support/TemporaryFolder.hpp"

#include <gtest/gtest.h>
#include <vector>

using namespace isph;
using namespace isph::test;

namespace
{

/// Along x, stronger with time.
class GrowingForce : public BodyForce
{
public:
    explicit GrowingForce(const Lattice& lattice) : y_(lattice.coordinates()[1]) {}
    void evaluate(double t, RealField& force) const override
    {
        for (int c = 1; c < force.components(); ++c)
        {
            for (double& value : force[c]) { value = 0.1 * c; }
        }
        for (std::size_t i = 0; i < force.size(); ++i) { force[0][i] = t * std::sin(2 * pi * y_[i]); }
    }
    bool dependsOnTime() const override { return true; }

private:
    std::vector<double> y_;
};

/// A flow that begins with noise.
template<class Flow>
struct Started : RunOf<Flow>
{
    Started(const Lattice& box, FlowSettings how) : Started(box, std::move(how), noise(box, box.dimensions(), 4)) {}
    Started(const Lattice& box, FlowSettings how, const RealField& velocity)
        : RunOf<Flow>(box, Fluid{.nu = 0.01, .bodyForce = std::make_unique<GrowingForce>(box)}, std::move(how))
    {
        this->flow.start(velocity, true);
    }
};

/// The length of step n: they differ, as those of an adapted time step do.
double stepLength(int n) { return 0.002 * (1 + n % 3); }

template<class Flow>
void steps(RunOf<Flow>& run, int from, int to)
{
    for (int n = from; n < to; ++n) { run.step(stepLength(n)); }
}

template<class Flow>
void expectSameBits(RunOf<Flow>& a, RunOf<Flow>& b, const std::string& what)
{
    EXPECT_EQ(largestDifference(a.flow.velocity(), b.flow.velocity()), 0) << what;
    EXPECT_EQ(largestDifference(a.flow.pressure(a.t), b.flow.pressure(b.t)), 0) << what;
    EXPECT_EQ(largestDifference(a.flow.divergence(), b.flow.divergence()), 0) << what;
    EXPECT_EQ(a.flow.rates().courant, b.flow.rates().courant) << what;
    EXPECT_EQ(a.flow.rates().convective, b.flow.rates().convective) << what;
}

template<class Flow>
void expectRestartsToTheBit(const Lattice& lattice, const std::function<FlowSettings()>& settings,
                            const std::string& what)
{
    const TemporaryFolder folder;
    Started<Flow> whole(lattice, settings());
    steps(whole, 0, 9);

    Started<Flow> interrupted(lattice, settings());
    steps(interrupted, 0, 4);
    {
        FieldWriter writer(folder / "fields.h5", lattice);
        interrupted.flow.save(writer);
        writer.close();
    }
    Started<Flow> resumed(lattice, settings(), RealField(lattice.dimensions(), lattice.points()));
    {
        const FieldReader reader(folder / "fields.h5");
        ASSERT_TRUE(resumed.flow.restores(reader));
        resumed.flow.restore(reader);
    }
    resumed.t = interrupted.t;
    expectSameBits(resumed, interrupted, what);
    steps(resumed, 4, 9);
    expectSameBits(resumed, whole, what);
}

template<class Flow>
void expectStepsBack(const Lattice& lattice, const std::function<FlowSettings()>& settings, const std::string& what)
{
    Started<Flow> straight(lattice, settings());
    Started<Flow> stepped(lattice, settings());
    steps(straight, 0, 3);
    steps(stepped, 0, 3);
    const double t = stepped.t;
    stepped.step(0.01);
    EXPECT_GT(largestDifference(straight.flow.velocity(), stepped.flow.velocity()), 0) << what;
    stepped.flow.stepBack();
    stepped.t = t;
    expectSameBits(straight, stepped, what);
    // And goes on from there as if nothing had been.
    steps(straight, 3, 6);
    steps(stepped, 3, 6);
    expectSameBits(straight, stepped, what);
}

template<class Flow>
void expectAskingChangesNothing(const Lattice& lattice, const std::function<FlowSettings()>& settings,
                                const std::string& what)
{
    Started<Flow> silent(lattice, settings());
    Started<Flow> asked(lattice, settings());
    for (int n = 0; n < 6; ++n)
    {
        silent.step(stepLength(n));
        asked.step(stepLength(n));
        asked.flow.velocity();
        asked.flow.pressure(asked.t);
        asked.flow.divergence();
        asked.flow.rates();
        asked.statistics();
    }
    expectSameBits(silent, asked, what);
}

std::vector<std::pair<std::string, std::function<FlowSettings()>>> spectralVariants()
{
    std::vector<std::pair<std::string, std::function<FlowSettings()>>> variants;
    for (const ConvectionForm form : {ConvectionForm::divergence, ConvectionForm::rotational, ConvectionForm::advective,
                                      ConvectionForm::skewSymmetric, ConvectionForm::none})
    {
        const std::string name(convectionForms().nameOf(form));
        variants.emplace_back(name,
                              [form]
                              {
                                  FlowSettings settings = recommendedSettings(closedGaussian(10, 1.5));
                                  settings.convection = form;
                                  settings.exactMeanFlow = true;
                                  settings.filter = exponentialFilter();
                                  return settings;
                              });
        variants.emplace_back(name + " explicit incremental",
                              [form]
                              {
                                  FlowSettings settings = plainSettings(quinticSpline(1.5));
                                  settings.convection = form;
                                  settings.eigenvalues = Eigenvalues::exact;
                                  settings.incremental = true;
                                  return settings;
                              });
    }
    for (const bool incremental : {false, true})
    {
        variants.emplace_back("iterated",
                              [incremental]
                              {
                                  FlowSettings settings = recommendedSettings(sampledGaussian(4, 1.2, 4));
                                  settings.iteration = {.solver = PressureSolver::biCGStab, .krylov = {1e-6, 1000}};
                                  settings.incremental = incremental;
                                  settings.exactMeanFlow = true;
                                  settings.filter = exponentialFilter();
                                  return settings;
                              });
    }
    return variants;
}

std::vector<std::pair<std::string, std::function<FlowSettings()>>> physicalVariants()
{
    std::vector<std::pair<std::string, std::function<FlowSettings()>>> variants;
    for (const bool incremental : {false, true})
    {
        variants.emplace_back("directSum",
                              [incremental]
                              {
                                  FlowSettings settings = plainSettings(quinticSpline(1.2));
                                  settings.directSum = true;
                                  settings.incremental = incremental;
                                  return settings;
                              });
    }
    variants.emplace_back("directSum iterated",
                          []
                          {
                              FlowSettings settings = plainSettings(quinticSpline(1.2), "firstOrderProjection");
                              settings.directSum = true;
                              settings.iteration = {.solver = PressureSolver::cg, .krylov = {1e-6, 1000}};
                              return settings;
                          });
    return variants;
}

std::vector<Lattice> lattices() { return {periodicBox({16, 13, 1}, {1, 2, 0}), periodicBox({8, 7, 6}, {1, 1, 1})}; }

} // namespace

TEST(Restart, goesOnInTheSameBits)
{
    for (const Lattice& lattice : lattices())
    {
        for (const auto& [name, settings] : spectralVariants())
        {
            expectRestartsToTheBit<SpectralFlow>(lattice, settings, name);
        }
        for (const auto& [name, settings] : physicalVariants())
        {
            expectRestartsToTheBit<PhysicalFlow>(lattice, settings, name);
        }
    }
}

TEST(Restart, oneKindOfFlowDoesNotTakeTheStateOfAnother)
{
    const TemporaryFolder folder;
    const Lattice lattice = lattices().front();
    Started<SpectralFlow> spectral(lattice, spectralVariants().front().second());
    Started<PhysicalFlow> physical(lattice, physicalVariants().front().second());
    FieldWriter writer(folder / "fields.h5", lattice);
    spectral.flow.save(writer);
    writer.close();
    EXPECT_FALSE(physical.flow.restores(FieldReader(folder / "fields.h5")));
}

TEST(StepBack, returnsTheBitsBeforeTheStep)
{
    for (const Lattice& lattice : lattices())
    {
        for (const auto& [name, settings] : spectralVariants())
        {
            expectStepsBack<SpectralFlow>(lattice, settings, name);
        }
        for (const auto& [name, settings] : physicalVariants())
        {
            expectStepsBack<PhysicalFlow>(lattice, settings, name);
        }
    }
}

TEST(Output, askingChangesNothing)
{
    for (const Lattice& lattice : lattices())
    {
        for (const auto& [name, settings] : spectralVariants())
        {
            expectAskingChangesNothing<SpectralFlow>(lattice, settings, name);
        }
        for (const auto& [name, settings] : physicalVariants())
        {
            expectAskingChangesNothing<PhysicalFlow>(lattice, settings, name);
        }
    }
}
