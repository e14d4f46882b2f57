// Inlets, outlets, slip walls, prescribed pressures: what enters leaves, what is exact stays, what has left is gone.

#include "kernels/Gaussian.hpp"
#include "lattice/LatticeFace.hpp"
#include "support/boundedRun.hpp"
#include "support/record.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace isph;
using namespace isph::test;
using std::numbers::pi;

namespace
{

using Faces = std::array<std::array<FaceCondition, 2>, 3>;

FaceCondition outlet(PlaceAndTime p = nullptr, bool changes = false)
{
    FaceCondition face;
    face.patch = "outlet";
    face.velocity = VelocityCondition::outflow;
    face.pressure = PressureCondition::value;
    if (p) { face.p = std::make_unique<PlainFaceFunction>(std::move(p), changes); }
    return face;
}

FaceCondition slipWall()
{
    FaceCondition face = wallAtRest("slip");
    face.velocity = VelocityCondition::slip;
    return face;
}

Axis boundedAxis(char name, double extent, int intervals)
{
    return {.name = name, .extent = extent, .count = intervals + 1, .ends = Axis::Ends::bounded};
}

/// A channel of height 1 along x.
Lattice channel(int n, int length)
{
    return Lattice({boundedAxis('x', length, length * n), boundedAxis('y', 1, n), Axis{.name = 'z'}}, {});
}

double parabola(int c, double, double y, double, double) { return c == 0 ? 6 * y * (1 - y) : 0; }
double uniform(int c, double, double, double, double) { return c == 0 ? 1 : 0; }

FlowSettings gaussianSettings(const Lattice& lattice, int order, int degree = 4)
{
    FlowSettings settings = boundedSettings(lattice, degree);
    settings.kernel.kernel = std::make_unique<Gaussian>(order);
    settings.kernel.smoothingLength = 1.5;
    return settings;
}

/// A stable number of steps over a time.
int stepsOver(double time, const Lattice& lattice, double nu, double speed)
{
    const double h = lattice.axis(1).spacing();
    return static_cast<int>(std::ceil(time / std::min(0.1 * h * h / std::max(nu, 1e-9), 0.25 * h / speed)));
}

/// What leaves through a face, with its own data where it prescribes them.
double fluxThrough(const BoundedRun& run, const RealField& U, int direction, Side side)
{
    const LatticeFace face(run.lattice, direction, side == Side::high);
    std::vector<double> normal(face.points());
    for (int d = 0; d < run.lattice.dimensions(); ++d)
    {
        if (run.lattice.direction(d) == direction) { face.values(U[d], normal); }
    }
    std::ranges::copy(run.boundary.normalVelocity(direction, side), normal.begin());
    double flux = 0;
    for (std::size_t n = 0; n < normal.size(); ++n) { flux += face.weights()[n] * normal[n]; }
    return face.outward() * flux;
}

double fluxThroughAll(BoundedRun& run)
{
    double sum = 0;
    for (int d = 0; d < run.lattice.dimensions(); ++d)
    {
        const int direction = run.lattice.direction(d);
        if (run.lattice.axis(direction).periodic()) { continue; }
        for (const Side side : {Side::low, Side::high})
        {
            sum += fluxThrough(run, run.flow.velocity(), direction, side);
        }
    }
    return sum;
}

double largestDifference(const RealField& a, const RealField& b)
{
    double largest = 0;
    for (int c = 0; c < a.components(); ++c)
    {
        for (std::size_t i = 0; i < a.size(); ++i) { largest = std::max(largest, std::abs(a[c][i] - b[c][i])); }
    }
    return largest;
}

RealField exact(const Lattice& lattice, const PlaceAndTime& U, double t)
{
    return fieldOf(lattice, lattice.dimensions(),
                   [&](int c, double x, double y, double z) { return U(c, x, y, z, t); });
}

} // namespace

