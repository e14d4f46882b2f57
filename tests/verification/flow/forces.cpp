// Body forces and mean flows: docs/theory/periodic.md, sections 5 and 8, test T6.

#include "support/flowRun.hpp"
#include "support/record.hpp"

#include <array>
#include <vector>

using namespace isph;
using namespace isph::test;

namespace
{

/// A force given as a function of t, the component and x, y, z.
class ForceOf : public BodyForce
{
public:
    using Function = std::function<double(double t, int c, double x, double y, double z)>;

    ForceOf(const Lattice& lattice, Function function, bool changes = true)
        : coordinates_(lattice.coordinates()), function_(std::move(function)), changes_(changes)
    {
    }

    void evaluate(double t, RealField& force) const override
    {
        for (int c = 0; c < force.components(); ++c)
        {
            for (std::size_t i = 0; i < force.size(); ++i)
            {
                force[c][i] = function_(t, c, coordinates_[0][i], coordinates_[1][i], coordinates_[2][i]);
            }
        }
    }
    bool dependsOnTime() const override { return changes_; }

private:
    std::array<std::vector<double>, 3> coordinates_;
    Function function_;
    bool changes_;
};

Fluid forced(double nu, const Lattice& lattice, ForceOf::Function force, bool changes = true)
{
    return Fluid{.nu = nu, .bodyForce = std::make_unique<ForceOf>(lattice, std::move(force), changes)};
}

/// A vortex of changing strength A(t) that a changing mean flow W(t) carries to X(t), and the force that keeps it so;
/// the force also has a gradient, which the pressure takes.
struct DrivenVortex
{
    double nu = 0.01;
    TaylorGreen vortex{.nu = 0};

    static double A(double t) { return 1 + 0.5 * std::sin(2 * t); }
    static double slopeOfA(double t) { return std::cos(2 * t); }
    static double W(int c, double t) { return c == 0 ? 1 + std::sin(3 * t) : 0.5 - 0.5 * std::cos(2 * t); }
    static double slopeOfW(int c, double t) { return c == 0 ? 3 * std::cos(3 * t) : std::sin(2 * t); }
    static double X(int c, double t)
    {
        return c == 0 ? t + (1 - std::cos(3 * t)) / 3 : 0.5 * t - 0.25 * std::sin(2 * t);
    }

    double shape(int c, double t, double x, double y) const { return vortex.velocity(c, x - X(0, t), y - X(1, t), 0); }

    double velocity(int c, double t, double x, double y) const { return W(c, t) + A(t) * shape(c, t, x, y); }

    double pressure(double t, double x, double y) const
    {
        return A(t) * A(t) * vortex.pressure(x - X(0, t), y - X(1, t), 0) + potential(t, x, y);
    }

    static double potential(double t, double x, double y)
    {
        return 0.3 * std::cos(t) * std::sin(2 * pi * x) * std::cos(4 * pi * y);
    }

    double force(int c, double t, double x, double y) const
    {
        const double gradient = c == 0 ? 0.3 * std::cos(t) * 2 * pi * std::cos(2 * pi * x) * std::cos(4 * pi * y)
                                       : -0.3 * std::cos(t) * 4 * pi * std::sin(2 * pi * x) * std::sin(4 * pi * y);
        return slopeOfW(c, t) + (slopeOfA(t) + 8 * pi * pi * nu * A(t)) * shape(c, t, x, y) + gradient;
    }
};

struct Errors
{
    double velocity;
    double pressure;
    double mean; ///< of the mean velocity
};

Errors drivenVortexErrors(FlowSettings settings, int steps)
{
    const DrivenVortex exact;
    const Lattice lattice = unitSquare(24);
    FlowRun run(lattice,
                forced(exact.nu, lattice,
                       [exact](double t, int c, double x, double y, double) { return exact.force(c, t, x, y); }),
                std::move(settings));
    run.start([&](int c, double x, double y, double) { return exact.velocity(c, 0, x, y); });
    const double end = 0.5;
    run.march(end, steps);
    const RealField velocity =
        fieldOf(lattice, 2, [&](int c, double x, double y, double) { return exact.velocity(c, end, x, y); });
    const RealField pressure =
        fieldOf(lattice, 1, [&](int, double x, double y, double) { return exact.pressure(end, x, y); });
    double mean = 0;
    for (int c = 0; c < 2; ++c)
    {
        double sum = 0;
        for (const double u : run.flow.velocity()[c]) { sum += u / static_cast<double>(lattice.points()); }
        mean = std::max(mean, std::abs(sum - DrivenVortex::W(c, end)));
    }
    return {relativeL2(run.flow.velocity(), velocity), relativeL2WithoutMeans(run.flow.pressure(end), pressure), mean};
}

} // namespace

