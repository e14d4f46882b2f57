// The classical flow of neighbour sums against the spectral one with the same samples: equal to round-off.

#include "flow/PhysicalFlow.hpp"
#include "support/flowRun.hpp"
#include "support/record.hpp"

#include <vector>

using namespace isph;
using namespace isph::test;

namespace
{

/// A force that turns with time and is neither a gradient nor free of divergence.
class TurningForce : public BodyForce
{
public:
    explicit TurningForce(const Lattice& lattice) : coordinates_(lattice.coordinates()) {}

    void evaluate(double t, RealField& force) const override
    {
        for (int c = 0; c < force.components(); ++c)
        {
            for (std::size_t i = 0; i < force.size(); ++i)
            {
                force[c][i] =
                    std::cos(3 * t + c) * std::sin(2 * pi * (coordinates_[0][i] + coordinates_[1][i]) + c) + 0.1 * c;
            }
        }
    }
    bool dependsOnTime() const override { return true; }

private:
    std::array<std::vector<double>, 3> coordinates_;
};

struct Case
{
    ConvectionForm convection = ConvectionForm::divergence;
    Eigenvalues eigenvalues = Eigenvalues::consistent;
    LaplacianForm laplacian = LaplacianForm::morris;
    bool incremental = false;
    bool spline = true;
    double smoothingLength = 1.4;
    const char* time = "RK3";
    double nu = 0.01;
    bool force = false;
};

FlowSettings settingsOf(const Case& what)
{
    FlowSettings settings = plainSettings(
        what.spline ? quinticSpline(what.smoothingLength) : sampledGaussian(4, what.smoothingLength, 4), what.time);
    settings.convection = what.convection;
    settings.eigenvalues = what.eigenvalues;
    settings.laplacian = what.laplacian;
    settings.incremental = what.incremental;
    return settings;
}

/// Relative differences after six steps.
struct Difference
{
    double velocity;
    double pressure;
};

Difference difference(const Lattice& lattice, const Case& what)
{
    const auto fluid = [&]
    { return Fluid{.nu = what.nu, .bodyForce = what.force ? std::make_unique<TurningForce>(lattice) : nullptr}; };
    FlowSettings direct = settingsOf(what);
    direct.directSum = true;
    RunOf<PhysicalFlow> sums(lattice, fluid(), std::move(direct));
    RunOf<SpectralFlow> modes(lattice, fluid(), settingsOf(what));
    const auto velocity = [](int c, double x, double y, double z)
    {
        return 0.3 * c + std::sin(2 * pi * (c == 0 ? y : x)) + 0.4 * std::cos(2 * pi * (x + 2 * y) + c) +
               0.5 * std::sin(2 * pi * (z + x) + 2 * c);
    };
    const StartReport a = sums.start(velocity);
    const StartReport b = modes.start(velocity);
    EXPECT_EQ(a.projected, b.projected);
    for (int n = 0; n < 6; ++n)
    {
        // Steps of different lengths, as an adapted time step has them.
        sums.step(n % 2 == 0 ? 0.004 : 0.003);
        modes.step(n % 2 == 0 ? 0.004 : 0.003);
    }
    const double velocities = relativeL2(sums.flow.velocity(), modes.flow.velocity());
    const double pressures = relativeL2(sums.flow.pressure(sums.t), modes.flow.pressure(modes.t));
    EXPECT_NEAR(sums.flow.rates().viscous, modes.flow.rates().viscous, 1e-12 * modes.flow.rates().viscous);
    if (what.convection == ConvectionForm::none) { return {velocities, pressures}; }
    EXPECT_NEAR(sums.flow.rates().courant / modes.flow.rates().courant, 1, 1e-12);
    EXPECT_NEAR(sums.flow.rates().convective / modes.flow.rates().convective, 1, 1e-12);
    return {velocities, pressures};
}

// Sums of 100 to 250 terms leave a divergence of some 1e-16, and the projection divides it by |D|, which is 1e-3 of its
// largest near the corners of the spectrum: 1e-12. The pressure is quadratic in the velocity.
void expectEqual(const Difference& difference, const std::string& what)
{
    EXPECT_LE(difference.velocity, 1e-12) << what;
    EXPECT_LE(difference.pressure, 4e-12) << what;
}

std::vector<Case> everyCase()
{
    std::vector<Case> cases;
    for (const ConvectionForm form : {ConvectionForm::divergence, ConvectionForm::rotational, ConvectionForm::advective,
                                      ConvectionForm::skewSymmetric})
    {
        for (const Eigenvalues eigenvalues : {Eigenvalues::consistent, Eigenvalues::exact})
        {
            for (const bool incremental : {false, true})
            {
                cases.push_back({.convection = form, .eigenvalues = eigenvalues, .incremental = incremental});
            }
        }
    }
    cases.push_back({.eigenvalues = Eigenvalues::morris});
    cases.push_back({.eigenvalues = Eigenvalues::secondOrder});
    cases.push_back({.eigenvalues = Eigenvalues::fourthOrder});
    cases.push_back({.laplacian = LaplacianForm::secondDerivative});
    cases.push_back({.spline = false});
    cases.push_back({.spline = false, .time = "firstOrderProjection"});
    cases.push_back({.nu = 0});
    cases.push_back({.force = true});
    return cases;
}

std::string nameOf(const Case& what)
{
    return std::string(convectionForms().nameOf(what.convection)) + " " +
           std::string(eigenvalueForms().nameOf(what.eigenvalues)) + (what.incremental ? " incremental" : "") +
           (what.spline ? "" : " gaussian") + (what.force ? " force" : "") + " " + what.time;
}

} // namespace

TEST(DirectSum, marchesAsTheSpectralFlowDoesInTwoDimensions)
{
    double worst = 0;
    for (const Case& what : everyCase())
    {
        // dx = dy; dx != dy on odd counts; and a support of 4.2 points, wider than half of the last box.
        for (const Lattice& lattice :
             {unitSquare(20), periodicBox({15, 22, 1}, {1, 2, 0}), periodicBox({8, 7, 1}, {1, 1, 0})})
        {
            const Difference now = difference(lattice, what);
            expectEqual(now, nameOf(what));
            worst = std::max(worst, now.velocity);
        }
    }
    record("velocity", worst);
}

TEST(DirectSum, marchesAsTheSpectralFlowDoesInThreeDimensions)
{
    double worst = 0;
    for (Case what : everyCase())
    {
        what.smoothingLength = 1.1; // fewer neighbours
        const Difference now = difference(periodicBox({8, 9, 10}, {1, 1, 2}), what);
        expectEqual(now, nameOf(what));
        worst = std::max(worst, now.velocity);
    }
    record("velocity", worst);
}

TEST(DirectSum, stokesFlowToo)
{
    expectEqual(difference(unitSquare(20), {.convection = ConvectionForm::none, .force = true}), "none");
}