TEST(InletOutlet, poiseuilleStaysExact)
{
    // An inlet in x or in y, from either end.
    for (const bool turned : {false, true})
    {
        for (const bool backwards : {false, true})
        {
            const double nu = 0.05;
            const double sign = backwards ? -1 : 1;
            const PlaceAndTime U = [=](int c, double x, double y, double, double)
            { return c == (turned ? 1 : 0) ? sign * parabola(0, 0, turned ? x : y, 0, 0) : 0; };
            const Axis along = boundedAxis(turned ? 'y' : 'x', 2, 32);
            const Axis across = boundedAxis(turned ? 'x' : 'y', 1, 16);
            const Lattice lattice({turned ? across : along, turned ? along : across, Axis{.name = 'z'}}, {});
            Faces faces;
            faces[turned ? 1 : 0][backwards ? 1 : 0] = movingWall("inlet", U, false);
            faces[turned ? 1 : 0][backwards ? 0 : 1] = outlet();
            faces[turned ? 0 : 1] = {wallAtRest("walls"), wallAtRest("walls")};
            BoundedRun run(lattice, Fluid{.nu = nu}, boundedSettings(lattice), std::move(faces));
            run.start([&](int c, double x, double y, double z) { return U(c, x, y, z, 0); });
            run.march(1, stepsOver(1, lattice, nu, 1.5));
            EXPECT_LT(largestDifference(run.flow.velocity(), exact(lattice, U, 0)), 1e-10);
            const RealField p = fieldOf(lattice, 1,
                                        [&](int, double x, double y, double)
                                        { return 12 * nu * (backwards ? (turned ? y : x) : 2 - (turned ? y : x)); });
            EXPECT_LT(largestDifference(run.flow.pressure(1), p), 2e-10);
        }
    }
}

TEST(InletOutlet, poiseuilleStaysUnderOtherTreatments)
{
    struct Case
    {
        WallTreatment walls;
        bool crankNicolson;
        double dt;
        double bound = 2e-9;
    };
    for (const Case& how :
         {Case{WallTreatment::paper, false, 0.005, 1e-3}, Case{WallTreatment::incremental, false, 0.005},
          Case{WallTreatment::rotational, false, 0.005}, Case{WallTreatment::pressurePoisson, false, 0.005},
          Case{WallTreatment::consistent, true, 0.03}})
    {
        const Lattice lattice = channel(16, 2);
        FlowSettings settings = boundedSettings(lattice);
        settings.walls = how.walls;
        settings.crankNicolson = how.crankNicolson;
        Faces faces;
        faces[0][0] = movingWall("inlet", parabola, false);
        faces[0][1] = outlet();
        faces[1] = {wallAtRest("walls"), wallAtRest("walls")};
        BoundedRun run(lattice, Fluid{.nu = 0.05}, std::move(settings), std::move(faces));
        run.start([](int c, double x, double y, double z) { return parabola(c, x, y, z, 0); });
        run.march(1.5, static_cast<int>(std::lround(1.5 / how.dt)));
        EXPECT_LT(largestDifference(run.flow.velocity(), exact(lattice, parabola, 0)), how.bound)
            << static_cast<int>(how.walls) << how.crankNicolson;
        EXPECT_NEAR(fluxThroughAll(run), 0, 1e-13);
    }
}

TEST(InletOutlet, uniformInflowDevelops)
{
    // From Stokes' flow to Re = 20; the length needed to develop grows with Re.
    for (const double Re : {1.0, 20.0})
    {
        const int n = 16;
        const Lattice lattice = channel(n, 3);
        Faces faces;
        faces[0][0] = movingWall("inlet", uniform, false);
        faces[0][1] = outlet();
        faces[1] = {wallAtRest("walls"), wallAtRest("walls")};
        BoundedRun run(lattice, Fluid{.nu = 1 / Re}, gaussianSettings(lattice, 8), std::move(faces));
        run.start([](int c, double x, double y, double z) { return uniform(c, x, y, z, 0); });
        EXPECT_NEAR(fluxThroughAll(run), 0, 1e-13) << "at the start";
        const double end = Re > 1 ? 4 : 0.8;
        run.march(end, stepsOver(end, lattice, 1 / Re, 1.5));
        EXPECT_NEAR(fluxThrough(run, run.flow.velocity(), 0, Side::low), -1, 1e-14);
        EXPECT_NEAR(fluxThrough(run, run.flow.velocity(), 0, Side::high), 1, 1e-13);
        double deviation = 0;
        for (int j = 0; j <= n; ++j)
        {
            const double y = lattice.axis(1).coordinate(j);
            const auto point = static_cast<std::size_t>(2 * n + (3 * n + 1) * j);
            deviation = std::max(deviation, std::abs(run.flow.velocity()[0][point] - 6 * y * (1 - y)));
        }
        record("profile, Re " + std::to_string(static_cast<int>(Re)), deviation / 1.5);
        EXPECT_LT(deviation / 1.5, 1e-3) << Re;
        const RealField& p = run.flow.pressure(end);
        const auto middle = static_cast<std::size_t>(2 * n + (3 * n + 1) * (n / 2));
        const double gradient = (p[0][middle + 1] - p[0][middle - 1]) * n / 2;
        record("gradient", gradient * Re / -12 - 1);
        EXPECT_NEAR(gradient * Re / -12, 1, 0.01) << Re;
    }
}