TEST(BodyForces, aConstantForceAcceleratesTheMeanExactly)
{
    for (const bool threeDimensional : {false, true})
    {
        for (const bool exactMeanFlow : {false, true})
        {
            for (const char* time : {"RK3", "firstOrderProjection"})
            {
                const Lattice lattice = threeDimensional ? unitCube(8) : unitSquare(8);
                const std::array<double, 3> force{0.5, -2, 0.25};
                FlowSettings settings = plainSettings(closedGaussian(10, 1.5), time);
                settings.exactMeanFlow = exactMeanFlow;
                settings.dealiasing = Dealiasing::twoThirds;
                FlowRun run(lattice,
                            forced(
                                0.01, lattice,
                                [force](double, int c, double, double, double)
                                { return force[static_cast<std::size_t>(c)]; },
                                false),
                            std::move(settings));
                run.start([](int c, double, double, double) { return 1.0 * c; });
                run.march(3, 60);
                const RealField exact =
                    fieldOf(lattice, lattice.dimensions(),
                            [&](int c, double, double, double) { return c + 3 * force[static_cast<std::size_t>(c)]; });
                EXPECT_LE(largestDifference(run.flow.velocity(), exact), 1e-13);
                EXPECT_LE(norm(run.flow.pressure(3)), 1e-12);
            }
        }
    }
}

TEST(BodyForces, aGradientOnlyMakesPressure)
{
    const Lattice lattice = unitSquare(16);
    FlowRun run(lattice,
                forced(0.01, lattice,
                       [](double t, int c, double x, double, double)
                       { return c == 0 ? std::cos(t) * std::cos(2 * pi * x) : 0.0; }),
                plainSettings(closedGaussian(4, 2)));
    run.start([](int, double, double, double) { return 0.0; });
    run.march(1, 10);
    EXPECT_LE(norm(run.flow.velocity()), 1e-15);
    const RealField exact = fieldOf(
        lattice, 1, [](int, double x, double, double) { return std::cos(1.0) * std::sin(2 * pi * x) / (2 * pi); });
    EXPECT_LE(relativeL2(run.flow.pressure(1), exact), 1e-14);
}

TEST(BodyForces, aDrivenVortexIsThirdOrderInTime)
{
    const std::vector<std::pair<const char*, std::function<FlowSettings()>>> variants{
        {"explicit", [] { return plainSettings(exactKernel()); }},
        {"integratingFactor", [] { return recommendedSettings(exactKernel()); }},
        {"exactMeanFlow",
         []
         {
             FlowSettings settings = recommendedSettings(exactKernel());
             settings.exactMeanFlow = true;
             return settings;
         }},
        {"rotational", []
         {
             FlowSettings settings = plainSettings(exactKernel());
             settings.convection = ConvectionForm::rotational;
             settings.exactMeanFlow = true;
             return settings;
         }}};
    for (const auto& [name, settings] : variants)
    {
        Errors before{};
        for (const int steps : {50, 100, 200, 400})
        {
            const Errors now = drivenVortexErrors(settings(), steps);
            // The mean feels the force alone, whatever carries it: the error of a quadrature.
            const double quadrature = 1.16036e-07 * std::pow(50.0 / steps, 3);
            EXPECT_NEAR(now.mean / quadrature, 1, 1e-3) << name << steps;
            if (steps > 100)
            {
                EXPECT_NEAR(std::log2(before.velocity / now.velocity), 3, 0.1) << name << steps;
                EXPECT_GE(std::log2(before.pressure / now.pressure), 2.9) << name << steps;
                record(std::string(name) + "_velocityOrder", std::log2(before.velocity / now.velocity));
                record(std::string(name) + "_pressureOrder", std::log2(before.pressure / now.pressure));
            }
            before = now;
        }
    }
}

TEST(BodyForces, kolmogorovFlowGrowsToItsSteadyState)
{
    // f = sin(4 pi y) along x: u = f/(nu k^2) (1 - exp(-nu k^2 t)), laminar for as long as nothing disturbs it.
    const double nu = 0.1;
    const double k2 = 16 * pi * pi;
    for (const bool integratingFactor : {false, true})
    {
        const Lattice lattice = unitSquare(16);
        FlowSettings settings = recommendedSettings(exactKernel());
        settings.integratingFactor = integratingFactor;
        FlowRun run(lattice,
                    forced(
                        nu, lattice,
                        [](double, int c, double, double y, double) { return c == 0 ? std::sin(4 * pi * y) : 0.0; },
                        false),
                    std::move(settings));
        run.start([](int, double, double, double) { return 0.0; });
        const auto exactAt = [&](double t)
        {
            return fieldOf(lattice, 2,
                           [&](int c, double, double y, double)
                           { return c == 0 ? -std::expm1(-nu * k2 * t) / (nu * k2) * std::sin(4 * pi * y) : 0.0; });
        };
        run.march(0.1, 50);
        const double onTheWay = relativeL2(run.flow.velocity(), exactAt(0.1));
        run.march(4, 2000);
        const double steady = relativeL2(run.flow.velocity(), exactAt(1e9));
        EXPECT_LE(onTheWay, 1e-5);
        // The explicit scheme rests where the rate is zero; an integrating factor rests where its quadrature does, off
        // by a part of (nu k^2 dt)^3.
        EXPECT_LE(steady, integratingFactor ? 1e-5 : 1e-14);
    }
}

