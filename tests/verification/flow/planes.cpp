// An axis that is left out is left out: plane problems give the same bits in every plane.

#include "flow/PhysicalFlow.hpp"
#include "support/flowRun.hpp"

#include <array>
#include <gtest/gtest.h>
#include <vector>

using namespace isph;
using namespace isph::test;

namespace
{

/// nx x ny points of a box 1 x 2 in the plane of two directions.
Lattice plane(int first, int second)
{
    std::array<int, 3> counts{1, 1, 1};
    std::array<double, 3> extents{0, 0, 0};
    counts[static_cast<std::size_t>(first)] = 20;
    counts[static_cast<std::size_t>(second)] = 18;
    extents[static_cast<std::size_t>(first)] = 1;
    extents[static_cast<std::size_t>(second)] = 2;
    return periodicBox(counts, extents);
}

struct End
{
    RealField velocity;
    RealField pressure;
    RealField divergence;
    FlowStatistics statistics;
};

template<class Flow>
End endIn(int first, int second, FlowSettings settings)
{
    RunOf<Flow> run(plane(first, second), Fluid{.nu = 0.01}, std::move(settings));
    run.start(
        [&](int c, double x, double y, double z)
        {
            const std::array<double, 3> r{x, y, z};
            const double a = 2 * pi * r[static_cast<std::size_t>(first)];
            const double b = pi * r[static_cast<std::size_t>(second)];
            return c == 0 ? 0.3 + std::sin(b) + 0.2 * std::cos(2 * a + b) : std::sin(a) - 0.8 * std::cos(2 * a + b);
        });
    run.march(0.1, 10);
    return {copyOf(run.flow.velocity()), copyOf(run.flow.pressure(0.1)), copyOf(run.flow.divergence()),
            run.statistics()};
}

template<class Flow>
void expectSameInEveryPlane(const std::function<FlowSettings()>& settings)
{
    const End xy = endIn<Flow>(0, 1, settings());
    for (const auto& [first, second] : {std::pair{0, 2}, {1, 2}})
    {
        const End other = endIn<Flow>(first, second, settings());
        EXPECT_EQ(largestDifference(other.velocity, xy.velocity), 0);
        EXPECT_EQ(largestDifference(other.pressure, xy.pressure), 0);
        EXPECT_EQ(largestDifference(other.divergence, xy.divergence), 0);
        EXPECT_EQ(other.statistics.kineticEnergy, xy.statistics.kineticEnergy);
        EXPECT_EQ(other.statistics.enstrophy, xy.statistics.enstrophy);
        EXPECT_EQ(other.statistics.palinstrophy, xy.statistics.palinstrophy);
    }
}

} // namespace

TEST(Planes, spectralFlow)
{
    for (const ConvectionForm form : {ConvectionForm::divergence, ConvectionForm::rotational, ConvectionForm::advective,
                                      ConvectionForm::skewSymmetric, ConvectionForm::none})
    {
        expectSameInEveryPlane<SpectralFlow>(
            [form]
            {
                FlowSettings settings = recommendedSettings(closedGaussian(10, 1.5));
                settings.convection = form;
                settings.exactMeanFlow = true;
                settings.filter = exponentialFilter();
                return settings;
            });
    }
    expectSameInEveryPlane<SpectralFlow>(
        []
        {
            FlowSettings settings = plainSettings(quinticSpline(1.5));
            settings.eigenvalues = Eigenvalues::secondOrder;
            settings.incremental = true;
            return settings;
        });
}

TEST(Planes, neighbourSums)
{
    expectSameInEveryPlane<PhysicalFlow>(
        []
        {
            FlowSettings settings = plainSettings(quinticSpline(1.5));
            settings.directSum = true;
            return settings;
        });
}
