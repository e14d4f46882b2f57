// The thin double shear layer against its resolved reference: docs/theory/periodic.md, section 11, tests D1 and D2.

#include "support/flowRun.hpp"
#include "support/record.hpp"

#include <array>
#include <vector>

using namespace isph;
using namespace isph::test;

namespace
{

double shearLayer(int component, double x, double y)
{
    if (component == 1) { return 0.05 * std::sin(2 * pi * (x + 0.25)); }
    return y <= 0.5 ? std::tanh(80 * (y - 0.25)) : std::tanh(80 * (0.75 - y));
}

/// Kinetic energy, enstrophy and largest vorticity over their values after the initial projection.
struct State
{
    double energy;
    double enstrophy;
    double vorticity;
};

struct ShearLayer : FlowRun
{
    ShearLayer(int n, double Re, FlowSettings how) : FlowRun(unitSquare(n), Fluid{.nu = 1 / Re}, std::move(how))
    {
        start([](int c, double x, double y, double) { return shearLayer(c, x, y); });
        initial = statistics();
    }

    State at(double time)
    {
        // Courant number 0.4 of a speed of 1.
        march(time, static_cast<int>(std::lround((time - t) * lattice.axis(0).count / 0.4)));
        const FlowStatistics now = statistics();
        return {now.kineticEnergy / initial.kineticEnergy, now.enstrophy / initial.enstrophy,
                now.maxVorticity / initial.maxVorticity};
    }

    FlowStatistics initial{};
};

struct Reference
{
    double t;
    double energy;
    double enstrophy;
};

/// Re 1e4, exact derivatives, rotational, 2/3, N = 256.
constexpr std::array<Reference, 5> resolved{{{0.4, 0.984640, 0.74996},
                                             {0.8, 0.972588, 0.58536},
                                             {1.0, 0.967749, 0.49650},
                                             {1.2, 0.963604, 0.43154},
                                             {2.0, 0.950432, 0.32837}}};

/// The same at N = 128.
constexpr std::array<Reference, 5> atN128{{{0.4, 0.984640, 0.75005},
                                           {0.8, 0.972583, 0.58598},
                                           {1.0, 0.967735, 0.49759},
                                           {1.2, 0.963580, 0.43251},
                                           {2.0, 0.950392, 0.32856}}};

void compare(ShearLayer& run, const std::array<Reference, 5>& references, double energyTolerance,
             double enstrophyTolerance)
{
    double worstEnergy = 0;
    double worstEnstrophy = 0;
    for (const Reference& reference : references)
    {
        const State state = run.at(reference.t);
        EXPECT_NEAR(state.energy, reference.energy, energyTolerance) << "t = " << reference.t;
        EXPECT_NEAR(state.enstrophy, reference.enstrophy, enstrophyTolerance) << "t = " << reference.t;
        worstEnergy = std::max(worstEnergy, std::abs(state.energy - reference.energy));
        worstEnstrophy = std::max(worstEnstrophy, std::abs(state.enstrophy - reference.enstrophy));
    }
    record("energyDifference", worstEnergy);
    record("enstrophyDifference", worstEnstrophy);
}

void compare(FlowSettings settings, double energyTolerance, double enstrophyTolerance)
{
    ShearLayer run(128, 1e4, std::move(settings));
    compare(run, resolved, energyTolerance, enstrophyTolerance);
}

} // namespace

TEST(ThinShearLayer, D1_exactDerivative) { compare(recommendedSettings(exactKernel()), 1e-4, 2e-3); }

TEST(ThinShearLayer, D1_gaussian10) { compare(recommendedSettings(closedGaussian(10, 1.5)), 1e-4, 2e-3); }

TEST(ThinShearLayer, D1_gaussian10WithFilter)
{
    FlowSettings settings = recommendedSettings(closedGaussian(10, 1.5));
    settings.filter = exponentialFilter();
    compare(std::move(settings), 2e-4, 2e-3);
}