TEST(InletOutlet, pressuresAtBothEndsDriveAFlow)
{
    // From rest to the parabola of the pressure drop; nothing prescribes how much flows.
    const double nu = 0.2;
    const Lattice lattice = channel(16, 2);
    Faces faces;
    faces[0][0] = outlet([](int, double, double, double, double) { return 24 * 0.2; });
    faces[0][1] = outlet();
    faces[1] = {wallAtRest("walls"), wallAtRest("walls")};
    BoundedRun run(lattice, Fluid{.nu = nu}, boundedSettings(lattice), std::move(faces));
    run.start([](int, double, double, double) { return 0.0; });
    run.march(10, stepsOver(10, lattice, nu, 1.5));
    EXPECT_LT(largestDifference(run.flow.velocity(), exact(lattice, parabola, 0)), 1e-6);
    EXPECT_NEAR(fluxThroughAll(run), 0, 1e-13);
}

TEST(InletOutlet, inflowThatChangesInTime)
{
    // Poiseuille's flow of changing strength between slip walls is plug flow: p = -c'(t) (x - L).
    const Lattice lattice = channel(12, 2);
    const PlaceAndTime U = [](int c, double, double, double, double t)
    { return c == 0 ? 1 + 0.5 * std::sin(2 * t) : 0; };
    Faces faces;
    faces[0][0] = movingWall("inlet", U, true);
    faces[0][1] = outlet();
    faces[1] = {slipWall(), slipWall()};
    BoundedRun run(lattice, Fluid{.nu = 0.01}, boundedSettings(lattice), std::move(faces));
    run.start([](int c, double, double, double) { return uniform(c, 0, 0, 0, 0); });
    run.march(1, 100);
    EXPECT_LT(largestDifference(run.flow.velocity(), exact(lattice, U, 1)), 1e-10);
    EXPECT_LT(
        largestDifference(run.flow.pressure(1),
                          fieldOf(lattice, 1, [](int, double x, double, double) { return -std::cos(2) * (x - 2); })),
        1e-4);
}

