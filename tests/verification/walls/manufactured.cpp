// A manufactured flow with no-slip walls and a pressure whose wall slope does not vanish: psi = c(t) X(x) Y(y),
// u = X Y', v = -X' Y, in a channel (x periodic) and in a box; docs/theory/walls.md, section 5.

#include "support/boundedRun.hpp"
#include "support/record.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace isph;
using namespace isph::test;
using std::numbers::pi;

namespace
{

/// A function of one coordinate with three derivatives.
using Jet = std::array<double, 4>;

Jet sineSquared(double x)
{
    return {std::pow(std::sin(pi * x), 2), pi * std::sin(2 * pi * x), 2 * pi * pi * std::cos(2 * pi * x),
            -4 * pi * pi * pi * std::sin(2 * pi * x)};
}

struct Manufactured
{
    bool box;
    double nu = 0.01;

    static double c(double t) { return 1 + 0.5 * std::sin(0.7 * pi * t); }
    static double dc(double t) { return 0.35 * pi * std::cos(0.7 * pi * t); }

    Jet X(double x) const
    {
        const double k = 2 * pi;
        Jet jet =
            box ? sineSquared(x)
                : Jet{std::sin(k * x), k * std::cos(k * x), -k * k * std::sin(k * x), -k * k * k * std::cos(k * x)};
        for (double& value : jet) { value *= 0.15; }
        return jet;
    }

    double velocity(int component, double x, double y, double t) const
    {
        const Jet a = X(x);
        const Jet b = sineSquared(y);
        return c(t) * (component == 0 ? a[0] * b[1] : -a[1] * b[0]);
    }

    double pressure(double x, double y, double t) const
    {
        return 0.3 * c(t) * std::exp(y) * (box ? std::sin(1.5 * x) + 0.3 : std::cos(2 * pi * x));
    }

    double force(int component, double x, double y, double t) const
    {
        const Jet a = X(x);
        const Jet b = sineSquared(y);
        const double u = velocity(0, x, y, t);
        const double v = velocity(1, x, y, t);
        const double factor = 0.3 * c(t) * std::exp(y);
        if (component == 0)
        {
            const double slope = box ? 1.5 * std::cos(1.5 * x) : -2 * pi * std::sin(2 * pi * x);
            return dc(t) * a[0] * b[1] + c(t) * (u * a[1] * b[1] + v * a[0] * b[2]) + factor * slope -
                   nu * c(t) * (a[2] * b[1] + a[0] * b[3]);
        }
        return -dc(t) * a[1] * b[0] - c(t) * (u * a[2] * b[0] + v * a[1] * b[1]) + pressure(x, y, t) +
               nu * c(t) * (a[3] * b[0] + a[1] * b[2]);
    }
};

struct Errors
{
    double velocity;
    double pressure;
};

Errors errorsAt(bool box, int intervals, double end, WallTreatment walls = WallTreatment::consistent, int steps = 0,
                bool crankNicolson = false, double nu = 0.01, bool direct = false)
{
    const Manufactured flow{box, nu};
    const Lattice lattice = unitBox(intervals, intervals, box);
    Fluid fluid{.nu = flow.nu};
    fluid.bodyForce = std::make_unique<PlainForce>(lattice, [flow](int c, double x, double y, double, double t)
                                                   { return flow.force(c, x, y, t); });
    std::array<std::array<FaceCondition, 2>, 3> faces;
    if (box) { faces[0] = {wallAtRest("sides"), wallAtRest("sides")}; }
    faces[1] = {wallAtRest("walls"), wallAtRest("walls")};
    FlowSettings settings = boundedSettings(lattice);
    settings.walls = walls;
    settings.crankNicolson = crankNicolson;
    settings.directPressure = direct;
    BoundedRun run(lattice, std::move(fluid), std::move(settings), std::move(faces));
    run.start([flow](int c, double x, double y, double) { return flow.velocity(c, x, y, 0); }, false);
    const double h = 1.0 / intervals;
    run.march(end,
              steps > 0 ? steps : static_cast<int>(std::ceil(end / std::min(0.1 * h * h / flow.nu, 0.25 * h) - 1e-9)));

    const auto difference = [](const RealField& a, RealField b)
    {
        double sum = 0;
        double mean = 0;
        for (std::size_t i = 0; i < b.size(); ++i) { mean += (b[0][i] - a[0][i]) / static_cast<double>(b.size()); }
        for (int c = 0; c < b.components(); ++c)
        {
            for (std::size_t i = 0; i < b.size(); ++i)
            {
                sum += std::pow(b[c][i] - a[c][i] - (b.components() == 1 ? mean : 0), 2);
            }
        }
        // Root mean square over points and components.
        return std::sqrt(sum / static_cast<double>(b.size()) / b.components());
    };
    return {
        difference(run.flow.velocity(),
                   fieldOf(lattice, 2, [&](int c, double x, double y, double) { return flow.velocity(c, x, y, end); })),
        difference(run.flow.pressure(end),
                   fieldOf(lattice, 1, [&](int, double x, double y, double) { return flow.pressure(x, y, end); }))};
}

void checkOrder(bool box, double end, const std::array<double, 4>& bound)
{
    constexpr std::array<int, 4> intervals{24, 32, 48, 64};
    std::vector<double> errors;
    for (std::size_t i = 0; i < intervals.size(); ++i)
    {
        const Errors found = errorsAt(box, intervals[i], end);
        record("manufactured " + std::string(box ? "box" : "channel") + " N " + std::to_string(intervals[i]),
               found.velocity);
        record("pressure", found.pressure);
        EXPECT_LE(found.velocity, 1.2 * bound[i]) << intervals[i];
        errors.push_back(found.velocity);
    }
    EXPECT_GE(std::log(errors.front() / errors.back()) / std::log(64.0 / 24), 4.0);
}

} // namespace

