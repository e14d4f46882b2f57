// A step between walls that is taken back leaves nothing behind: the next one is as if it had never been.

#include "support/channelRun.hpp"
#include "support/flowRun.hpp"

#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

using namespace isph;
using namespace isph::test;
using std::numbers::pi;

namespace
{

/// Walls that move, the lower one faster and faster.
double lower(int c, double, double, double, double t) { return c == 0 ? t : 0; }
double upper(int c, double x, double, double, double) { return c == 0 ? 0.5 * std::sin(2 * pi * x) : 0; }

double vortices(int c, double x, double y, double)
{
    return c == 0 ? std::sin(2 * pi * x) * std::sin(2 * pi * y)
                  : -2 * std::cos(2 * pi * x) * std::pow(std::sin(pi * y), 2);
}

struct Variant
{
    std::string name;
    WallTreatment walls = WallTreatment::consistent;
    bool crankNicolson = false;
    bool automaticViscous = false;
};

BoundedRun runOf(const Variant& variant)
{
    FlowSettings settings = gaussianSettings(channelLattice(24));
    settings.walls = variant.walls;
    settings.crankNicolson = variant.crankNicolson;
    settings.automaticViscous = variant.automaticViscous;
    return channelRun({.intervals = 24, .nu = 0.01, .lower = lower, .upper = upper}, std::move(settings));
}

} // namespace

TEST(StepBackBetweenWalls, leavesNothingBehind)
{
    const std::vector<Variant> variants{{"consistent"},
                                        {"paper", WallTreatment::paper},
                                        {"incremental", WallTreatment::incremental},
                                        {"rotational", WallTreatment::rotational},
                                        {"pressurePoisson", WallTreatment::pressurePoisson},
                                        {"Crank-Nicolson", WallTreatment::consistent, true},
                                        {"viscous auto", WallTreatment::consistent, false, true}};
    for (const Variant& variant : variants)
    {
        SCOPED_TRACE(variant.name);
        BoundedRun straight = runOf(variant);
        BoundedRun stepped = runOf(variant);
        straight.start(vortices);
        stepped.start(vortices);
        for (int n = 0; n < 4; ++n)
        {
            const double t = 0.01 * n;
            straight.flow.rates();
            stepped.flow.rates();
            // Twice too long a step, the second one so much that friction would have to be taken implicitly.
            for (const double tooLong : {0.03, 0.3})
            {
                advance(*stepped.settings.time, stepped.flow, t, tooLong);
                EXPECT_GT(largestDifference(stepped.flow.velocity(), straight.flow.velocity()), 0);
                stepped.flow.rates();
                stepped.flow.stepBack();
                stepped.flow.rates();
            }
            advance(*straight.settings.time, straight.flow, t, 0.01);
            advance(*stepped.settings.time, stepped.flow, t, 0.01);
            EXPECT_EQ(largestDifference(stepped.flow.velocity(), straight.flow.velocity()), 0) << "step " << n;
            EXPECT_EQ(largestDifference(stepped.flow.pressure(t + 0.01), straight.flow.pressure(t + 0.01)), 0)
                << "step " << n;
            EXPECT_EQ(stepped.flow.viscousStep(), straight.flow.viscousStep());
        }
    }
}