TEST(InletOutlet, aVortexLeaves)
{
    // Also one that turns back the flow at the outlet. Nothing grows after it left; degree 3 and 4.
    struct Case
    {
        double speed;
        int n;
        double nu;
        int degree;
        double left;
    };
    for (const Case& vortex : {Case{0.5, 32, 0.001, 4, 3e-4}, Case{0.5, 32, 0.001, 3, 3e-4}, Case{0.5, 32, 0, 4, 5e-2},
                               Case{1.8, 48, 0.001, 4, 5e-3}})
    {
        const Lattice lattice = channel(vortex.n, 2);
        Faces faces;
        faces[0][0] = movingWall("inlet", uniform, false);
        faces[0][1] = outlet();
        faces[1] = {slipWall(), slipWall()};
        BoundedRun run(lattice, Fluid{.nu = vortex.nu}, gaussianSettings(lattice, 8, vortex.degree), std::move(faces));
        run.start(
            [&](int c, double x, double y, double)
            {
                const double a = 80;
                const double r2 = (x - 1) * (x - 1) + (y - 0.5) * (y - 0.5);
                const double f = vortex.speed * std::sqrt(2 * a) * std::exp(0.5 - a * r2);
                return c == 0 ? 1 - (y - 0.5) * f : (x - 1) * f;
            });
        const auto disturbance = [&] {
            return norm(run.flow.velocity()) > 0 ? largestDifference(run.flow.velocity(), exact(lattice, uniform, 0))
                                                 : 0;
        };
        const double before = disturbance();
        const int steps = stepsOver(1, lattice, vortex.nu, 1 + vortex.speed);
        double turnedBack = 1;
        for (int n = 1; n <= 20; ++n)
        {
            run.march(0.2 * n, steps / 5 + 1);
            for (int j = 0; j <= vortex.n; ++j)
            {
                const auto point = static_cast<std::size_t>(2 * vortex.n + (2 * vortex.n + 1) * j);
                turnedBack = std::min(turnedBack, run.flow.velocity()[0][point]);
            }
        }
        record("disturbance, speed " + std::to_string(vortex.speed), disturbance() / before);
        EXPECT_LT(disturbance() / before, vortex.left) << vortex.speed << " " << vortex.nu << " " << vortex.degree;
        EXPECT_NEAR(fluxThroughAll(run), 0, 1e-13);
        if (vortex.speed > 1) { EXPECT_LT(turnedBack, -0.2); }
    }
}

TEST(InletOutlet, outletsOnTwoSides)
{
    // In at the left, out at the right and at the top.
    const Lattice lattice = channel(16, 2);
    Faces faces;
    faces[0][0] = movingWall("inlet", parabola, false);
    faces[0][1] = outlet();
    faces[1] = {wallAtRest("floor"), outlet()};
    BoundedRun run(lattice, Fluid{.nu = 0.05}, gaussianSettings(lattice, 8, 3), std::move(faces));
    run.start([](int c, double x, double y, double z) { return parabola(c, x, y, z, 0); });
    run.march(2, stepsOver(2, lattice, 0.05, 2));
    EXPECT_NEAR(fluxThroughAll(run), 0, 1e-13);
    EXPECT_GT(fluxThrough(run, run.flow.velocity(), 1, Side::high), 0.2);
    EXPECT_LT(norm(run.flow.velocity()), 2 * norm(exact(lattice, parabola, 0)));
}

TEST(InletOutlet, aPorousWallBesideTheChannel)
{
    // Fluid is sucked off evenly by both walls, u = 1 - 2 s x, v = s (2 y - 1): exact between walls that slip along x,
    // and inviscid. p = p0 - (u^2 + v^2)/2 + ... = -(2 s^2 x^2 - 2 s x) - 2 s^2 (y - 1/2)^2.
    const double s = 0.1;
    const PlaceAndTime U = [s](int c, double x, double y, double, double)
    { return c == 0 ? 1 - 2 * s * x : s * (2 * y - 1); };
    const PlaceAndTime p = [s](int, double x, double y, double, double)
    { return 2 * s * x - 2 * s * s * x * x - 2 * s * s * (y - 0.5) * (y - 0.5); };
    const Lattice lattice = channel(16, 2);
    Faces faces;
    faces[0][0] = movingWall("inlet", U, false);
    faces[0][1] = outlet(p);
    faces[1] = {movingWall("lower", U, false), movingWall("upper", U, false)};
    BoundedRun run(lattice, Fluid{.nu = 0.01}, boundedSettings(lattice), std::move(faces));
    run.start([&](int c, double x, double y, double z) { return U(c, x, y, z, 0); });
    run.march(2, stepsOver(2, lattice, 0.01, 1));
    EXPECT_LT(largestDifference(run.flow.velocity(), exact(lattice, U, 0)), 1e-5);
    EXPECT_NEAR(fluxThroughAll(run), 0, 1e-13);
    EXPECT_LT(
        largestDifference(run.flow.pressure(2),
                          fieldOf(lattice, 1, [&](int c, double x, double y, double z) { return p(c, x, y, z, 0); })),
        1e-3);
}

