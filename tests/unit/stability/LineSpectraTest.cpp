#include "stability/LineSpectra.hpp"
#include "stability/sceneModes.hpp"
#include "stability/sceneSpectra.hpp"
#include "stability/trialFlows.hpp"
#include "support/boundedRun.hpp"

#include "continuation/Polynomial.hpp"
#include "kernels/Gaussian.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace isph
{

namespace
{

constexpr double pi = std::numbers::pi;

double largestReal(const LineSpectra::Spectrum& values)
{
    return std::ranges::max_element(values, {}, [](const auto& value) { return value.real(); })->real();
}

/// A channel with walls at y = 0 and 1, or a box with an inlet and an outlet.
std::array<std::array<FaceCondition, 2>, 3> facesOf(bool open)
{
    std::array<std::array<FaceCondition, 2>, 3> faces;
    faces[1] = {test::wallAtRest("floor"), test::wallAtRest("lid")};
    if (!open) { return faces; }
    faces[0][0] = test::wallAtRest("inlet");
    faces[0][1].patch = "outlet";
    faces[0][1].velocity = VelocityCondition::outflow;
    faces[0][1].pressure = PressureCondition::value;
    return faces;
}

struct Box
{
    Box(int x, int y, bool open, int degree = 4)
        : lattice(test::unitBox(x, y, open)),
          settings(test::boundedSettings(lattice, degree)),
          boundary(lattice, facesOf(open)),
          spectra(lattice, settings, boundary)
    {
    }

    Lattice lattice;
    FlowSettings settings;
    FlowBoundary boundary;
    LineSpectra spectra;
};

} // namespace

TEST(LineSpectra, ADiffusionBetweenWallsHasTheEigenvaluesOfSines)
{
    const Box box(8, 64, false);
    auto found = *box.spectra.diffusion(0, 1);
    ASSERT_EQ(found.size(), 63U);
    EXPECT_LT(largestReal(found), 0);
    EXPECT_NEAR(largestReal(found), -pi * pi, 1e-4);
}

TEST(LineSpectra, AlongPeriodicAxesThereAreTheSymbols)
{
    const Box box(8, 16, false);
    const auto carried = *box.spectra.convection(0, 0, 1);
    double largest = 0;
    for (const auto& value : carried)
    {
        EXPECT_EQ(value.real(), 0);
        largest = std::max(largest, value.imag());
    }
    EXPECT_NEAR(largest, 3 * 2 * pi, 1e-12) << "the Nyquist wavenumber of 8 points has no first derivative";
}

TEST(LineSpectra, FlowFromInletToOutletGrowsForHighDegreesOnly)
{
    // Removing the inlet's point leaves growth near round-off for degree 3, and a mode at the ends for degree 5.
    const Box low(64, 16, true, 3);
    const Box high(64, 16, true, 5);
    const double dx = 1.0 / 64;
    EXPECT_LT(largestReal(*low.spectra.convection(0, 0, 1)) * dx, 1e-3);
    EXPECT_GT(largestReal(*high.spectra.convection(0, 0, 1)) * dx, 5e-3);
}

TEST(LineSpectra, AnOutletHoldsNoValueAndAWallDoes)
{
    const Box box(16, 16, true);
    EXPECT_EQ(box.spectra.convection(0, 0, 1)->size(), 16U);
    EXPECT_EQ(box.spectra.convection(0, 1, 1)->size(), 15U);
}

TEST(LineSpectra, PolynomialsThroughFewPointsMakeViscosityGrow)
{
    Box box(8, 128, false);
    box.settings.kernel.kernel = std::make_unique<Gaussian>(4);
    box.settings.kernel.smoothingLength = 1.3;
    box.settings.continuations[1] = std::make_unique<Polynomial>(32, 5, 8, 2);
    EXPECT_GT(largestReal(*box.spectra.diffusion(0, 1)), 10);
    const auto spectra = sceneSpectra(box.lattice, {.nu = 0.1}, box.settings, box.boundary);
    const auto grows = std::ranges::find_if(spectra, [](const OperatorSpectrum& s) { return s.grows; });
    ASSERT_NE(grows, spectra.end());
    EXPECT_NE(grows->words.find("grow"), std::string::npos);
}

TEST(SceneModes, APeriodicBoxBearsWhatItsSymbolsSay)
{
    const Axis x{.name = 'x', .extent = 1, .count = 16};
    Axis y = x;
    y.name = 'y';
    const Lattice lattice({x, y, Axis{.name = 'z'}},
                          {{"sides", Patch::Type::periodic, {"xMin", "xMax", "yMin", "yMax"}}});
    FlowSettings settings;
    settings.kernel.kernel = std::make_unique<ExactKernel>();
    settings.time = timeSchemes()[Word{"RK3", {}}];
    settings.dealiasing = Dealiasing::none;
    settings.integratingFactor = false;
    settings.laplacian = LaplacianForm::exact;

    const auto carried = periodicModes(lattice, {}, settings, {2, 0, 0});
    EXPECT_NEAR(largestStableStep(*settings.time, carried), settings.time->imaginaryLimit / (2 * 7 * 2 * pi), 1e-6);
    const auto damped = periodicModes(lattice, {.nu = 0.3}, settings, {0, 0, 0});
    // Its Nyquist modes are kept but for the checkerboards.
    const double k2 = 4 * pi * pi * (64 + 49);
    EXPECT_NEAR(largestStableStep(*settings.time, damped), settings.time->realLimit / (0.3 * k2), 1e-6);

    settings.integratingFactor = true;
    EXPECT_TRUE(
        std::isinf(largestStableStep(*settings.time, periodicModes(lattice, {.nu = 0.3}, settings, {0, 0, 0}))));
}

TEST(TrialFlows, FindTheWayThroughABox)
{
    const Box channel(8, 16, false);
    const auto around = passageOf(channel.lattice, channel.boundary);
    ASSERT_TRUE(around);
    EXPECT_EQ(around->kind, Passage::Kind::around);
    EXPECT_EQ(around->d, 0);
    const Box open(16, 16, true);
    const auto through = passageOf(open.lattice, open.boundary);
    ASSERT_TRUE(through);
    EXPECT_EQ(through->kind, Passage::Kind::through);
    EXPECT_EQ(through->sign, 1);
}

TEST(TrialFlows, StretchingIsTheSlopeOfAShearFlow)
{
    const Lattice lattice = test::unitBox(8, 16, false);
    const RealField shear = fieldOf(lattice, [](int c, double, double y, double) { return c == 0 ? 3 * y : 0.0; });
    EXPECT_NEAR(largestStretching(lattice, shear), 3, 1e-12);
}

} // namespace isph
