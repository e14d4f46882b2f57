#include "kernels/Gaussian.hpp"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

struct Reference
{
    int n;
    double s;
    double upper;
    double lower;
};

TEST(IncompleteGamma, AgreesWithFortyDigitArithmetic)
{
    // gammainc of mpmath 1.2, 40 digits.
    constexpr std::array<Reference, 12> references{{
        {1, 1.0e-6, 0.99999900000049999983, 9.9999950000016666662e-7},
        {2, 0.001, 0.99999950033320836666, 4.9966679163334027659e-7},
        {5, 2.0, 0.94734698265628884326, 0.052653017343711156742},
        {5, 5.0, 0.44049328506521241144, 0.55950671493478758856},
        {10, 20.0, 0.0049954123083075871662, 0.99500458769169241283},
        {33, 10.0, 0.99999999262779220386, 7.3722077961429537236e-9},
        {33, 33.0, 0.47684738866303085078, 0.52315261133696914922},
        {33, 60.0, 0.000054784618105141456941, 0.99994521538189485854},
        {100, 30.0, 1.0, 7.3384686328783333487e-24},
        {100, 99.0, 0.52669566960053900772, 0.47330433039946099228},
        {100, 101.0, 0.44710370656548875421, 0.55289629343451124579},
        {100, 150.0, 5.9245403354839158294e-6, 0.99999407545966451608},
    }};
    for (const auto& [n, s, upper, lower] : references)
    {
        // 2n factors, each half a unit in the last place off, at random.
        const double tolerance = 1.2e-16 * (4 + 2 * std::sqrt(2.0 * n));
        EXPECT_NEAR(upperGamma(n, s) / upper, 1, tolerance) << "Q(" << n << ", " << s << ")";
        EXPECT_NEAR(lowerGamma(n, s) / lower, 1, tolerance) << "P(" << n << ", " << s << ")";
    }
}

TEST(IncompleteGamma, AgreesWithLongDoubleSumsForEveryOrder)
{
    for (int n = 1; n <= 100; ++n)
    {
        for (double s = 1e-3; s < 400; s *= 1.9)
        {
            const long double exact = s;
            long double term = std::exp(-exact);
            long double upper = 0;
            for (int m = 0; m < n; term *= exact / ++m) { upper += term; }
            long double lower = 0;
            for (int m = n; m < n + 2000; term *= exact / ++m) { lower += term; }

            const double tolerance = 1.2e-16 * (8 + 2 * std::sqrt(2.0 * n)); // round-off of 2n factors, at random
            const auto near = [&](double value, long double reference)
            {
                const double expected = static_cast<double>(reference);
                EXPECT_NEAR(value, expected, tolerance * expected + 1e-322) << n << ' ' << s; // or it underflows
            };
            near(upperGamma(n, s), upper);
            near(lowerGamma(n, s), lower);
        }
    }
}

TEST(IncompleteGamma, HasItsLimits)
{
    EXPECT_EQ(upperGamma(0, 2), 0);
    EXPECT_EQ(lowerGamma(0, 2), 1);
    for (const int n : {1, 2, 10, 100})
    {
        EXPECT_EQ(upperGamma(n, 0), 1);
        EXPECT_EQ(lowerGamma(n, 0), 0);
        EXPECT_EQ(upperGamma(n, 1e9), 0);
        EXPECT_EQ(lowerGamma(n, 1e9), 1);
        EXPECT_EQ(lowerGamma(n, 1e-320), n == 1 ? 1e-320 : 0) << "underflow is no accident";
    }
}

TEST(IncompleteGamma, AddsUpToOneAcrossItsChangesOfForm)
{
    for (int n = 1; n <= 100; ++n)
    {
        for (const double s : {0.5 * n, std::nextafter(0.5 * n, 0), n + 1.0, std::nextafter(n + 1.0, 1e9)})
        {
            EXPECT_NEAR(upperGamma(n, s) + lowerGamma(n, s), 1, 1.2e-16 * (8 + 2 * std::sqrt(2.0 * n)))
                << n << ' ' << s;
        }
    }
}

} // namespace
} // namespace isph