TEST(InletOutlet, threeDimensions)
{
    // The flow of a square duct develops; as much leaves as enters.
    const int n = 10;
    const Lattice lattice({boundedAxis('x', 2, 2 * n), boundedAxis('y', 1, n), boundedAxis('z', 1, n)}, {});
    Faces faces;
    faces[0][0] = movingWall("inlet", uniform, false);
    faces[0][1] = outlet();
    faces[1] = {wallAtRest("walls"), wallAtRest("walls")};
    faces[2] = {wallAtRest("walls"), slipWall()};
    BoundedRun run(lattice, Fluid{.nu = 0.2}, gaussianSettings(lattice, 8), std::move(faces));
    run.start([](int c, double x, double y, double z) { return uniform(c, x, y, z, 0); });
    run.march(2, 500);
    EXPECT_NEAR(fluxThrough(run, run.flow.velocity(), 0, Side::low), -1, 1e-13);
    EXPECT_NEAR(fluxThroughAll(run), 0, 1e-13);
    // A duct 1 x 2 whose upper half is mirrored: the largest speed of the developed flow is 1.992 of the mean.
    double largest = 0;
    const auto section = static_cast<std::size_t>(2 * n - n / 2);
    for (std::size_t i = section; i < lattice.points(); i += static_cast<std::size_t>(2 * n + 1))
    {
        largest = std::max(largest, run.flow.velocity()[0][i]);
    }
    record("largest speed in the duct", largest);
    EXPECT_NEAR(largest, 1.992, 0.03);
}

TEST(SlipWalls, taylorGreenBetweenThem)
{
    // Free-slip sides of a cell of decaying vortices: the walls are mirrors, and the solution is exact.
    const double nu = 0.02;
    const PlaceAndTime U = [nu](int c, double x, double y, double, double t)
    {
        const double f = std::exp(-2 * nu * pi * pi * t);
        return c == 0 ? f * std::sin(pi * x) * std::cos(pi * y) : -f * std::cos(pi * x) * std::sin(pi * y);
    };
    std::vector<double> errors;
    for (const int n : {16, 32, 64})
    {
        const Lattice lattice = unitBox(n, n, true);
        Faces faces;
        faces[0] = {slipWall(), slipWall()};
        faces[1] = {slipWall(), slipWall()};
        BoundedRun run(lattice, Fluid{.nu = nu}, boundedSettings(lattice), std::move(faces));
        run.start([&](int c, double x, double y, double z) { return U(c, x, y, z, 0); });
        run.march(0.5, stepsOver(0.5, lattice, nu, 1));
        errors.push_back(relativeL2(run.flow.velocity(), exact(lattice, U, 0.5)));
        record("slip walls, N " + std::to_string(n), errors.back());
    }
    EXPECT_GT(std::log2(errors[0] / errors[1]), 3.5);
    EXPECT_GT(std::log2(errors[1] / errors[2]), 3.5);
    EXPECT_LT(errors[2], 1e-6);
}

TEST(PressureGradient, givenAtAWall)
{
    // Fluid under gravity at rest: the wall's pressure gradient is given in place of the one that keeps v = 0 there.
    const Lattice lattice = unitBox(8, 32, false);
    Fluid fluid{.nu = 0.01};
    fluid.bodyForce = std::make_unique<PlainForce>(lattice, [](int c, double, double y, double, double)
                                                   { return c == 1 ? -9.81 + y * y : 0; });
    Faces faces;
    faces[1] = {wallAtRest("floor"), wallAtRest("ceiling")};
    const auto prescribe = [&](FaceCondition& face, double slope)
    {
        face.pressure = PressureCondition::gradient;
        face.p =
            std::make_unique<PlainFaceFunction>([slope](int, double, double, double, double) { return slope; }, false);
    };
    prescribe(faces[1][0], 9.81);
    prescribe(faces[1][1], -8.81);
    BoundedRun run(lattice, std::move(fluid), boundedSettings(lattice), std::move(faces));
    run.start([](int, double, double, double) { return 0.0; });
    run.march(0.2, 40);
    EXPECT_LT(largestDifference(run.flow.velocity(), RealField(2, lattice.points())), 2e-3);
}