TEST(BoundedManufactured, W7_channelConvergesInFourthOrder)
{
    checkOrder(false, 0.25, {3.9e-6, 1.2e-6, 1.8e-7, 4.7e-8});
}

TEST(BoundedManufactured, W6_boxConvergesInFourthOrder) { checkOrder(true, 0.5, {8.8e-6, 2.4e-6, 3.9e-7, 1.1e-7}); }

// What other treatments of walls reach (docs/theory/walls.md, section 4).
TEST(BoundedManufactured, wallsOfThePaperAreOfFirstOrderInTheirStep)
{
    // The step falls with the square of the spacing, so first order in time looks like second in space.
    const double coarse = errorsAt(true, 32, 0.5, WallTreatment::paper).velocity;
    const double fine = errorsAt(true, 64, 0.5, WallTreatment::paper).velocity;
    record("walls paper, box N 64", fine);
    EXPECT_NEAR(coarse, 5.2e-4, 0.1e-4);
    EXPECT_NEAR(fine, 1.6e-4, 0.1e-4);
}

TEST(BoundedManufactured, incrementsAreAsGoodOnSmoothFlow)
{
    for (const bool box : {false, true})
    {
        for (const WallTreatment walls : {WallTreatment::incremental, WallTreatment::rotational})
        {
            const double coarse = errorsAt(box, 32, 0.25, walls).velocity;
            const double fine = errorsAt(box, 64, 0.25, walls).velocity;
            EXPECT_LE(fine, 1e-6);
            EXPECT_GE(std::log2(coarse / fine), 2.5);
        }
    }
}

TEST(BoundedManufactured, presetSlipWorksInAChannelAndInABox)
{
    EXPECT_LE(errorsAt(false, 48, 0.25, WallTreatment::slip).velocity, 8e-7);
    const double box = errorsAt(true, 48, 0.5, WallTreatment::slip).velocity;
    record("slip, box", box);
    EXPECT_LE(box, 5e-7);
}

TEST(BoundedManufactured, pressurePoissonHasTheBestPressureInAChannel)
{
    const Errors found = errorsAt(false, 48, 0.25, WallTreatment::pressurePoisson);
    EXPECT_LE(found.velocity, 3e-7);
    EXPECT_LE(found.pressure, 2e-6);
}

// nu dt/h^2 from 51 down to 3, where the explicit term bears 0.13.
TEST(BoundedManufactured, crankNicolsonIsOfSecondOrderInLongSteps)
{
    for (const bool box : {false, true})
    {
        std::vector<double> errors;
        for (const int steps : {10, 20, 40, 80})
        {
            errors.push_back(errorsAt(box, 32, 0.5, WallTreatment::consistent, steps, true, 1).velocity);
        }
        record(box ? "Crank-Nicolson, box, 80 steps" : "Crank-Nicolson, channel, 80 steps", errors.back());
        EXPECT_LE(errors.back(), 2.5e-5);
        EXPECT_GE(std::log2(errors[1] / errors[3]) / 2, 1.8);
    }
}

// p { solver direct; }: what the pressure is to the continued operators themselves.
TEST(BoundedManufactured, directPressureIsOfHighOrder)
{
    constexpr std::array<int, 3> intervals{24, 32, 48};
    for (const bool box : {false, true})
    {
        std::vector<Errors> found;
        for (const int n : intervals)
        {
            found.push_back(errorsAt(box, n, 0.25, WallTreatment::consistent, 0, false, 0.01, true));
            const std::string name = std::string("direct, ") + (box ? "box" : "channel") + " N " + std::to_string(n);
            record(name, found.back().velocity);
            record(name + ", pressure", found.back().pressure);
        }
        const double decades = std::log(48.0 / 24);
        EXPECT_GE(std::log(found.front().velocity / found.back().velocity) / decades, 4.0);
        EXPECT_GE(std::log(found.front().pressure / found.back().pressure) / decades, 3.0);
        EXPECT_LE(found.back().velocity, 1e-6);
        EXPECT_LE(found.back().pressure, 5e-6);
    }
}
