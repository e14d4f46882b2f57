// (alpha - beta lap) u = f where lap is the continued Laplacian itself: to round-off on every mix of ends, of fourth
// order against exact functions, and stable as a Crank-Nicolson term at any step.

#include "poisson/ContinuedHelmholtz.hpp"
#include "allocations.hpp"
#include "boundedBox.hpp"
#include "continuation/SmoothGram.hpp"
#include "operators/ContinuedOperators.hpp"
#include "schemes/TimeScheme.hpp"
#include "support/fields.hpp"
#include "support/kernels.hpp"
#include "support/messageOf.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>
#include <stdexcept>

namespace isph::test
{

namespace
{

constexpr double pi = std::numbers::pi;

Continuations continuationsOf(const Lattice& lattice, int degree = 4)
{
    Continuations result;
    for (std::size_t d = 0; d < 3; ++d)
    {
        const Axis& axis = lattice.axis(static_cast<int>(d));
        if (axis.active() && !axis.periodic())
        {
            result[d] = std::make_unique<SmoothGram>(automaticNewPoints(axis.count), degree);
        }
    }
    return result;
}

/// A box with its operators and what inverts them.
struct Continued
{
    explicit Continued(const std::vector<BoxAxis>& axes, int degree = 4)
        : box(axes),
          lattice(box.lattice),
          operators(lattice, continuationsOf(lattice, degree), exactKernel()),
          helmholtz(lattice, continuedAxes(lattice, continuationsOf(lattice, degree), exactKernel(), endsOf(axes)))
    {
    }

    static std::array<AxisEnds, 3> endsOf(const std::vector<BoxAxis>& axes)
    {
        std::array<AxisEnds, 3> ends;
        for (std::size_t d = 0; d < axes.size(); ++d) { ends[d] = axes[d].ends; }
        return ends;
    }

    /// Whether point i lies on no wall.
    bool inside(std::size_t point) const
    {
        for (int d = 0; d < 3; ++d)
        {
            const Axis& axis = lattice.axis(d);
            const LineLayout lines = linesAlong(lattice, d);
            const std::size_t index = point / lines.inner % lines.count;
            if (axis.active() && !axis.periodic() && (index == 0 || index + 1 == lines.count)) { return false; }
        }
        return true;
    }

    BoundedBox box;
    const Lattice& lattice;
    ContinuedOperators operators;
    ContinuedHelmholtz helmholtz;
};

/// Wall data at random, as many as the largest face has points.
struct RandomWalls
{
    explicit RandomWalls(const Lattice& lattice, unsigned seed) : values(noise(lattice, 1, seed))
    {
        std::size_t from = 0;
        for (int d = 0; d < lattice.dimensions(); ++d)
        {
            const std::size_t points = linesAlong(lattice, d).lines();
            data[static_cast<std::size_t>(d)] = {values[0].subspan(from, points), values[0].subspan(from + 1, points)};
            from += 2;
        }
    }

