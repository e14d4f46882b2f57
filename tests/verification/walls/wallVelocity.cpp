// After a step the velocity at the walls is the prescribed one, bit by bit; inside, divergence is what the difference
// between the operators of the projection leaves.

#include "support/channelRun.hpp"
#include "support/record.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

using namespace isph;
using namespace isph::test;
using std::numbers::pi;

namespace
{

/// Walls that move in their plane and let through what they let in elsewhere, in place and time.
double wall(int c, double x, double, double, double t)
{
    return c == 0 ? std::sin(2 * pi * (x - t)) : 0.1 * std::cos(2 * pi * x) * std::sin(t);
}

/// Vortices between walls that decay.
double vortices(int c, double x, double y, double)
{
    return c == 0 ? std::sin(2 * pi * x) * std::sin(2 * pi * y)
                  : -2 * std::cos(2 * pi * x) * std::pow(std::sin(pi * y), 2);
}

} // namespace

TEST(WallVelocity, isThePrescribedOneAfterEveryStep)
{
    for (const WallTreatment treatment : {WallTreatment::consistent, WallTreatment::paper})
    {
        FlowSettings settings = gaussianSettings(channelLattice(24));
        settings.walls = treatment;
        BoundedRun run = channelRun({.intervals = 24, .nu = 0.01, .lower = wall, .upper = wall}, std::move(settings));
        run.start(vortices);
        const auto [x, y, z] = run.lattice.coordinates();
        for (int step = 1; step <= 10; ++step)
        {
            run.march(0.01 * step, 1);
            const RealField& u = run.flow.velocity();
            for (std::size_t i = 0; i < u.size(); ++i)
            {
                if (y[i] > 0 && y[i] < 1) { continue; }
                for (int c = 0; c < 2; ++c)
                {
                    // To the bits of the time: the sum of the substeps may end one beside it.
                    EXPECT_NEAR(u[c][i], wall(c, x[i], y[i], z[i], run.t), 1e-15) << step;
                }
            }
        }
    }
}

TEST(WallVelocity, ofWallsAtConstantSpeedToTheBit)
{
    BoundedRun run = channelRun({.intervals = 24, .nu = 0.01, .upper = [](int c, double x, double, double, double) {
                                     return c == 0 ? 0.1 + std::sin(2 * pi * x) / 3 : 0.0;
                                 }});
    run.start(vortices);
    run.march(0.1, 10);
    const auto [x, y, z] = run.lattice.coordinates();
    const RealField& u = run.flow.velocity();
    for (std::size_t i = 0; i < u.size(); ++i)
    {
        if (y[i] == 0) { EXPECT_EQ(u[0][i], 0); }
        if (y[i] == 1) { EXPECT_EQ(u[0][i], 0.1 + std::sin(2 * pi * x[i]) / 3); }
        if (y[i] == 0 || y[i] == 1) { EXPECT_EQ(u[1][i], 0); }
    }
}

TEST(WallVelocity, divergenceInsideFallsWithTheLattice)
{
    std::vector<double> largest;
    std::vector<double> mean;
    for (const int intervals : {24, 48, 96})
    {
        BoundedRun run(unitBox(intervals, intervals, false), Fluid{.nu = 0.01},
                       boundedSettings(unitBox(intervals, intervals, false)), channelWalls({}));
        run.start(vortices);
        const double h = 1.0 / intervals;
        run.march(0.2, static_cast<int>(std::ceil(0.2 / std::min(0.1 * h * h / run.fluid.nu, 0.15 * h))));
        const RealField& divergence = run.flow.divergence();
        const auto [x, y, z] = run.lattice.coordinates();
        double most = 0;
        double sum = 0;
        for (std::size_t i = 0; i < divergence.size(); ++i)
        {
            if (y[i] == 0 || y[i] == 1) { continue; }
            most = std::max(most, std::abs(divergence[0][i]));
            sum += divergence[0][i] * divergence[0][i];
        }
        largest.push_back(most);
        mean.push_back(std::sqrt(sum / static_cast<double>(divergence.size())));
        record("largest, N " + std::to_string(intervals), most);
        record("root mean square, N " + std::to_string(intervals), mean.back());
    }
    EXPECT_GE(observedOrder(mean[1], mean[2]), 3.5);
    EXPECT_LT(largest[2], largest[1]);
}
