#include "kernels/Gaussian.hpp"
#include "kernels/QuinticSpline.hpp"
#include "support/quadrature.hpp"
#include "support/record.hpp"

#include <array>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

using test::meanWave;
using test::radialIntegral;

constexpr std::array<int, 7> halfOrders{1, 2, 3, 4, 5, 10, 33};
constexpr std::array<double, 7> wavenumbers{0, 0.1, 0.7, 2, 5, 9, 14}; // times h; s = k^2/4 up to 49

TEST(GaussianTransform, IsTheClosedSymbolInAnyDimension)
{
    test::Bounds bounds;
    for (const int n : halfOrders)
    {
        const Gaussian kernel(2 * n);
        for (int d = 1; d <= 3; ++d)
        {
            for (const double k : wavenumbers)
            {
                const double transform =
                    radialIntegral(d, [&](double q) { return kernel.w(q, d) * meanWave(d, k * q); });
                // Round-off of a sum whose terms add up, in magnitude, to a few times its value of at most 1.
                EXPECT_TRUE(bounds.near(transform, kernel.symbol(k * k / 4), 1e-13))
                    << "order " << 2 * n << ", d " << d << ", k " << k;
            }
        }
    }
}

TEST(GaussianTransform, OfTheMorrisWeightIsTheClosedMorrisSymbol)
{
    test::Bounds bounds;
    // Morris: 2 integral of f (1 - mean wave) is the Laplacian's symbol, -k^2 morrisSymbol.
    for (const int n : halfOrders)
    {
        const Gaussian kernel(2 * n);
        for (int d = 1; d <= 3; ++d)
        {
            for (const double k : {0.7, 2.0, 5.0, 9.0, 14.0})
            {
                const double laplacian =
                    radialIntegral(d, [&](double q) { return 2 * kernel.f(q, d) * (1 - meanWave(d, k * q)); });
                // The terms are as large as the saturated symbol -4n: round-off of that, as above.
                EXPECT_TRUE(bounds.near(laplacian, -k * k * kernel.morrisSymbol(k * k / 4), 1e-13 * 4 * n))
                    << "order " << 2 * n << ", d " << d << ", k " << k;
            }
        }
    }
}

TEST(GaussianTransform, OfTheGradientAndTheLaplacianOfWFollowFromTheSymbol)
{
    // div grad W = d f + q^2 g; its transform is -k^2 symbol.
    for (const int n : halfOrders)
    {
        const Gaussian kernel(2 * n);
        for (int d = 1; d <= 3; ++d)
        {
            for (const double k : {0.0, 0.7, 2.0, 5.0, 9.0})
            {
                const double laplacian = radialIntegral(
                    d, [&](double q) { return (d * kernel.f(q, d) + q * q * kernel.g(q, d)) * meanWave(d, k * q); });
                // The terms reach the integral of |d f| and |q^2 g|, some 4n each times the oscillation of the
                // polynomial.
                EXPECT_NEAR(laplacian, -k * k * kernel.symbol(k * k / 4), 1e-13 * 40 * n)
                    << "order " << 2 * n << ", d " << d << ", k " << k;
            }
        }
    }
}

TEST(KernelMoments, OfGaussiansVanishUpToTheirOrder)
{
    for (const int n : {1, 2, 3, 4, 5, 10})
    {
        const Gaussian kernel(2 * n);
        for (int d = 1; d <= 3; ++d)
        {
            for (int m = 0; m <= n; ++m)
            {
                const auto moment = [&](auto value)
                { return radialIntegral(d, [&](double q) { return value(q) * std::pow(q, 2 * m); }); };
                const double w = moment([&](double q) { return kernel.w(q, d); });
                const double scale = moment([&](double q) { return std::abs(kernel.w(q, d)); });
                // Round-off of the terms of the sum.
                if (m == 0) { EXPECT_NEAR(w, 1, 1e-13 * scale); }
                else if (m < n) { EXPECT_NEAR(w, 0, 1e-13 * scale) << "order " << 2 * n << ", d " << d << ", m " << m; }
                else { EXPECT_GT(std::abs(w), 1e-2) << "order " << 2 * n << " is no higher order"; }

                // Gradient: the integral of -x_j dW/dx_j q^2m is (d + 2m)/d times that of w q^2m, by parts.
                const double slope = moment([&](double q) { return -q * q * kernel.f(q, d) / d; });
                EXPECT_NEAR(slope, (d + 2.0 * m) / d * w, 1e-13 * scale * (4 * n)) << "order " << 2 * n << ", d " << d;
            }
        }
    }
}

TEST(KernelMoments, OfTheQuinticSplineAreThoseOfASecondOrderKernel)
{
    const QuinticSpline kernel;
    for (int d = 1; d <= 3; ++d)
    {
        // Quadrature exact for polynomials: round-off only.
        EXPECT_NEAR(radialIntegral(d, [&](double q) { return kernel.w(q, d); }), 1, 1e-14);
        EXPECT_NEAR(radialIntegral(d, [&](double q) { return -q * q * kernel.f(q, d) / d; }), 1, 1e-14);
        const double laplacian =
            radialIntegral(d, [&](double q) { return 0.5 * q * q * (kernel.f(q, d) + q * q * kernel.g(q, d) / d); });
        EXPECT_NEAR(laplacian, 1, 1e-14);
        EXPECT_GT(radialIntegral(d, [&](double q) { return q * q * kernel.w(q, d); }), 0.1);
    }
}

TEST(KernelMoments, TellTheMisprintedTenthOrderPolynomialFromTheRightOne)
{
    test::Bounds bounds;
    // Lin et al. 2026, eq. 14, with alpha = 1/(2 pi h^2) for a unit integral.
    const auto printed = [](double q)
    {
        const double q2 = q * q;
        return (5 + q2 * (-10 + q2 * (4 + q2 * (-2.0 / 6 + q2 / 24)))) * std::exp(-q2) / (2 * std::numbers::pi);
    };
    const auto right = [kernel = Gaussian(10)](double q) { return kernel.w(q, 2); };
    const auto moment = [](const auto& w, int power)
    { return radialIntegral(2, [&](double q) { return w(q) * std::pow(q, power); }); };

    // Round-off of quadratures whose terms add up to less than 100 in magnitude.
    EXPECT_TRUE(bounds.near(moment(printed, 0), 1, 1e-13));
    EXPECT_TRUE(bounds.near(moment(printed, 2), 3, 1e-13)) << "the printed kernel is of second order";
    EXPECT_TRUE(bounds.near(moment(right, 0), 1, 1e-13));
    for (const int power : {2, 4, 6, 8}) { EXPECT_TRUE(bounds.near(moment(right, power), 0, 1e-12)) << power; }
}

} // namespace
} // namespace isph