    RealField values;
    WallData data;
};

std::vector<std::vector<BoxAxis>> boxes()
{
    std::vector<std::vector<BoxAxis>> result;
    for (const AxisEnds& a : wallEnds())
    {
        result.push_back({{periodicEnds, false, 21, 1.3}, {a, false, 32, 1}});
        result.push_back({{a, false, 32, 1}, {periodicEnds, false, 16, 0.7}});
        for (const AxisEnds& b : wallEnds()) { result.push_back({{a, false, 27, 0.8}, {b, false, 32, 1}}); }
    }
    result.push_back({{periodicEnds, false, 12, 1}, {neumannEnds, false, 15, 1}, {dirichletEnds, false, 18, 1}});
    result.push_back({{neumannDirichlet, false, 15, 1}, {neumannEnds, false, 14, 1}, {neumannEnds, false, 16, 0.5}});
    return result;
}

std::string nameOf(const std::vector<BoxAxis>& axes)
{
    std::string name;
    for (const BoxAxis& axis : axes) { name += test::nameOf(axis) + " "; }
    return name;
}

} // namespace

TEST(ContinuedHelmholtz, invertsTheContinuedLaplacianItself)
{
    for (const auto& axes : boxes())
    {
        Continued box(axes);
        const Lattice& lattice = box.lattice;
        const RandomWalls walls(lattice, 1);
        const RealField f = noise(lattice, 1, 2);
        for (const auto& [alpha, beta] : {std::pair{1.0, 1e-4}, {1.0, 10.0}, {0.0, -1.0}, {2.0, 0.0}})
        {
            SCOPED_TRACE(nameOf(axes) + std::to_string(alpha) + " " + std::to_string(beta));
            RealField u(1, lattice.points());
            const double excess = box.helmholtz.solve(alpha, beta, f[0], walls.data, u[0]);
            RealField laplacian(1, lattice.points());
            box.operators.laplacian(u, laplacian);

            double size = 0;
            for (const double value : u[0]) { size = std::max(size, std::abs(value)); }
            double radius = 0;
            for (const BoxAxis& axis : axes) { radius += std::pow(pi * axis.intervals / axis.extent, 2); }
            const double tolerance = 1e-11 * (std::abs(alpha) + std::abs(beta) * radius) * size;
            double worst = 0;
            for (std::size_t i = 0; i < u.size(); ++i)
            {
                if (!box.inside(i)) { continue; }
                worst = std::max(worst, std::abs(alpha * u[0][i] - beta * laplacian[0][i] + excess - f[0][i]));
            }
            EXPECT_LE(worst, tolerance);
            if (alpha != 0 || !box.box.floating()) { EXPECT_EQ(excess, 0); }
        }
    }
}

TEST(ContinuedHelmholtz, isExactForSmoothResiduals)
{
    // On smooth fields round-off stays at the size of u times the largest eigenvalue.
    Continued box({{neumannEnds, false, 64, 1}, {dirichletEnds, false, 64, 1}});
    const RealField f = box.box.field([](double x, double y, double) { return std::exp(x) * std::sin(3 * y + 1); });
    RealField u(1, f.size());
    box.helmholtz.solve(1, 0.1, f[0], {}, u[0]);
    RealField laplacian(1, f.size());
    box.operators.laplacian(u, laplacian);
    double worst = 0;
    for (std::size_t i = 0; i < f.size(); ++i)
    {
        if (box.inside(i)) { worst = std::max(worst, std::abs(u[0][i] - 0.1 * laplacian[0][i] - f[0][i])); }
    }
    EXPECT_LE(worst, 1e-9);
}

TEST(ContinuedHelmholtz, keepsTheDataOfTheWalls)
{
    for (const auto& axes : boxes())
    {
        SCOPED_TRACE(nameOf(axes));
        Continued box(axes);
        const Lattice& lattice = box.lattice;
        const RandomWalls walls(lattice, 3);
        RealField u = noise(lattice, 1, 4);
        box.helmholtz.solve(1, 0.3, u[0], walls.data, u[0]); // in place
        for (int d = 0; d < lattice.dimensions(); ++d)
        {
            const AxisEnds ends = axes[static_cast<std::size_t>(d)].ends;
            if (ends.low == End::periodic) { continue; }
            const FaceValues& data = walls.data[static_cast<std::size_t>(d)];
            const LineLayout lines = linesAlong(lattice, d);
            RealField slope(1, lattice.points());
            box.operators.derivative(d)(u[0], slope[0], {});
            for (std::size_t line = 0; line < lines.lines(); ++line)
            {
                const std::size_t low = lines.start(line);
                const std::size_t high = low + (lines.count - 1) * lines.inner;
                // Edges belong to several faces: their inner points here.
                if (!box.inside(low + lines.inner)) { continue; }
                const auto check = [&](std::size_t point, End end, double datum)
                {
                    if (end == End::dirichlet) { EXPECT_EQ(u[0][point], datum); }
                    else { EXPECT_NEAR(slope[0][point], datum, 1e-6); }
                };
                check(low, ends.low, data.low[line]);
                check(high, ends.high, data.high[line]);
            }
        }
    }
}

TEST(ContinuedHelmholtz, writesValuesWhereTheyMeetSlopes)
{
    const Exact exact = product({Profile{[](double s) { return std::exp(s); }, [](double s) { return std::exp(s); }},
                                 Profile{[](double s) { return std::cos(s); }, [](double s) { return -std::sin(s); }},
                                 constantProfile}); // harmonic
    for (const AxisEnds& a : wallEnds())
    {
        for (const AxisEnds& b : wallEnds())
        {
            Continued box({{a, false, 48, 1}, {b, false, 48, 1}});
            SCOPED_TRACE(test::nameOf({a}) + test::nameOf({b}));
            const auto walls = box.box.walls(exact);
            RealField u(1, box.lattice.points());
            const RealField f(1, u.size());
            const double excess = box.helmholtz.solve(0, -1, f[0], walls.data(), u[0]);
            EXPECT_NEAR(excess, 0, 1e-6);
            EXPECT_LE(box.box.largestError(u, box.box.field(exact.value)), 1e-7); // corners, too
        }
    }
}

namespace
{

/// Error of lap phi = source, or of phi - lap phi, for a function without symmetry; slopes or values given.
double manufacturedError(int n, const AxisEnds& x, const AxisEnds& y, double alpha, double beta)
{
    const Profile growing{[](double s) { return std::exp(s) * std::sin(2.3 * s + 0.4); }, [](double s)
                          { return std::exp(s) * (std::sin(2.3 * s + 0.4) + 2.3 * std::cos(2.3 * s + 0.4)); }};
    const auto second = [](double s)
    { return std::exp(s) * (-4.29 * std::sin(2.3 * s + 0.4) + 4.6 * std::cos(2.3 * s + 0.4)); };
    const bool channel = x.low == End::periodic;
    const double k = 2 * pi;
    const Profile wave{[=](double s) { return std::cos(k * s + 0.3); },
                       [=](double s) { return -k * std::sin(k * s + 0.3); }};
    const Profile along = channel ? wave : growing;
    Continued box({{x, false, channel ? 16 : n, 1}, {y, false, n, 1}});
    const Exact exact = product({along, growing, constantProfile});
    const auto walls = box.box.walls(exact);
    const RealField f = box.box.field(
        [&](double sx, double sy, double)
        {
            const double alongX = channel ? -k * k * wave.value(sx) : second(sx);
            const double laplacian = alongX * growing.value(sy) + along.value(sx) * second(sy);
            return alpha * exact.value(sx, sy, 0) - beta * laplacian;
        });
    RealField u(1, f.size());
    box.helmholtz.solve(alpha, beta, f[0], walls.data(), u[0]);
    return box.box.error(u, box.box.field(exact.value));
}

} // namespace

TEST(ContinuedHelmholtz, isOfFourthOrder)
{
    const auto order = [](const AxisEnds& x, const AxisEnds& y, double alpha, double beta)
    {
        // Over two doublings: the number of new points differs between lattices, and the error jumps with it. With
        // degree 4 the error of a second derivative has a root mean square of order 3.5 where the largest are those at
        // walls.
        const double coarse = manufacturedError(32, x, y, alpha, beta);
        const double fine = manufacturedError(128, x, y, alpha, beta);
        EXPECT_LE(fine, 2.4e-7);
        return std::log2(coarse / fine) / 2;
    };
    for (const AxisEnds& x : {periodicEnds, neumannEnds, dirichletEnds, neumannDirichlet})
    {
        for (const AxisEnds& y : wallEnds())
        {
            SCOPED_TRACE(test::nameOf({x}) + test::nameOf({y}));
            EXPECT_GE(order(x, y, 0, -1), 3.5);
            EXPECT_GE(order(x, y, 1, 1), 3.5);
            EXPECT_GE(order(x, y, 1, 0.01), 3.5);
        }
    }
}

TEST(ContinuedHelmholtz, leavesFreeEndsToTheContinuation)
{
    // No slope at walls without a value: the continuation's own condition.
    const BoundedBox box({{periodicEnds, false, 8, 1}, {neumannEnds, false, 64, 1}});
    const LineContinuation line(SmoothGram(automaticNewPoints(65)), 65, EndCondition::neumann, EndCondition::neumann);
    std::vector<ContinuedAxis> axes(2);
    axes[0].symbol = lineSymbol(exactKernel(), 8, 1.0 / 8);
    axes[1] = {line, lineSymbol(exactKernel(), line.extendedPoints(), 1.0 / 64), LineEnd::free, LineEnd::free};
    ContinuedHelmholtz helmholtz(box.lattice, axes);
    EXPECT_LT(helmholtz.condition(), 3);
    const RealField f = box.field([](double, double y, double) { return (1 + pi * pi) * std::cos(pi * y); });
    RealField u(1, f.size());
    EXPECT_EQ(helmholtz.solve(1, 1, f[0], {}, u[0]), 0);
    EXPECT_LE(relativeL2(u, box.field([](double, double y, double) { return std::cos(pi * y); })), 1e-7);
}

TEST(ContinuedHelmholtz, reportsWhatTheSlopesCannotBalance)
{
    // A constant source and no flux through the walls: all of it is taken away.
    Continued box({{neumannEnds, false, 24, 1}, {periodicEnds, false, 12, 1}});
    RealField f(1, box.lattice.points());
    std::ranges::fill(f[0], 3.0);
    RealField u(1, f.size());
    EXPECT_NEAR(box.helmholtz.solve(0, -1, f[0], {}, u[0]), 3, 1e-10);
    EXPECT_LE(norm(u), 1e-10);
    // A flux in of 3 a length balances it.
    const std::vector<double> slopes(12, 3.0);
    EXPECT_NEAR(box.helmholtz.solve(0, -1, f[0], {FaceValues{{}, slopes}, {}, {}}, u[0]), 0, 1e-6);
    double mean = 0;
    const LineLayout lines = linesAlong(box.lattice, 0);
    for (std::size_t i = 0; i < u.size(); ++i)
    {
        const bool wall = i % lines.count == 0 || (i + 1) % lines.count == 0;
        mean += (wall ? 0.5 : 1) * u[0][i];
    }
    EXPECT_NEAR(mean, 0, 1e-12);
    // With alpha the constant is determined.
    EXPECT_EQ(box.helmholtz.solve(2, 1, f[0], {}, u[0]), 0);
    EXPECT_NEAR(u[0][5], 1.5, 1e-12);
}

TEST(ContinuedHelmholtz, isNotDisturbedByWhatStandsOnWalls)
{
    Continued box({{periodicEnds, false, 16, 1}, {dirichletEnds, false, 20, 1}});
    RealField f = noise(box.lattice, 1, 5);
    RealField u(1, f.size());
    box.helmholtz.solve(1, 1, f[0], {}, u[0]);
    for (std::size_t i = 0; i < f.size(); ++i)
    {
        if (!box.inside(i)) { f[0][i] = std::numeric_limits<double>::quiet_NaN(); }
    }
    RealField again(1, f.size());
    box.helmholtz.solve(1, 1, f[0], {}, again[0]);
    EXPECT_EQ(relativeL2(again, u), 0);
}

TEST(ContinuedHelmholtz, allocatesNothing)
{
    for (const auto& axes : boxes())
    {
        Continued box(axes);
        const RandomWalls walls(box.lattice, 6);
        const RealField f = noise(box.lattice, 1, 7);
        RealField u(1, f.size());
        const long before = allocations();
        box.helmholtz.solve(1, 0.1, f[0], walls.data, u[0]);
        box.helmholtz.solve(0, -1, f[0], walls.data, u[0]);
        EXPECT_EQ(allocations(), before);
    }
}

TEST(ContinuedHelmholtz, refusesWhatItCannotDo)
{
    const std::array<AxisEnds, 3> ends{periodicEnds, dirichletEnds, AxisEnds{}};
    const BoundedBox staggered({{periodicEnds, false, 16, 1}, {dirichletEnds, true, 32, 1}});
    EXPECT_EQ(
        messageOf([&] { continuedAxes(staggered.lattice, continuationsOf(staggered.lattice), exactKernel(), ends); }),
        "axis y is staggered: the direct solver needs points on its walls\n    leave staggered out, or choose "
        "another solver");
    const BoundedBox box({{periodicEnds, false, 16, 1}, {dirichletEnds, false, 32, 1}});
    EXPECT_THROW(continuedAxes(box.lattice, continuationsOf(box.lattice), exactKernel(), {}), std::logic_error);
    EXPECT_THROW(continuedAxes(box.lattice, {}, exactKernel(), ends), std::logic_error);
}

namespace
{

/// The largest growth of any step of the heat equation between walls at rest, marched from noise by Crank-Nicolson with
/// the weight of each substep of the third-order scheme.
double largestGrowth(const std::vector<BoxAxis>& axes, double number, int degree)
{
    Continued box(axes, degree);
    const double h = 1.0 / axes.back().intervals;
    const double nuDt = number * h * h;
    const TimeScheme& scheme = *timeSchemes()[Word{"RK3", {}}];
    RealField u = noise(box.lattice, 1, 8);
    for (std::size_t i = 0; i < u.size(); ++i)
    {
        if (!box.inside(i)) { u[0][i] = 0; }
    }
    RealField laplacian(1, u.size());
    double growth = 0;
    for (int step = 0; step < 100; ++step)
    {
        const double before = norm(u);
        for (const Substep& substep : scheme.substeps)
        {
            const double beta = 0.5 * substep.a * nuDt;
            box.operators.laplacian(u, laplacian);
            for (std::size_t i = 0; i < u.size(); ++i) { u[0][i] += beta * laplacian[0][i]; }
            box.helmholtz.solve(1, beta, u[0], {}, u[0]);
        }
        // The first steps may rearrange what is not quite orthogonal.
        if (step >= 20) { growth = std::max(growth, norm(u) / before); }
    }
    return growth;
}

} // namespace

TEST(CrankNicolson, isStableAtAnyStep)
{
    Bounds bounds;
    for (const int degree : {3, 4})
    {
        for (double number = 0.1; number < 2e6; number *= 10)
        {
            EXPECT_TRUE(bounds.atMost(
                largestGrowth({{periodicEnds, false, 8, 0.25}, {dirichletEnds, false, 32, 1}}, number, degree), 1))
                << number;
            EXPECT_TRUE(bounds.atMost(
                largestGrowth({{dirichletEnds, false, 32, 1}, {dirichletEnds, false, 32, 1}}, number, degree), 1))
                << number;
        }
    }
}

TEST(CrankNicolson, isOfSecondOrderInTime)
{
    Bounds bounds;
    // Decay of sin(pi y): exact in space to 1e-8.
    const auto error = [](int steps)
    {
        Continued box({{periodicEnds, false, 4, 1}, {dirichletEnds, false, 64, 1}});
        const auto mode = [](double, double y, double) { return std::sin(pi * y); };
        RealField u = box.box.field(mode);
        RealField laplacian(1, u.size());
        const double dt = 0.2 / steps;
        for (int step = 0; step < steps; ++step)
        {
            for (const Substep& substep : timeSchemes()[Word{"RK3", {}}]->substeps)
            {
                box.operators.laplacian(u, laplacian);
                for (std::size_t i = 0; i < u.size(); ++i) { u[0][i] += 0.5 * substep.a * dt * laplacian[0][i]; }
                box.helmholtz.solve(1, 0.5 * substep.a * dt, u[0], {}, u[0]);
            }
        }
        const double decay = std::exp(-0.2 * pi * pi);
        return box.box.error(u, box.box.field([&](double, double y, double) { return decay * std::sin(pi * y); }));
    };
    EXPECT_TRUE(bounds.near(std::log2(error(4) / error(8)), 2, 0.1));
    EXPECT_TRUE(bounds.atMost(error(16), 5e-4));
}

} // namespace isph::test
