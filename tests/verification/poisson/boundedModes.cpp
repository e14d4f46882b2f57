// What the solver must get to round-off: modes of the box, and harmonic functions from their wall data alone.

#include "boundedBox.hpp"

#include <gtest/gtest.h>
#include <stdexcept>

namespace isph::test
{

namespace
{

std::vector<BoxAxis> allAxes(int intervals, double extent)
{
    std::vector<BoxAxis> axes{{periodicEnds, false, intervals, extent}};
    for (const AxisEnds ends : wallEnds())
    {
        for (const bool staggered : {false, true}) { axes.push_back({ends, staggered, intervals, extent}); }
    }
    return axes;
}

/// The product of one mode of each axis, and minus its eigenvalue.
std::pair<Exact, double> modeOf(const std::vector<BoxAxis>& axes, const std::vector<int>& numbers)
{
    std::array<Profile, 3> profiles{constantProfile, constantProfile, constantProfile};
    double k2 = 0;
    for (std::size_t d = 0; d < axes.size(); ++d)
    {
        const AxisMode mode(axes[d], numbers[d]);
        profiles[d] = mode.profile;
        k2 += mode.k * mode.k;
    }
    return {product(profiles), k2};
}

/// Harmonic: wall layers along each bounded axis times modes of the others, added up.
Exact harmonicOf(const std::vector<BoxAxis>& axes, int number)
{
    Exact total =
        product({Profile{[](double) { return 0.0; }, [](double) { return 0.0; }}, constantProfile, constantProfile});
    for (std::size_t d = 0; d < axes.size(); ++d)
    {
        if (axes[d].ends.low == End::periodic) { continue; }
        std::array<Profile, 3> profiles{constantProfile, constantProfile, constantProfile};
        double kappa2 = 0;
        for (std::size_t other = 0; other < axes.size(); ++other)
        {
            if (other == d) { continue; }
            const AxisMode mode(axes[other], number);
            profiles[other] = mode.profile;
            kappa2 += mode.k * mode.k;
        }
        profiles[d] = wallLayers(std::sqrt(kappa2), axes[d].extent);
        total = sum(total, product(profiles));
    }
    return total;
}

double harmonicError(const std::vector<BoxAxis>& axes, int number)
{
    BoundedBox box(axes);
    return box.solved(harmonicOf(axes, number), [](double, double, double) { return 0.0; });
}

} // namespace

TEST(BoundedPoissonModes, areSolvedToRoundOffForAnyTwoKindsOfAxes)
{
    for (const BoxAxis& x : allAxes(8, 1.3))
    {
        for (const BoxAxis& y : allAxes(7, 0.4))
        {
            SCOPED_TRACE(nameOf(x) + ", " + nameOf(y));
            const auto [mode, k2] = modeOf({x, y}, {2, 3});
            BoundedBox box({x, y});
            EXPECT_LT(box.solved(mode, [&mode = mode, k2 = k2](double a, double b, double c)
                                 { return -k2 * mode.value(a, b, c); }),
                      3e-14);
        }
    }
}

TEST(BoundedPoissonModes, areSolvedToRoundOffInThreeDimensions)
{
    for (const BoxAxis& x : allAxes(6, 1))
    {
        for (const BoxAxis& y : allAxes(5, 2))
        {
            for (const BoxAxis& z : allAxes(7, 0.5))
            {
                if (x.staggered != y.staggered && y.staggered != z.staggered) { continue; }
                SCOPED_TRACE(nameOf(x) + ", " + nameOf(y) + ", " + nameOf(z));
                const auto [mode, k2] = modeOf({x, y, z}, {1, 2, 2});
                BoundedBox box({x, y, z});
                EXPECT_LT(box.solved(mode, [&mode = mode, k2 = k2](double a, double b, double c)
                                     { return -k2 * mode.value(a, b, c); }),
                          3e-14);
            }
        }
    }
}

TEST(BoundedPoissonHarmonics, followFromTheirWallDataInChannels)
{
    for (const BoxAxis& y : allAxes(12, 0.8))
    {
        if (y.ends.low == End::periodic) { continue; }
        for (const int number : {1, 3})
        {
            SCOPED_TRACE(nameOf(y));
            EXPECT_LT(harmonicError({{periodicEnds, false, 10, 1.5}, y}, number), 1e-13);
            EXPECT_LT(harmonicError({y, {periodicEnds, false, 9, 1.5}}, number), 1e-13);
        }
    }
}

TEST(BoundedPoissonHarmonics, followFromTheirWallDataInBoxesWithCorners)
{
    for (const BoxAxis& x : allAxes(8, 1.2))
    {
        for (const BoxAxis& y : allAxes(9, 0.7))
        {
            SCOPED_TRACE(nameOf(x) + ", " + nameOf(y));
            if (x.ends.low == End::periodic && y.ends.low == End::periodic) { continue; }
            EXPECT_LT(harmonicError({x, y}, 2), 1e-13);
        }
    }
}

TEST(BoundedPoissonHarmonics, followFromTheirWallDataInThreeDimensions)
{
    for (const AxisEnds y : wallEnds())
    {
        for (const AxisEnds z : wallEnds())
        {
            for (const bool staggered : {false, true})
            {
                const BoxAxis wallsY{y, staggered, 6, 1};
                const BoxAxis wallsZ{z, staggered, 7, 1.5};
                SCOPED_TRACE(nameOf(wallsY) + ", " + nameOf(wallsZ));
                EXPECT_LT(harmonicError({{periodicEnds, false, 8, 2}, wallsY, wallsZ}, 1), 1e-13);
                EXPECT_LT(harmonicError({wallsZ, wallsY, {neumannDirichlet, staggered, 5, 0.8}}, 1), 1e-13);
            }
        }
    }
}

TEST(BoundedPoissonHarmonics, neitherOverflowNorLoseDigitsInThinOrLongBoxes)
{
    for (const AxisEnds ends : wallEnds())
    {
        for (const bool staggered : {false, true})
        {
            SCOPED_TRACE(nameOf({ends, staggered}));
            // kappa times the height: 0.06 to 2e6; kappa dy up to 3e4, where a cosh would overflow.
            for (const double aspect : {0.01, 0.1, 100.0, 1e4})
            {
                const BoxAxis along{periodicEnds, false, 64, 1};
                for (const int number : {1, 5, 31})
                {
                    // Round-off of slopes of size kappa leaks into the mean mode, which makes a profile of it, and
                    // into the first mode, whose mean over a thin channel it shifts.
                    const double kappa = 2 * std::numbers::pi * number;
                    const double condition = kappa * aspect + kappa / (std::pow(2 * std::numbers::pi, 2) * aspect);
                    EXPECT_LT(harmonicError({along, {ends, staggered, 64, aspect}}, number), 3e-13 + 5e-15 * condition)
                        << "height " << aspect << ", mode " << number;
                }
            }
        }
    }
}

TEST(BoundedPoissonHarmonics, meanFluxThroughNeumannWallsIsBalancedByAConstantSource)
{
    // phi = 0.3 y + y^2 in a box whose other walls are tight: lap phi = 2.
    for (const bool staggered : {false, true})
    {
        BoundedBox box({{neumannEnds, staggered, 6, 1}, {neumannEnds, staggered, 10, 0.5}});
        const auto value = [](double, double y, double) { return 0.3 * y + y * y; };
        const auto zero = [](double, double, double) { return 0.0; };
        const Exact exact{value, {zero, [](double, double y, double) { return 0.3 + 2 * y; }, zero}};
        const auto walls = box.walls(exact);
        RealField phi(1, box.lattice.points());
        EXPECT_NEAR(box.poisson.solve(box.field([](double, double, double) { return 2.0; }), walls.data(), phi), 0,
                    1e-14);
        EXPECT_LT(box.largestError(phi, box.field(value)), 1e-14);
        // What cannot be balanced is reported and taken out.
        EXPECT_NEAR(box.poisson.solve(box.field([](double, double, double) { return 5.0; }), walls.data(), phi), 3,
                    1e-14);
        EXPECT_LT(box.largestError(phi, box.field(value)), 1e-14);
    }
}

TEST(BoundedPoissonHarmonics, linearProfileBetweenFixedValues)
{
    for (const bool staggered : {false, true})
    {
        BoundedBox box({{periodicEnds, false, 6, 1}, {dirichletEnds, staggered, 10, 0.5}});
        const auto value = [](double, double y, double) { return 4 - 3 * y; };
        const Exact exact{value, {}};
        EXPECT_LT(box.solved(exact, [](double, double, double) { return 0.0; }), 1e-14);
    }
}

TEST(BoundedPoissonHarmonics, productsOfLinearProfilesFollowFromTheirValuesAtEdgesAndCorners)
{
    const auto linear = [](double a, double b) {
        return Profile{[=](double s) { return a + b * s; }, [=](double) { return b; }};
    };
    const Exact exact = product({linear(1, 2), linear(3, -1), linear(0.5, 1)});
    const auto zero = [](double, double, double) { return 0.0; };
    const BoxAxis x{dirichletEnds, false, 5, 1};
    const BoxAxis y{dirichletEnds, false, 6, 2};
    const BoxAxis z{dirichletEnds, false, 4, 0.5};
    EXPECT_LT(BoundedBox({x, y}).solved(exact, zero), 1e-14);
    EXPECT_LT(BoundedBox({x, y, z}).solved(exact, zero), 2e-14);

    const Exact flat = product({linear(1, 2), linear(3, -1), constantProfile});
    EXPECT_LT(BoundedBox({x, y, {neumannEnds, false, 4, 0.5}}).solved(flat, zero), 2e-14);
    EXPECT_LT(BoundedBox({x, y, {neumannEnds, true, 4, 0.5}}).solved(flat, zero), 2e-14);
    EXPECT_LT(BoundedBox({x, y, {neumannDirichlet, false, 4, 0.5}}).solved(flat, zero), 2e-14);
}

TEST(BoundedPoissonModes, ofAnotherSymbolInvertThatOperator)
{
    // Second differences of the solution are the source, to round-off.
    const auto differences = [](double k, double dx) { return std::pow(2 * std::sin(0.5 * k * dx) / dx, 2); };
    BoundedBox box({{periodicEnds, false, 8, 1}, {neumannEnds, false, 8, 1}}, differences);
    const auto source =
        box.field([](double x, double y, double)
                  { return std::sin(2 * std::numbers::pi * x) * (1 + y * y) + std::cos(std::numbers::pi * y); });
    RealField phi(1, box.lattice.points());
    box.poisson.solve(source, {}, phi);
    const auto at = [&](std::size_t i, std::size_t j) { return phi[0][(i + 8) % 8 + 8 * (j > 8 ? 16 - j : j)]; };
    for (std::size_t j = 1; j < 9; ++j)
    {
        for (std::size_t i = 0; i < 8; ++i)
        {
            const double laplacian = 64 * (at(i + 1, j) + at(i + 7, j) + at(i, j + 1) + at(i, j - 1) - 4 * at(i, j));
            EXPECT_NEAR(laplacian, source[0][i + 8 * j], 1e-13);
        }
    }
}

TEST(BoundedPoissonModes, refuseConditionsThatDoNotSuitTheAxis)
{
    const auto wrong = [](AxisEnds ends)
    {
        std::array<Axis, 3> axes;
        axes[0] = {.name = 'x', .extent = 1, .count = 4, .ends = Axis::Ends::bounded};
        axes[1] = {.name = 'y', .extent = 1, .count = 4};
        BoundedPoisson(Lattice(axes, {}), {ends, {}, {}});
    };
    EXPECT_NO_THROW(wrong(neumannEnds));
    EXPECT_THROW(wrong(periodicEnds), std::logic_error);
    EXPECT_THROW(wrong({End::periodic, End::neumann}), std::logic_error);
    EXPECT_THROW(wrong({End::dirichlet, End::periodic}), std::logic_error);
}

} // namespace isph::test
