#include "kernels/QuinticSpline.hpp"

#include "kernels/ExactKernel.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <stdexcept>

namespace isph
{
namespace
{

TEST(QuinticSpline, HasThePrintedValues)
{
    // Morris, Fox & Zhu 1997: 7/(478 pi) [(3-q)^5 - 6 (2-q)^5 + 15 (1-q)^5] in two dimensions.
    const QuinticSpline kernel;
    const double alpha = 7 / (478 * std::numbers::pi);
    // Round-off of terms up to 3^5.
    EXPECT_NEAR(kernel.w(0, 2), alpha * 66, 1e-15 * alpha * 243);
    EXPECT_NEAR(kernel.w(1, 2), alpha * 26, 1e-15 * alpha * 243);
    EXPECT_NEAR(kernel.w(2, 2), alpha, 1e-15 * alpha * 243);
    EXPECT_EQ(kernel.w(3, 2), 0);
    EXPECT_EQ(kernel.w(7, 2), 0);
    EXPECT_NEAR(kernel.w(0, 1), 66.0 / 120, 1e-15);
    EXPECT_NEAR(kernel.w(0, 3), 66 / (120 * std::numbers::pi), 1e-15);
    EXPECT_EQ(kernel.order(), 2);
    EXPECT_EQ(kernel.supportRadius(), 3);
    EXPECT_FALSE(kernel.closed());
}

TEST(QuinticSpline, HasTheDerivativesOfItsValues)
{
    const QuinticSpline kernel;
    constexpr double step = 1e-3;
    for (int d = 1; d <= 3; ++d)
    {
        const double scale = kernel.w(0, d);
        const auto derivative = [](auto function, double q)
        {
            return (8 * (function(q + step) - function(q - step)) - (function(q + 2 * step) - function(q - 2 * step))) /
                   (12 * step);
        };
        for (double q = 0.05; q < 3.2; q += 0.11)
        {
            // Truncation step^4/30 of the fifth derivative, 1200/66 of the value at most; round-off 1e-16/step.
            const double slope = derivative([&](double r) { return kernel.w(r, d); }, q);
            EXPECT_NEAR(q * kernel.f(q, d), slope, 3e-12 * scale) << "q " << q;
            const double slopeOfF = derivative([&](double r) { return kernel.f(r, d); }, q);
            EXPECT_NEAR(q * kernel.g(q, d), slopeOfF, 3e-11 * scale) << "q " << q; // f has one derivative less
        }
    }
}

TEST(QuinticSpline, QuotientsKeepTheirDigitsNearTheCentre)
{
    const QuinticSpline kernel;
    const double scale = kernel.w(0, 2) / 66;
    for (const double q : {0.0, 1e-12, 1e-6, 1e-4, 1e-3, 0.01, 0.1, 0.5, 0.999})
    {
        // From w = 66 - 60 q^2 + 30 q^4 - 10 q^5, exactly.
        EXPECT_NEAR(kernel.f(q, 2) / scale, -120 + 120 * q * q - 50 * q * q * q, 1e-13) << "q " << q;
        EXPECT_NEAR(kernel.g(q, 2) / scale, 240 - 150 * q, 1e-13) << "q " << q;
    }
    // Both sides of a knot, where the quotients change their form: w'' is continuous, to 1e-9 times the next
    // derivative.
    for (const double knot : {1.0, 2.0, 3.0})
    {
        EXPECT_NEAR(kernel.f(knot - 1e-9, 2), kernel.f(knot + 1e-9, 2), 1e-6 * scale);
        EXPECT_NEAR(kernel.g(knot - 1e-9, 2), kernel.g(knot + 1e-9, 2), 1e-6 * scale);
    }
}

TEST(QuinticSpline, HasNoClosedSymbol)
{
    EXPECT_THROW(QuinticSpline().symbol(1), std::logic_error);
    EXPECT_THROW(QuinticSpline().morrisSymbol(1), std::logic_error);
}

TEST(ExactKernel, IsTheLimitOfInfiniteOrder)
{
    const ExactKernel kernel;
    EXPECT_EQ(kernel.order(), 0);
    EXPECT_TRUE(kernel.closed());
    EXPECT_EQ(kernel.symbol(1e6), 1);
    EXPECT_EQ(kernel.morrisSymbol(1e6), 1);
    EXPECT_THROW(kernel.w(0, 2), std::logic_error);
    EXPECT_THROW(kernel.f(0, 2), std::logic_error);
    EXPECT_THROW(kernel.g(0, 2), std::logic_error);
}

} // namespace
} // namespace isph