TEST(MeanFlow, forcedFlowsAreGalileanInvariant)
{
    // The same flow in a frame that moves at (8, -4): after t = 0.5, 64 and -32 points further, the same field.
    const std::array<double, 2> frame{8, -4};
    const auto force = [](double t, int c, double x, double y)
    { return std::cos(2 * t + c) * std::sin(2 * pi * (c == 0 ? y : x) + 1) + 0.3 * std::cos(2 * pi * (x - y)); };
    const auto velocity = [](int c, double x, double y)
    {
        return c == 0 ? std::sin(2 * pi * y) + 0.4 * std::cos(2 * pi * (x + 2 * y))
                      : std::cos(2 * pi * x) - 0.2 * std::cos(2 * pi * (x + 2 * y));
    };
    const Lattice lattice = unitSquare(16);
    for (const ConvectionForm form : {ConvectionForm::divergence, ConvectionForm::rotational, ConvectionForm::advective,
                                      ConvectionForm::skewSymmetric})
    {
        const auto endIn = [&](const std::array<double, 2>& U)
        {
            FlowSettings settings = recommendedSettings(closedGaussian(10, 1.5));
            settings.convection = form;
            settings.exactMeanFlow = true;
            FlowRun run(lattice,
                        forced(0.01, lattice,
                               [&, U](double t, int c, double x, double y, double)
                               { return force(t, c, x - U[0] * t, y - U[1] * t); }),
                        std::move(settings));
            run.start([&](int c, double x, double y, double)
                      { return U[static_cast<std::size_t>(c)] + velocity(c, x, y); });
            run.march(0.5, 50);
            RealField end = copyOf(run.flow.velocity());
            for (int c = 0; c < 2; ++c)
            {
                for (double& u : end[c]) { u -= U[static_cast<std::size_t>(c)]; }
            }
            return std::pair{std::move(end), copyOf(run.flow.pressure(0.5))};
        };
        const auto [atRest, pressureAtRest] = endIn({0, 0});
        const auto [moving, pressureMoving] = endIn(frame);
        EXPECT_LE(relativeL2(moving, atRest), 1e-12) << convectionForms().nameOf(form);
        EXPECT_LE(relativeL2(pressureMoving, pressureAtRest), 1e-11) << convectionForms().nameOf(form);
        record(std::string(convectionForms().nameOf(form)), relativeL2(moving, atRest));
    }
}

TEST(MeanFlow, T6_hundredTimesTheVortexInThreeDimensions)
{
    // ABC flow carried at (100, 50, -75): mean Courant numbers 32 and 64.
    const std::array<double, 3> U{100, 50, -75};
    const double nu = 0.05;
    const auto shape = [](int c, double x, double y, double z)
    {
        return c == 0   ? std::sin(z) + 0.6 * std::cos(y)
               : c == 1 ? 0.8 * std::sin(x) + std::cos(z)
                        : 0.6 * std::sin(y) + 0.8 * std::cos(x);
    };
    for (const int steps : {16, 8})
    {
        const Lattice lattice = periodicBox({16, 16, 16}, {2 * pi, 2 * pi, 2 * pi});
        FlowSettings settings = recommendedSettings(exactKernel());
        settings.exactMeanFlow = true;
        FlowRun run(lattice, Fluid{.nu = nu}, std::move(settings));
        run.start([&](int c, double x, double y, double z)
                  { return U[static_cast<std::size_t>(c)] + shape(c, x, y, z); });
        const double end = 2;
        run.march(end, steps);
        RealField fluctuation = copyOf(run.flow.velocity());
        for (int c = 0; c < 3; ++c)
        {
            for (double& u : fluctuation[c]) { u -= U[static_cast<std::size_t>(c)]; }
        }
        const RealField exact =
            fieldOf(lattice, 3,
                    [&](int c, double x, double y, double z)
                    { return std::exp(-nu * end) * shape(c, x - U[0] * end, y - U[1] * end, z - U[2] * end); });
        EXPECT_LE(relativeL2(fluctuation, exact), 1e-12);
        record("error" + std::to_string(steps), relativeL2(fluctuation, exact));
    }
}
