#include "kernels/Gaussian.hpp"

#include "core/Error.hpp"
#include "support/messageOf.hpp"
#include "support/record.hpp"

#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace isph
{
namespace
{

/// Value at x of the polynomial with the given coefficients, lowest power first.
double polynomial(const std::vector<double>& coefficients, double x)
{
    double value = 0;
    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) { value = value * x + *c; }
    return value;
}

struct Printed
{
    int order;
    std::array<std::vector<double>, 3> coefficients; ///< of powers of q^2 in 1, 2, 3 dimensions
};

TEST(Gaussian, HasThePolynomialsOfTheTable)
{
    // docs/theory/periodic.md, section 1; the 2-D column is Lind & Stansby 2016 and, corrected, Lin et al. 2026.
    const std::vector<Printed> table{
        {2, {{{1}, {1}, {1}}}},
        {4, {{{1.5, -1}, {2, -1}, {2.5, -1}}}},
        {6, {{{15.0 / 8, -2.5, 0.5}, {3, -3, 0.5}, {35.0 / 8, -3.5, 0.5}}}},
        {8, {{{35.0 / 16, -35.0 / 8, 1.75, -1.0 / 6}, {4, -6, 2, -1.0 / 6}, {105.0 / 16, -63.0 / 8, 2.25, -1.0 / 6}}}},
        {10,
         {{{315.0 / 128, -105.0 / 16, 63.0 / 16, -0.75, 1.0 / 24},
           {5, -10, 5, -5.0 / 6, 1.0 / 24},
           {1155.0 / 128, -231.0 / 16, 99.0 / 16, -11.0 / 12, 1.0 / 24}}}},
    };
    for (const auto& [order, coefficients] : table)
    {
        const Gaussian kernel(order);
        EXPECT_EQ(kernel.order(), order);
        for (int d = 1; d <= 3; ++d)
        {
            for (double q = 0; q < 5; q += 0.3)
            {
                const double scale = std::pow(std::numbers::pi, -0.5 * d) * std::exp(-q * q);
                const auto& printed = coefficients[static_cast<std::size_t>(d - 1)];
                std::vector<double> magnitudes = printed;
                for (double& c : magnitudes) { c = std::abs(c); }
                // Round-off of either evaluation: a few units of the terms' magnitude.
                EXPECT_NEAR(kernel.w(q, d), scale * polynomial(printed, q * q),
                            4e-15 * scale * polynomial(magnitudes, q * q))
                    << "order " << order << ", d " << d << ", q " << q;
            }
        }
    }
}

TEST(Gaussian, HasTheDerivativesOfItsValues)
{
    constexpr double step = 1e-3;
    for (const int order : {2, 4, 6, 8, 10, 20, 66})
    {
        const Gaussian kernel(order);
        for (int d = 1; d <= 3; ++d)
        {
            const auto derivative = [](auto function, double q) { // sixth order
                return (45 * (function(q + step) - function(q - step)) -
                        9 * (function(q + 2 * step) - function(q - 2 * step)) + function(q + 3 * step) -
                        function(q - 3 * step)) /
                       (60 * step);
            };
            for (double q = 0.1; q < 4; q += 0.37)
            {
                const double slope = derivative([&](double r) { return kernel.w(r, d); }, q);
                const double slopeOfF = derivative([&](double r) { return kernel.f(r, d); }, q);
                // Round-off over the step, and half an order of it from the polynomial's recurrence; truncation with
                // the kernel's largest wavenumber 2 sqrt(n), 2n being the order.
                const double roundOff = 2e-16 / step * (10 + 0.5 * order);
                const double error = roundOff + std::pow(2.0 * order, 3.5) * std::pow(step, 6) / 140;
                EXPECT_NEAR(q * kernel.f(q, d), slope, error * std::abs(kernel.w(0, d)));
                EXPECT_NEAR(q * kernel.g(q, d), slopeOfF, error * std::abs(kernel.f(0, d)));
            }
        }
    }
}

TEST(Gaussian, HasFiniteQuotientsInTheCentre)
{
    for (const int order : {2, 4, 10, 66})
    {
        const Gaussian kernel(order);
        for (int d = 1; d <= 3; ++d)
        {
            // f and g are even: from 0 to 1e-6 they change by the square of it, times n/2 or so.
            EXPECT_NEAR(kernel.f(1e-6, d) / kernel.f(0, d), 1, 1e-10);
            EXPECT_NEAR(kernel.g(1e-6, d) / kernel.g(0, d), 1, 1e-10);
            EXPECT_LT(kernel.f(0, d), 0);
            EXPECT_GT(kernel.g(0, d), 0);
        }
    }
}

TEST(Gaussian, SymbolIsTheSumOfItsSeries)
{
    for (const int order : {2, 4, 6, 10, 20, 66})
    {
        const Gaussian kernel(order);
        for (const double s : {0.0, 1e-8, 1e-3, 0.3, 1.0, 4.0, 20.0, 60.0, 600.0})
        {
            long double term = std::exp(-static_cast<long double>(s));
            long double total = term;
            for (int m = 1; m < order / 2; ++m) { total += term *= static_cast<long double>(s) / m; }
            EXPECT_NEAR(kernel.symbol(s), static_cast<double>(total), 4e-15 * static_cast<double>(total));
        }
        EXPECT_EQ(kernel.symbol(0), 1);
        EXPECT_EQ(kernel.symbol(800), 0) << "exp(-s) underflows";
    }
}

TEST(Gaussian, LeadingErrorsAreThoseOfTheory)
{
    // Q = 1 - s^n/n! + ..., Morris 1 - s^n/(n+1)! + ...; the next term is n/(n+1) or so of s smaller.
    for (const int n : {1, 2, 3, 4, 5})
    {
        const Gaussian kernel(2 * n);
        const double s = std::pow(1e-6 * std::tgamma(n + 1.0), 1.0 / n); // error 1e-6
        EXPECT_NEAR((1 - kernel.symbol(s)) / 1e-6, 1, s) << n;
        EXPECT_NEAR((1 - kernel.morrisSymbol(s)) / 1e-6 * (n + 1), 1, s) << n;
    }
}

TEST(Gaussian, MorrisSymbolIsTheSumOfIncompleteGammaFunctions)
{
    test::Bounds bounds;
    // s morrisSymbol = sum_{j=1..n} P(j, s): every term positive, so the reference loses no digits.
    for (int n = 1; n <= 33; ++n)
    {
        const Gaussian kernel(2 * n);
        for (double s = 1e-6; s <= 1.01e3; s *= 1.7)
        {
            double total = 0;
            for (int j = 1; j <= n; ++j) { total += lowerGamma(j, s); }
            const double symbol = kernel.morrisSymbol(s);
            EXPECT_TRUE(bounds.near(s * symbol / total, 1, 1e-13))
                << "n " << n << ", s " << s; // n round-offs and their growth
            EXPECT_GT(symbol, 0) << "the Laplacian must be negative";
        }
        EXPECT_EQ(kernel.morrisSymbol(0), 1);
        EXPECT_TRUE(bounds.atLeast(kernel.morrisSymbol(1e-300), 0.99));
        EXPECT_TRUE(bounds.near(kernel.morrisSymbol(1e8) * 1e8, n, 1e-14 * n)) << "saturates at -4n/h^2";
    }
}

TEST(Gaussian, MorrisSymbolFallsWhileTheLaplacianGrows)
{
    for (const int n : {1, 2, 5, 10, 33})
    {
        const Gaussian kernel(2 * n);
        double before = 0;
        for (double s = 0.01; s < 3 * n; s += 0.05 * n)
        {
            const double laplacian = s * kernel.morrisSymbol(s);
            EXPECT_GT(laplacian, before) << "n " << n << ", s " << s;
            before = laplacian;
        }
    }
}

TEST(Gaussian, LargestDerivativesAreThoseOfTheTable)
{
    // c_n of docs/theory/periodic.md, section 8: four decimals.
    const std::vector<std::pair<int, double>> table{{2, 0.8578},  {4, 1.4715},  {6, 1.9825},  {8, 2.4314},
                                                    {10, 2.8371}, {12, 3.2104}, {16, 3.8855}, {20, 4.4905}};
    for (const auto& [order, c] : table)
    {
        EXPECT_NEAR(Gaussian(order).largestDerivative(), c, 0.5001e-4) << "order " << order;
    }
    EXPECT_NEAR(Gaussian(2).largestDerivative(), std::sqrt(2 / std::numbers::e), 1e-14);
}

TEST(Gaussian, LargestDerivativeIsNowhereExceeded)
{
    for (const int order : {2, 4, 10, 20, 66, 200})
    {
        const Gaussian kernel(order);
        const double largest = kernel.largestDerivative();
        double found = 0;
        for (double s = 0; s < order; s += 1e-4 * order)
        {
            found = std::max(found, 2 * std::sqrt(s) * kernel.symbol(s));
        }
        EXPECT_LE(found, largest * (1 + 1e-14));
        EXPECT_GE(found, largest * (1 - 1e-4)) << "the scan is that fine";
    }
}

TEST(Gaussian, RefusesOrdersThatNoKernelHas)
{
    for (const int order : {0, 1, 3, -2, -400, 201, 202, 400})
    {
        EXPECT_THAT(messageOf([order] { const Gaussian kernel(order); }),
                    testing::HasSubstr("is " + std::to_string(order) + " but must be even, from 2 to 200"));
    }
    EXPECT_NO_THROW(Gaussian(200));
}

TEST(Gaussian, SupportsAreTheDefaultsOfTheSampledMode)
{
    EXPECT_EQ(Gaussian(2).supportRadius(), 5);
    EXPECT_EQ(Gaussian(4).supportRadius(), 5);
    EXPECT_EQ(Gaussian(6).supportRadius(), 6);
    EXPECT_EQ(Gaussian(10).supportRadius(), 6);
    EXPECT_EQ(Gaussian(12).supportRadius(), 7);
}

} // namespace
} // namespace isph
