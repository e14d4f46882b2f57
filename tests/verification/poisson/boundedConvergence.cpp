// Manufactured solutions: order 2 of the plain solve, order 4 with the source known at the walls of a channel.

#include "support/record.hpp"

#include "allocations.hpp"
#include "boundedBox.hpp"

#include <gtest/gtest.h>

namespace isph::test
{

namespace
{

const double twoPi = 2 * std::numbers::pi;

/// g(s) and its first three derivatives.
struct Smooth
{
    std::function<double(double)> value, first, second, third;
    Profile profile() const { return {value, first}; }
};

/// No symmetry at the walls, no mode, no harmonic function.
Smooth growing()
{
    return {[](double s) { return std::exp(s) * std::sin(1.3 * s + 0.4); },
            [](double s) { return std::exp(s) * (std::sin(1.3 * s + 0.4) + 1.3 * std::cos(1.3 * s + 0.4)); },
            [](double s) { return std::exp(s) * (-0.69 * std::sin(1.3 * s + 0.4) + 2.6 * std::cos(1.3 * s + 0.4)); },
            [](double s) { return std::exp(s) * (-4.07 * std::sin(1.3 * s + 0.4) + 1.703 * std::cos(1.3 * s + 0.4)); }};
}

/// cos(2 pi m x + 0.3) g(y) between walls at y = 0 and 1.
struct ChannelProblem
{
    int m;
    Smooth g = growing();

    double k() const { return twoPi * m; }
    double wave(double x) const { return std::cos(k() * x + 0.3); }