TEST(ThinShearLayer, D1_gaussian4) { compare(recommendedSettings(closedGaussian(4, 1.3)), 2e-4, 8e-3); }

TEST(ThinShearLayer, D1_theReferenceItself)
{
    // The settings of the reference, at N = 128: its own column of the table to the last digit but one. It was divided
    // by the values before the initial field lost its modes beyond 2/3.
    FlowSettings settings = recommendedSettings(exactKernel());
    settings.convection = ConvectionForm::rotational;
    ShearLayer run(128, 1e4, std::move(settings));
    run.initial = ShearLayer(128, 1e4, plainSettings(exactKernel())).initial;
    EXPECT_NEAR(run.initial.enstrophy, 106.69, 0.015);
    compare(run, atN128, 2e-6, 5e-5);
}

TEST(ThinShearLayer, D2_underResolvedStaysBounded)
{
    struct Range
    {
        double Re;
        double least;
        double most;
    };
    for (const Range& range : {Range{1e4, 0.947, 0.953}, Range{1e5, 0.985, 0.995}, Range{1e6, 0.990, 1.0}})
    {
        for (const auto& [order, smoothingLength] : {std::pair{4, 1.3}, {4, 2.0}, {10, 1.5}})
        {
            SCOPED_TRACE("Re " + std::to_string(range.Re) + ", gaussian order " + std::to_string(order) + ", h/dx " +
                         std::to_string(smoothingLength));
            FlowSettings settings = recommendedSettings(closedGaussian(order, smoothingLength));
            settings.filter = exponentialFilter();
            ShearLayer run(64, range.Re, std::move(settings));
            State state{};
            double mostEnstrophy = 0;
            for (int n = 1; n <= 20; ++n)
            {
                state = run.at(0.1 * n);
                mostEnstrophy = std::max(mostEnstrophy, state.enstrophy);
                EXPECT_LE(state.enstrophy, 1) << "t = " << run.t;
            }
            EXPECT_GE(state.energy, range.least);
            EXPECT_LE(state.energy, range.most);
            const std::string name = "_Re" + std::to_string(static_cast<int>(range.Re)) + "_G" + std::to_string(order) +
                                     (smoothingLength == 2.0 ? "_wide" : "");
            record("energy" + name, state.energy);
            record("enstrophy" + name, state.enstrophy);
            record("mostEnstrophy" + name, mostEnstrophy);
        }
    }
}

TEST(ThinShearLayer, whatTheTheoryWarnsOf)
{
    const auto end = [](double Re, int order, double smoothingLength, ConvectionForm form, Dealiasing dealiasing)
    {
        FlowSettings settings = recommendedSettings(closedGaussian(order, smoothingLength));
        settings.convection = form;
        settings.dealiasing = dealiasing;
        return ShearLayer(64, Re, std::move(settings)).at(2);
    };
    using enum ConvectionForm;
    constexpr Dealiasing aliased = Dealiasing::none;
    constexpr Dealiasing twoThirds = Dealiasing::twoThirds;
    // A wide kernel lets the rotational form keep too much enstrophy: more than there was, when under-resolved.
    EXPECT_NEAR(end(1e4, 4, 2, rotational, twoThirds).enstrophy, 0.81, 0.04);
    EXPECT_GT(end(1e6, 4, 2, rotational, twoThirds).enstrophy, 3);
    // Aliasing does so to narrow kernels, or blows them up.
    EXPECT_NEAR(end(1e6, 4, 1.3, divergence, aliased).enstrophy, 1.02, 0.02);
    EXPECT_FALSE(end(1e4, 10, 1.5, divergence, aliased).energy < 1);
    // The advective form makes energy.
    EXPECT_NEAR(end(1e6, 4, 1.3, advective, aliased).energy, 1.021, 0.002);
    EXPECT_FALSE(end(1e4, 4, 2, advective, aliased).energy < 1);
}
