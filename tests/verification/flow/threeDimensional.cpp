// Flows in three dimensions, and how many transforms a substep makes: docs/theory/periodic.md, section 9.

#include "support/flowRun.hpp"
#include "support/record.hpp"

#include <array>
#include <fstream>
#include <sstream>
#include <vector>

using namespace isph;
using namespace isph::test;

namespace
{

constexpr std::array<ConvectionForm, 4> everyForm{ConvectionForm::divergence, ConvectionForm::rotational,
                                                  ConvectionForm::advective, ConvectionForm::skewSymmetric};

Lattice cubeOf2Pi(int n) { return periodicBox({n, n, n}, {2 * pi, 2 * pi, 2 * pi}); }

/// Decaying ABC flow (exact solution 11): its curl is itself, so that its convective term is a gradient.
struct AbcFlow
{
    double A = 1;
    double B = 0.8;
    double C = 0.6;

    double velocity(int c, double x, double y, double z) const
    {
        return c == 0   ? A * std::sin(z) + C * std::cos(y)
               : c == 1 ? B * std::sin(x) + A * std::cos(z)
                        : C * std::sin(y) + B * std::cos(x);
    }
    double pressure(double x, double y, double z) const
    {
        double sum = 0;
        for (int c = 0; c < 3; ++c) { sum -= 0.5 * std::pow(velocity(c, x, y, z), 2); }
        return sum;
    }
};

struct Errors
{
    double velocity;
    double pressure;
};

Errors abcErrors(int n, double nu, double end, int steps, FlowSettings settings)
{
    const AbcFlow abc;
    FlowRun run(cubeOf2Pi(n), Fluid{.nu = nu}, std::move(settings));
    run.start([&](int c, double x, double y, double z) { return abc.velocity(c, x, y, z); });
    run.march(end, steps);
    const double decay = std::exp(-nu * end);
    const RealField velocity =
        fieldOf(run.lattice, 3, [&](int c, double x, double y, double z) { return decay * abc.velocity(c, x, y, z); });
    const RealField pressure = fieldOf(
        run.lattice, 1, [&](int, double x, double y, double z) { return decay * decay * abc.pressure(x, y, z); });
    return {relativeL2(run.flow.velocity(), velocity), relativeL2WithoutMeans(run.flow.pressure(end), pressure)};
}

/// A row of the reference: time, energy, dissipation, enstrophy.
struct Reference
{
    double t;
    double energy;
    double dissipation;
    double enstrophy;
};

std::vector<Reference> taylorGreenReference()
{
    std::ifstream file(TEST_DATA "/data/tgv3d_re1600_spectral.csv");
    std::vector<Reference> rows;
    std::string line;
    while (std::getline(file, line))
    {
        Reference row{};
        char comma = 0;
        std::istringstream text(line);
        if (text >> row.t >> comma >> row.energy >> comma >> row.dissipation >> comma >> row.enstrophy)
        {
            rows.push_back(row);
        }
    }
    return rows;
}

} // namespace

TEST(Beltrami, integratingFactorWithExactLaplacianLeavesRoundOff)
{
    // The convective term is a gradient in every form: with what the kernel does to one wavenumber it stays one.
    for (const ConvectionForm form : everyForm)
    {
        for (const int order : {0, 4})
        {
            FlowSettings settings = recommendedSettings(order == 0 ? exactKernel() : closedGaussian(order, 2));
            settings.convection = form;
            settings.laplacian = LaplacianForm::exact;
            const Errors errors = abcErrors(16, 0.1, 2, 40, std::move(settings));
            EXPECT_LE(errors.velocity, 1e-13) << convectionForms().nameOf(form) << order;
            EXPECT_LE(errors.pressure, 1e-13) << convectionForms().nameOf(form) << order;
            record(std::string(convectionForms().nameOf(form)) + std::to_string(order), errors.velocity);
        }
    }
}

TEST(Beltrami, smoothedLaplacianDecaysAsItsSymbol)
{
    const double s = std::pow(2 * 2 * pi / 16, 2) / 4;
    const double expected = std::expm1(0.1 * 2 * (1 - Gaussian(4).morrisSymbol(s)));
    EXPECT_NEAR(abcErrors(16, 0.1, 2, 40, recommendedSettings(closedGaussian(4, 2))).velocity, expected, 1e-13);
}

