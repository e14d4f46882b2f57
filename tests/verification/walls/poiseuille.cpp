// Flow between plates that a force drives, Re 100, at t = 11: from rest against the series, which is far from steady by
// then (a third of the deficit is left), and from the steady profile, which must stay.

#include "support/channelRun.hpp"
#include "support/record.hpp"

#include <numbers>

using namespace isph;
using namespace isph::test;
using std::numbers::pi;

namespace
{

Channel channel(int intervals) { return {.intervals = intervals, .nu = 0.01, .force = 0.08}; }

double steady(double y) { return 4 * y * (1 - y); }

double fromRest(double y, double t)
{
    double u = steady(y);
    for (int n = 1; n < 200; n += 2)
    {
        u -= 32 / std::pow(n * pi, 3) * std::sin(n * pi * y) * std::exp(-0.01 * n * n * pi * pi * t);
    }
    return u;
}

double errorFromSteady(int intervals, FlowSettings settings)
{
    BoundedRun run = channelRun(channel(intervals), std::move(settings));
    run.start([](int c, double, double y, double) { return c == 0 ? steady(y) : 0.0; });
    marchExplicitly(run, 11);
    return errorOf(run, [](double y, double) { return steady(y); });
}

} // namespace

TEST(Poiseuille, fromRestFollowsTheSeries)
{
    // At t = 1 as evaluated with 30 digits.
    EXPECT_NEAR(fromRest(0.25, 1), 0.07820915401450986, 1e-14);
    double before = 0;
    for (const auto& [intervals, most] : {std::pair{20, 1.3e-6}, {40, 4.6e-8}, {80, 1.5e-9}})
    {
        BoundedRun run = channelRun(channel(intervals));
        run.start([](int, double, double, double) { return 0.0; });
        marchExplicitly(run, 11);
        const double error = errorOf(run, [](double y, double) { return fromRest(y, 11); });
        record("N " + std::to_string(intervals), error);
        EXPECT_LE(error, most) << intervals;
        if (before > 0) { EXPECT_GE(observedOrder(before, error), 4.5) << intervals; }
        before = error;
    }
}

TEST(Poiseuille, theSteadyProfileStays)
{
    const double exact = errorFromSteady(20, boundedSettings(channelLattice(20)));
    const double byDefault = errorFromSteady(20, gaussianSettings(channelLattice(20)));
    record("exact, N 20", exact);
    record("order 20, N 20", byDefault);
    EXPECT_LE(exact, 1e-10);
    EXPECT_LE(byDefault, 1e-10);
    for (const int order : {4, 6, 8})
    {
        // The kernel smooths what the continuation makes up, too: of fixed length, seen by fixed numbers of points.
        const double coarse = errorFromSteady(20, gaussianSettings(channelLattice(20), order, 1.3));
        const double fine = errorFromSteady(40, gaussianSettings(channelLattice(40), order, 1.3));
        record("order " + std::to_string(order) + ", N 20", coarse);
        record("order " + std::to_string(order) + ", N 40", fine);
        EXPECT_LE(coarse, 4e-9) << order;
        EXPECT_LE(fine, 1e-9) << order;
    }
}
