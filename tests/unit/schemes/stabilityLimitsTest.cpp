#include "schemes/stabilityLimits.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <limits>

namespace isph
{
namespace
{

using Complex = std::complex<double>;

const TimeScheme& rungeKutta3() { return *timeSchemes()[Word{"RK3", {}}]; }
const TimeScheme& forwardEuler() { return *timeSchemes()[Word{"firstOrderProjection", {}}]; }

/// |u after one step| for u' = z u, dt = 1, by the scheme's own coefficients.
double amplification(const TimeScheme& scheme, Complex z)
{
    Complex u = 1;
    Complex before = 0;
    for (const Substep& substep : scheme.substeps)
    {
        const Complex rate = z * u;
        u += substep.g * rate + substep.z * before;
        before = rate;
    }
    return std::abs(u);
}

constexpr double roundOff = 1e-14; // of an amplification of 1 in a dozen operations

TEST(StabilityLimits, EndTheRegionOnItsAxes)
{
    EXPECT_NEAR(rungeKutta3().imaginaryLimit, std::sqrt(3.0), 1e-15);
    EXPECT_NEAR(rungeKutta3().realLimit, 2.5127, 5e-5);
    for (const double share : {0.001, 0.1, 0.5, 0.9, 0.999, 1.0})
    {
        EXPECT_LE(amplification(rungeKutta3(), Complex(0, share * rungeKutta3().imaginaryLimit)), 1 + roundOff);
        EXPECT_LE(amplification(rungeKutta3(), -share * rungeKutta3().realLimit), 1 + roundOff);
        EXPECT_LE(amplification(forwardEuler(), -share * forwardEuler().realLimit), 1 + roundOff);
    }
    EXPECT_NEAR(amplification(rungeKutta3(), -rungeKutta3().realLimit), 1, roundOff) << "sharp";
    EXPECT_GT(amplification(rungeKutta3(), Complex(0, 1.001 * rungeKutta3().imaginaryLimit)), 1);
    EXPECT_GT(amplification(rungeKutta3(), -1.001 * rungeKutta3().realLimit), 1);
    EXPECT_GT(amplification(forwardEuler(), -1.001 * forwardEuler().realLimit), 1);
    EXPECT_EQ(forwardEuler().imaginaryLimit, 0);
    EXPECT_GT(amplification(forwardEuler(), Complex(0, 0.01)), 1);
}

TEST(StabilityLimits, TermsTogetherStayInTheRegionOfRungeKutta)
{
    // Every mode has |convective| and |viscous| rates up to the largest: the whole ellipse must be stable.
    for (double share = 0; share <= 1; share += 0.005)
    {
        for (const double radius : {0.1, 0.3, 0.5, 0.7, 0.9, 1.0})
        {
            const double angle = share * std::acos(-1.0) / 2;
            const StepRates rates{.convective = std::cos(angle), .viscous = std::sin(angle)};
            const double dt = radius * largestStableStep(rungeKutta3(), rates);
            EXPECT_LE(amplification(rungeKutta3(), dt * Complex(-rates.viscous, rates.convective)), 1 + roundOff)
                << "angle " << angle << ", radius " << radius;
        }
    }
}

TEST(StabilityLimits, AModeWithLessOfEitherRateIsStableToo)
{
    const StepRates rates{.convective = 3, .viscous = 5};
    const double dt = largestStableStep(rungeKutta3(), rates);
    for (double convective = 0; convective <= 1; convective += 0.05)
    {
        for (double viscous = 0; viscous <= 1; viscous += 0.05)
        {
            const Complex z = dt * Complex(-viscous * rates.viscous, convective * rates.convective);
            EXPECT_LE(amplification(rungeKutta3(), z), 1 + roundOff);
        }
    }
}

TEST(StabilityLimits, AreThoseOfOneTermAlone)
{
    EXPECT_DOUBLE_EQ(largestStableStep(rungeKutta3(), {.convective = 2}), std::sqrt(3.0) / 2);
    EXPECT_DOUBLE_EQ(largestStableStep(rungeKutta3(), {.viscous = 2}), rungeKutta3().realLimit / 2);
    EXPECT_DOUBLE_EQ(largestStableStep(forwardEuler(), {.viscous = 4}), 0.5);
    EXPECT_DOUBLE_EQ(largestStableStep(forwardEuler(), {.convective = 2, .unbalancedConvection = 8}), 0.25)
        << "dt <= 2 nu/|u|^2";
    EXPECT_EQ(largestStableStep(rungeKutta3(), {}), std::numeric_limits<double>::infinity());
    EXPECT_EQ(largestStableStep(forwardEuler(), {.viscous = 0}), std::numeric_limits<double>::infinity());
    EXPECT_EQ(largestStableStep(forwardEuler(),
                                {.viscous = 1, .unbalancedConvection = std::numeric_limits<double>::infinity()}),
              0)
        << "no viscosity, no stable step";
}

TEST(StabilityLimits, ForwardEulerIsStableWithItsTermsTogether)
{
    // Modes with convective rate |u| D and viscous rate nu L; any D^2/L up to its largest, any L up to its largest.
    for (const double u : {0.1, 1.0, 10.0})
    {
        for (const double nu : {0.01, 1.0})
        {
            constexpr double largestL = 50;
            constexpr double largestRatio = 1.3; // of D^2 over L
            const StepRates rates{.convective = u * std::sqrt(largestRatio * largestL),
                                  .viscous = nu * largestL,
                                  .unbalancedConvection = u * u * largestRatio / nu};
            const double dt = largestStableStep(forwardEuler(), rates);
            EXPECT_GT(dt, 0);
            double largest = 0;
            for (double l = 0.01; l <= largestL; l *= 1.02)
            {
                const Complex z = dt * Complex(-nu * l, u * std::sqrt(largestRatio * l));
                largest = std::max(largest, amplification(forwardEuler(), z));
            }
            EXPECT_LE(largest, 1 + roundOff) << "u " << u << ", nu " << nu;

            // Sharp: |1 + z|^2 = 1 - 2 dt nu l + (dt nu l)^2 + (dt u)^2 ratio l, at the largest l exactly 1.
            const Complex edge = 1.01 * dt * Complex(-nu * largestL, u * std::sqrt(largestRatio * largestL));
            EXPECT_GT(amplification(forwardEuler(), edge), 1) << "u " << u << ", nu " << nu;
        }
    }
}

TEST(StabilityMargin, TellsWhichTermRules)
{
    const StepRates rates{.convective = 2, .viscous = 1, .unbalancedConvection = 6};
    const StabilityMargin third = stabilityMargin(rungeKutta3(), rates, 0.5);
    EXPECT_DOUBLE_EQ(third.convective, 1 / std::sqrt(3.0));
    EXPECT_DOUBLE_EQ(third.viscous, 0.5 / rungeKutta3().realLimit);
    EXPECT_TRUE(third.convectionRules());
    const StabilityMargin first = stabilityMargin(forwardEuler(), rates, 0.5);
    EXPECT_DOUBLE_EQ(first.convective, 1.5);
    EXPECT_DOUBLE_EQ(first.viscous, 0.25);
    EXPECT_FALSE(stabilityMargin(rungeKutta3(), {.convective = 1, .viscous = 10}, 0.1).convectionRules());
}

} // namespace
} // namespace isph
