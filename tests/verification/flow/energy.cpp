// What an inviscid flow keeps: docs/theory/periodic.md, section 7 and test E1.

#include "support/flowRun.hpp"
#include "support/record.hpp"

#include <vector>

using namespace isph;
using namespace isph::test;

namespace
{

/// A random smooth field of root mean square 1: wavenumbers up to 3 on each axis, with amplitudes as 1/k.
RealField smoothRandom(const Lattice& lattice)
{
    std::mt19937_64 engine(2024);
    std::uniform_real_distribution<double> uniform(-1, 1);
    struct Mode
    {
        int kx;
        int ky;
        double a;
        double b;
    };
    std::vector<Mode> modes;
    for (int kx = 0; kx <= 3; ++kx)
    {
        for (int ky = -3; ky <= 3; ++ky)
        {
            if (kx == 0 && ky <= 0) { continue; }
            const double amplitude = 1.0 / (kx * kx + ky * ky);
            modes.push_back({kx, ky, amplitude * uniform(engine), amplitude * uniform(engine)});
        }
    }
    // The velocity of a random stream function.
    RealField velocity = fieldOf(lattice, 2,
                                 [&](int c, double x, double y, double)
                                 {
                                     double sum = 0;
                                     for (const Mode& mode : modes)
                                     {
                                         const double phase = 2 * pi * (mode.kx * x + mode.ky * y);
                                         const double slope = mode.b * std::cos(phase) - mode.a * std::sin(phase);
                                         sum += (c == 0 ? mode.ky : -mode.kx) * slope;
                                     }
                                     return sum;
                                 });
    const double scale = std::sqrt(static_cast<double>(lattice.points())) / norm(velocity);
    for (int c = 0; c < 2; ++c)
    {
        for (double& u : velocity[c]) { u *= scale; }
    }
    return velocity;
}

/// (E - E0)/E0 at t = 1, at a Courant number of the largest initial speed.
double drift(FlowSettings settings, double courant)
{
    FlowRun run(unitSquare(32), Fluid{}, std::move(settings));
    run.flow.start(smoothRandom(run.lattice), true);
    const double before = kineticEnergy(run.flow.velocity());
    const double largest = run.statistics().maxSpeed;
    run.march(1, static_cast<int>(std::ceil(32 * largest / courant)));
    return kineticEnergy(run.flow.velocity()) / before - 1;
}

void expectThirdOrderDrift(const std::function<FlowSettings()>& settings, const std::string& what)
{
    const double coarse = std::abs(drift(settings(), 0.04));
    const double fine = std::abs(drift(settings(), 0.02));
    EXPECT_LE(fine, 1e-7) << what;
    EXPECT_GE(std::log2(coarse / fine), 2.8) << what;
    record(what + "_drift", fine);
    record(what + "_order", std::log2(coarse / fine));
}

} // namespace

TEST(Energy, E1_exactDerivativeDealiasedConservesInAnyForm)
{
    for (const ConvectionForm form : {ConvectionForm::divergence, ConvectionForm::rotational, ConvectionForm::advective,
                                      ConvectionForm::skewSymmetric})
    {
        expectThirdOrderDrift(
            [form]
            {
                FlowSettings settings = plainSettings(exactKernel());
                settings.convection = form;
                settings.dealiasing = Dealiasing::twoThirds;
                return settings;
            },
            std::string(convectionForms().nameOf(form)));
    }
}

TEST(Energy, E1_skewAndRotationalConserveWithAnyDerivative)
{
    const std::vector<std::pair<const char*, std::function<KernelSettings()>>> kernels{
        {"G4", [] { return closedGaussian(4, 2); }},
        {"G10", [] { return closedGaussian(10, 1.5); }},
        {"quintic", [] { return quinticSpline(1.5); }}};
    for (const auto& [name, kernel] : kernels)
    {
        for (const ConvectionForm form : {ConvectionForm::rotational, ConvectionForm::skewSymmetric})
        {
            expectThirdOrderDrift(
                [&]
                {
                    FlowSettings settings = plainSettings(kernel());
                    settings.convection = form;
                    return settings;
                },
                std::string(name) + std::string(convectionForms().nameOf(form)));
        }
    }
}

TEST(Energy, theOtherFormsDoNotWithASmoothedDerivative)
{
    // A drift that no shorter step reduces; 2/3 does not repair it.
    for (const ConvectionForm form : {ConvectionForm::divergence, ConvectionForm::advective})
    {
        const auto settings = [form]
        {
            FlowSettings result = plainSettings(closedGaussian(4, 2));
            result.convection = form;
            result.dealiasing = Dealiasing::twoThirds;
            return result;
        };
        const double coarse = drift(settings(), 0.2);
        const double fine = drift(settings(), 0.1);
        EXPECT_GE(std::abs(fine), 1e-4);
        EXPECT_NEAR(coarse / fine, 1, 0.1);
        record(std::string(convectionForms().nameOf(form)), fine);
    }
}

TEST(Energy, exactDerivativeDealiasedMakesAllFormsOne)
{
    std::vector<RealField> ends;
    for (const ConvectionForm form : {ConvectionForm::divergence, ConvectionForm::rotational, ConvectionForm::advective,
                                      ConvectionForm::skewSymmetric})
    {
        FlowSettings settings = plainSettings(exactKernel());
        settings.convection = form;
        settings.dealiasing = Dealiasing::twoThirds;
        FlowRun run(unitSquare(64), Fluid{}, std::move(settings));
        run.flow.start(smoothRandom(run.lattice), true);
        run.march(0.1, 40);
        ends.push_back(copyOf(run.flow.velocity()));
        EXPECT_LE(relativeL2(ends.back(), ends.front()), 1e-13) << convectionForms().nameOf(form);
    }
}