TEST(Beltrami, explicitViscosityIsThirdOrder)
{
    double before = 0;
    for (const int steps : {20, 40, 80})
    {
        const double now = abcErrors(8, 0.5, 2, steps, plainSettings(exactKernel())).velocity;
        // RK3 multiplies by 1 - z + z^2/2 - z^3/6 instead of exp(-z).
        const double z = 0.5 * 2 / steps;
        const double factor = 1 - z + z * z / 2 - z * z * z / 6;
        EXPECT_NEAR(now, std::abs(std::pow(factor, steps) / std::exp(-1) - 1), 1e-13);
        if (before > 0) { EXPECT_NEAR(std::log2(before / now), 3, 0.05); }
        before = now;
    }
}

TEST(TaylorGreen3D, energyAndDissipationToTimeOne)
{
    // Re 1600; the reference is a spectral run on 512^3. Dissipation is -dE/dt of the flow, and 2 nu times the
    // enstrophy.
    FlowRun run(cubeOf2Pi(32), Fluid{.nu = 1.0 / 1600}, recommendedSettings(closedGaussian(10, 1.5)));
    run.start(
        [](int c, double x, double y, double z) {
            return c == 0   ? std::sin(x) * std::cos(y) * std::cos(z)
                   : c == 1 ? -std::cos(x) * std::sin(y) * std::cos(z)
                            : 0.0;
        });
    const double volume = std::pow(2 * pi, 3);
    double worstEnergy = 0;
    double worstDissipation = 0;
    int compared = 0;
    for (const Reference& reference : taylorGreenReference())
    {
        if (reference.t > 1 + 1e-9) { break; }
        if (reference.t > run.t)
        {
            run.march(reference.t, static_cast<int>(std::ceil((reference.t - run.t) / 0.05 - 1e-9)));
        }
        const FlowStatistics now = run.statistics();
        const double energy = std::abs(now.kineticEnergy / volume / reference.energy - 1);
        const double dissipation = std::abs(now.enstrophy / volume / reference.enstrophy - 1);
        worstEnergy = std::max(worstEnergy, energy);
        worstDissipation = std::max(worstDissipation, dissipation);
        ++compared;
    }
    EXPECT_GE(compared, 5);
    EXPECT_LE(worstEnergy, 2e-6);
    EXPECT_LE(worstDissipation, 1e-5);
    record("energy", worstEnergy);
    record("dissipation", worstDissipation);
}

TEST(Transforms, perSubstepAsTheTheoryCounts)
{
    struct Row
    {
        ConvectionForm form;
        long in2D;
        long in3D;
    };
    for (const Row& row : {Row{ConvectionForm::divergence, 4, 8}, Row{ConvectionForm::rotational, 5, 9},
                           Row{ConvectionForm::advective, 7, 14}, Row{ConvectionForm::skewSymmetric, 9, 19},
                           Row{ConvectionForm::none, 0, 0}})
    {
        for (const bool threeDimensional : {false, true})
        {
            for (const char* time : {"RK3", "firstOrderProjection"})
            {
                FlowSettings settings = plainSettings(closedGaussian(10, 1.5), time);
                settings.convection = row.form;
                settings.dealiasing = Dealiasing::twoThirds;
                settings.filter = exponentialFilter();
                FlowRun run(threeDimensional ? unitCube(8) : unitSquare(8), Fluid{.nu = 0.01}, std::move(settings));
                run.flow.start(noise(run.lattice, run.lattice.dimensions(), 1), true);
                // What chooses the step, and what is asked after it, needs no transform beside those of the substeps.
                run.flow.rates();
                const long before = run.flow.transforms();
                for (int n = 0; n < 10; ++n)
                {
                    run.step(0.001);
                    run.flow.rates();
                }
                const auto substeps = 10 * static_cast<long>(run.settings.time->substeps.size());
                EXPECT_EQ(run.flow.transforms() - before, substeps * (threeDimensional ? row.in3D : row.in2D))
                    << convectionForms().nameOf(row.form) << " " << time;
            }
        }
    }
}

TEST(Transforms, mismatchedEigenvaluesNeedEveryGradient)
{
    // D.u is not zero then: no diagonal gradient follows from the others.
    FlowSettings settings = plainSettings(closedGaussian(4, 2));
    settings.convection = ConvectionForm::advective;
    settings.eigenvalues = Eigenvalues::exact;
    FlowRun run(unitSquare(8), Fluid{.nu = 0.01}, std::move(settings));
    run.flow.start(noise(run.lattice, 2, 1), true);
    run.flow.rates();
    const long before = run.flow.transforms();
    run.step(0.001);
    run.flow.rates();
    EXPECT_EQ(run.flow.transforms() - before, 3 * 8);
}