    Exact exact() const
    {
        const double wavenumber = k();
        const Profile along{[=](double x) { return std::cos(wavenumber * x + 0.3); },
                            [=](double x) { return -wavenumber * std::sin(wavenumber * x + 0.3); }};
        return product({along, g.profile(), constantProfile});
    }
    double source(double x, double y) const { return wave(x) * (g.second(y) - k() * k() * g.value(y)); }
    double sourceSlope(double x, double y) const { return wave(x) * (g.third(y) - k() * k() * g.first(y)); }
};

/// Error of a channel problem, plain or with the source known at the walls.
double channelError(const ChannelProblem& problem, AxisEnds ends, bool staggered, int n, bool closed)
{
    BoundedBox box({{periodicEnds, false, 8, 1}, {ends, staggered, n, 1}});
    const Exact exact = problem.exact();
    const auto walls = box.walls(exact);
    const auto source = box.field([&](double x, double y, double) { return problem.source(x, y); });
    RealField phi(1, box.lattice.points());
    if (closed)
    {
        const auto given = [&](End end) -> Scalar
        {
            if (end == End::neumann)
            {
                return [&](double x, double y, double) { return problem.sourceSlope(x, y); };
            }
            return [&](double x, double y, double) { return problem.source(x, y); };
        };
        const auto low = box.face(1, false, given(ends.low));
        const auto high = box.face(1, true, given(ends.high));
        box.poisson.solveClosed(source, walls.data(), {low, high}, phi);
    }
    else { box.poisson.solve(source, walls.data(), phi); }
    return box.error(phi, box.field(exact.value));
}

double order(double coarse, double fine) { return std::log2(coarse / fine); }

/// Manufactured box without symmetry: errors at n and 2 n.
std::pair<double, double> boxErrors(std::vector<BoxAxis> axes, const Exact& exact, const Scalar& laplacian, int n)
{
    std::array<double, 2> errors{};
    for (std::size_t i = 0; i < 2; ++i)
    {
        for (BoxAxis& axis : axes)
        {
            if (axis.ends.low != End::periodic) { axis.intervals = n << i; }
        }
        BoundedBox box(axes);
        RealField phi(1, box.lattice.points());
        const auto walls = box.walls(exact);
        box.poisson.solve(box.field(laplacian), walls.data(), phi);
        errors[i] = box.error(phi, box.field(exact.value));
    }
    return {errors[0], errors[1]};
}

} // namespace

TEST(BoundedPoissonConvergence, isSecondOrderAndFourthWithTheSourceAtTheWalls)
{
    Bounds bounds;
    // Also without a wave along the channel: there the conditions in y are all there is.
    for (const int m : {0, 1, 3})
    {
        for (const AxisEnds ends : wallEnds())
        {
            for (const bool staggered : {false, true})
            {
                SCOPED_TRACE(nameOf({ends, staggered}) + ", wave " + std::to_string(m));
                const ChannelProblem problem{m};
                const double coarse = channelError(problem, ends, staggered, 64, false);
                const double fine = channelError(problem, ends, staggered, 128, false);
                EXPECT_TRUE(bounds.near(order(coarse, fine), 2, 0.25));
                const double closedCoarse = channelError(problem, ends, staggered, 64, true);
                const double closedFine = channelError(problem, ends, staggered, 128, true);
                EXPECT_TRUE(bounds.atLeast(order(closedCoarse, closedFine), 3.85));
                EXPECT_TRUE(bounds.atMost(closedFine, 1e-2 * fine));
            }
        }
    }
}

TEST(BoundedPoissonConvergence, neumannProblemFallsAsMeasuredElsewhere)
{
    Bounds bounds;
    // One dimension, L2 at 16 ... 256 intervals: order 2 plain, 4 with the slopes of the source.
    const ChannelProblem problem{0};
    double plain = 0;
    double closed = 0;
    for (const int n : {16, 32, 64, 128, 256})
    {
        const double nextPlain = channelError(problem, neumannEnds, false, n, false);
        const double nextClosed = channelError(problem, neumannEnds, false, n, true);
        if (n > 16)
        {
            EXPECT_TRUE(bounds.near(order(plain, nextPlain), 2, 0.1)) << n;
            EXPECT_TRUE(bounds.near(order(closed, nextClosed), 4, 0.1)) << n;
        }
        plain = nextPlain;
        closed = nextClosed;
    }
    EXPECT_TRUE(bounds.atMost(plain, 1e-4));
    EXPECT_TRUE(bounds.atMost(closed, 1e-9));
}

TEST(BoundedPoissonConvergence, closureKeepsItsDigitsInLongAndThinChannels)
{
    // The polynomial over the fourth power of kappa would lose all digits where kappa is small.
    for (const AxisEnds ends : wallEnds())
    {
        for (const bool staggered : {false, true})
        {
            for (const double height : {0.001, 0.01, 100.0})
            {
                SCOPED_TRACE(nameOf({ends, staggered}) + ", height " + std::to_string(height));
                // phi = cos(2 pi x) q(y/H): a polynomial.
                const auto q = [=](double y) { return 1 + std::pow(y / height, 3); };
                const auto qSlope = [=](double y) { return 3 * y * y / std::pow(height, 3); };
                const auto source = [=](double x, double y, double)
                { return std::cos(twoPi * x) * (6 * y / std::pow(height, 3) - twoPi * twoPi * q(y)); };
                const auto sourceSlope = [=](double x, double y, double)
                { return std::cos(twoPi * x) * (6 / std::pow(height, 3) - twoPi * twoPi * qSlope(y)); };
                const Exact exact = product(
                    {Profile{[](double x) { return std::cos(twoPi * x); }, {}}, Profile{q, qSlope}, constantProfile});
                std::array<double, 2> errors{};
                for (std::size_t i = 0; i < 2; ++i)
                {
                    BoundedBox box({{periodicEnds, false, 8, 1}, {ends, staggered, 64 << i, height}});
                    const auto given = [&](End end) -> Scalar
                    { return end == End::neumann ? Scalar(sourceSlope) : Scalar(source); };
                    const auto low = box.face(1, false, given(ends.low));
                    const auto high = box.face(1, true, given(ends.high));
                    RealField phi(1, box.lattice.points());
                    const auto walls = box.walls(exact);
                    box.poisson.solveClosed(box.field(source), walls.data(), {low, high}, phi);
                    errors[i] = box.error(phi, box.field(exact.value));
                }
                // Neumann walls leave the mean of a thin channel to 1/(kappa H)^2. In a long one kappa dy is 5.
                const double roundOff = 1e-12 + 3e-15 / std::pow(twoPi * height, 2);
                EXPECT_LT(errors[1], height > 1 ? 2e-7 : roundOff);
            }
        }
    }
}

TEST(BoundedPoissonConvergence, isSecondOrderInBoxes)
{
    const Smooth g = growing();
    const Profile f{[](double s) { return std::sin(1.5 * s) + 0.3; }, [](double s) { return 1.5 * std::cos(1.5 * s); }};
    const Exact exact = product({f, g.profile(), constantProfile});
    const Scalar laplacian = [=](double x, double y, double)
    { return f.value(x) * g.second(y) - 2.25 * std::sin(1.5 * x) * g.value(y); };
    for (const AxisEnds x : wallEnds())
    {
        for (const AxisEnds y : wallEnds())
        {
            for (const bool staggered : {false, true})
            {
                const std::vector<BoxAxis> axes{{x, staggered, 0, 1}, {y, staggered, 0, 1}};
                SCOPED_TRACE(nameOf(axes[0]) + ", " + nameOf(axes[1]));
                const auto [coarse, fine] = boxErrors(axes, exact, laplacian, 32);
                const auto hasValues = [](AxisEnds ends)
                { return ends.low == End::dirichlet || ends.high == End::dirichlet; };
                // No staggered point knows the value at an edge.
                const bool first = staggered && hasValues(x) && hasValues(y);
                EXPECT_GT(order(coarse, fine), first ? 0.95 : 1.9);
                EXPECT_LT(fine, first ? 2e-3 : 1e-4);
            }
        }
    }
}

TEST(BoundedPoissonConvergence, isSecondOrderInDucts)
{
    // Ducts along x, walls in y and z; with an inlet and an outlet; with values on all sides.
    const Smooth g = growing();
    const Profile wave{[](double x) { return std::cos(twoPi * x); },
                       [](double x) { return -twoPi * std::sin(twoPi * x); }};
    const Profile f{[](double s) { return std::sin(1.5 * s) + 0.3; }, [](double s) { return 1.5 * std::cos(1.5 * s); }};
    const Exact exact = product({wave, f, g.profile()});
    const Scalar laplacian = [=](double x, double y, double z)
    {
        return wave.value(x) *
               (f.value(y) * (g.second(z) - twoPi * twoPi * g.value(z)) - 2.25 * std::sin(1.5 * y) * g.value(z));
    };
    const std::vector<std::vector<BoxAxis>> ducts{
        {{periodicEnds, false, 8, 1}, {neumannEnds, false, 0, 1}, {neumannEnds, false, 0, 1}},
        {{periodicEnds, false, 8, 1}, {neumannEnds, true, 0, 1}, {dirichletEnds, true, 0, 1}},
        {{periodicEnds, false, 8, 1}, {dirichletEnds, false, 0, 1}, {neumannDirichlet, false, 0, 1}},
        {{periodicEnds, false, 8, 1}, {dirichletEnds, false, 0, 1}, {dirichletEnds, true, 0, 1}},
        {{neumannEnds, false, 0, 1}, {dirichletEnds, false, 0, 1}, {dirichletEnds, false, 0, 1}},
        {{dirichletEnds, false, 0, 1}, {dirichletEnds, false, 0, 1}, {dirichletEnds, false, 0, 1}},
        {{neumannDirichlet, false, 0, 1}, {neumannEnds, false, 0, 1}, {neumannEnds, false, 0, 1}},
        {{neumannDirichlet, true, 0, 1}, {neumannEnds, true, 0, 1}, {dirichletNeumann, true, 0, 1}}};
    for (const auto& axes : ducts)
    {
        SCOPED_TRACE(nameOf(axes[0]) + ", " + nameOf(axes[1]) + ", " + nameOf(axes[2]));
        const auto [coarse, fine] = boxErrors(axes, exact, laplacian, 16);
        // Order 2 from below: the series of the source at walls with values.
        EXPECT_GT(order(coarse, fine), 1.75);
        EXPECT_LT(fine, 5e-3);
    }
}

TEST(BoundedPoissonConvergence, allocatesNothingWhenSolving)
{
    for (const AxisEnds ends : wallEnds())
    {
        for (const bool staggered : {false, true})
        {
            BoundedBox box({{periodicEnds, false, 12, 1}, {ends, staggered, 40, 1}});
            const ChannelProblem problem{1};
            const auto walls = box.walls(problem.exact());
            const auto source = box.field([&](double x, double y, double) { return problem.source(x, y); });
            const auto low = box.face(1, false, problem.exact().value);
            RealField phi(1, box.lattice.points());
            const long before = allocations();
            box.poisson.solve(source, walls.data(), phi);
            box.poisson.solveClosed(source, walls.data(), {low, {}}, phi);
            EXPECT_EQ(allocations(), before);
        }
    }
}

} // namespace isph::test
