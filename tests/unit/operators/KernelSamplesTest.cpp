#include "operators/KernelSamples.hpp"

#include "support/kernels.hpp"
#include "support/messageOf.hpp"
#include "support/periodicBox.hpp"
#include "support/quadrature.hpp"

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

using std::numbers::pi;
using test::periodicBox;
using test::quinticSpline;
using test::sampledGaussian;
using test::unitSquare;

/// Weights on a lattice with what they make of polynomials and waves along axis d.
struct Weights
{
    Weights(const Lattice& lattice, const KernelSettings& kernel, LaplacianForm form) : samples(lattice, kernel, form)
    {
        for (int d = 0; d < lattice.dimensions(); ++d) { dx.push_back(lattice.activeAxis(d).spacing()); }
    }

    /// Sum of weights times term(x_d) over the neighbours.
    template<class Term>
    double sum(const std::vector<double>& weights, std::size_t d, Term term) const
    {
        double total = 0;
        for (std::size_t b = 0; b < weights.size(); ++b) { total += weights[b] * term(samples.offsets[b][d] * dx[d]); }
        return total;
    }

    double firstDerivativeOfX(std::size_t d = 0) const
    {
        return sum(samples.gradient[d], d, [](double x) { return x; });
    }
    double laplacianOfHalfXSquared(std::size_t d = 0) const
    {
        return sum(samples.laplacian, d, [](double x) { return 0.5 * x * x; });
    }
    double gradientError(double k) const // of sin(k x), relative
    {
        return sum(samples.gradient[0], 0, [k](double x) { return std::sin(k * x); }) / k - 1;
    }
    double laplacianError(double k) const // of cos(k x), relative
    {
        return sum(samples.laplacian, 0, [k](double x) { return 1 - std::cos(k * x); }) / (k * k) - 1;
    }

    KernelSamples samples;
    std::vector<double> dx;
};

Weights onSquare(int n, const KernelSettings& kernel, LaplacianForm form = LaplacianForm::morris)
{
    return {unitSquare(n), kernel, form};
}

/// Defect E0 of the first derivative of a linear field.
double defect(const KernelSettings& kernel) { return std::abs(onSquare(16, kernel).firstDerivativeOfX() - 1); }

struct Row
{
    int order;
    std::array<double, 4> smallest;
};

TEST(KernelSamples, AliasingDefectIsThatOfTheTable)
{
    // Smallest h/dx, in steps of 0.02, for defects below these bounds; truncation at 9h is none.
    constexpr std::array<double, 4> bounds{1e-3, 1e-4, 1e-6, 1e-10};
    constexpr std::array<Row, 10> table{{{2, {1.04, 1.16, 1.36, 1.68}},
                                         {4, {1.18, 1.28, 1.48, 1.78}},
                                         {6, {1.28, 1.38, 1.56, 1.88}},
                                         {8, {1.36, 1.46, 1.64, 1.94}},
                                         {10, {1.44, 1.54, 1.72, 2.02}},
                                         {12, {1.50, 1.60, 1.78, 2.08}},
                                         {16, {1.62, 1.72, 1.90, 2.18}},
                                         {20, {1.72, 1.82, 2.00, 2.28}},
                                         {32, {2.00, 2.10, 2.26, 2.54}},
                                         {66, {2.56, 2.64, 2.80, 3.06}}}};
    for (const auto& [order, smallest] : table)
    {
        for (std::size_t i = 0; i < bounds.size(); ++i)
        {
            EXPECT_LT(defect(sampledGaussian(order, smallest[i], 9)), bounds[i]) << "order " << order;
            EXPECT_GT(defect(sampledGaussian(order, smallest[i] - 0.021, 9)), bounds[i]) << "order " << order;
        }
    }
}

TEST(KernelSamples, TruncationDefectIsWithinTheTable)
{
    // R/h at which the part of the first moment outside is below these bounds, in two dimensions.
    constexpr std::array<double, 3> bounds{1e-3, 1e-6, 1e-10};
    constexpr std::array<std::array<double, 4>, 10> table{{{2, 3.05, 4.10, 5.15},
                                                           {4, 3.45, 4.45, 5.50},
                                                           {6, 3.70, 4.75, 5.75},
                                                           {8, 3.90, 4.95, 5.95},
                                                           {10, 4.00, 5.15, 6.15},
                                                           {12, 3.65, 5.30, 6.30},
                                                           {16, 3.70, 5.50, 6.60},
                                                           {20, 3.75, 5.25, 6.80},
                                                           {32, 3.75, 5.50, 6.95},
                                                           {66, 3.90, 5.45, 7.00}}};
    for (const auto& row : table)
    {
        const Gaussian kernel(static_cast<int>(row[0]));
        for (std::size_t i = 0; i < bounds.size(); ++i)
        {
            const double outside =
                test::integral(row[i + 1], row[i + 1] + 8, [&](double q) { return -pi * q * q * q * kernel.f(q, 2); });
            EXPECT_LT(std::abs(outside), bounds[i]) << "order " << row[0] << ", R/h " << row[i + 1];
        }
    }
}

TEST(KernelSamples, DefectsOfTheUsualSupportsAreThoseOfTheTheory)
{
    struct Entry
    {
        int order;
        double at13;
        double at20;
    };
    // Support 4h, h/dx = 1.3 and 2: half a unit of a digit or two, whose smallest is a 3.
    for (const auto& [order, at13, at20] : {Entry{2, 5e-6, 3e-6}, Entry{4, 4.4e-5, 3.7e-5}, Entry{6, 5.9e-4, 2.1e-4},
                                            Entry{8, 2.4e-3, 6.6e-4}, Entry{10, 1.2e-2, 1.1e-3}})
    {
        EXPECT_NEAR(defect(sampledGaussian(order, 1.3, 4)) / at13, 1, 0.5 / 3) << order;
        EXPECT_NEAR(defect(sampledGaussian(order, 2.0, 4)) / at20, 1, 0.5 / 3) << order;
    }
    EXPECT_NEAR(defect(quinticSpline(1.3)) / 6e-4, 1, 0.1);
    EXPECT_NEAR(defect(quinticSpline(1.5)) / 1.6e-4, 1, 0.1);
    EXPECT_NEAR(defect(quinticSpline(2.0)) / 7e-6, 1, 0.1);
}

TEST(KernelSamples, ErrorsOfAWaveAreThoseOfTheTheory)
{
    struct Entry
    {
        int order;
        double gradient;
        double morris;
    };
    // sin(2 pi x), 100 points, h = 2 dx, support 4h: printed to two digits.
    for (const auto& [order, gradient, morris] :
         {Entry{4, 2.8e-5, 3.4e-5}, Entry{6, 2.1e-4, 2.1e-4}, Entry{8, 6.3e-4, 6.4e-4}, Entry{10, 1.0e-3, 1.0e-3}})
    {
        const Weights weights = onSquare(100, sampledGaussian(order, 2, 4));
        EXPECT_NEAR(std::abs(weights.gradientError(2 * pi)) / gradient, 1, 0.05) << order;
        EXPECT_NEAR(std::abs(weights.laplacianError(2 * pi)) / morris, 1, 0.05) << order;
    }
    // h = 8 dx, support 4h: what "h is set to 8 dx" would mean word for word.
    for (const auto& [order, gradient, morris] :
         {Entry{4, 1.9e-3, 6.2e-4}, Entry{6, 1.3e-4, 1.4e-4}, Entry{8, 2.8e-4, 4.0e-4}, Entry{10, 4.8e-4, 6.7e-4}})
    {
        const Weights weights = onSquare(100, sampledGaussian(order, 8, 4));
        EXPECT_NEAR(std::abs(weights.gradientError(2 * pi)) / gradient, 1, 0.05) << order;
        EXPECT_NEAR(std::abs(weights.laplacianError(2 * pi)) / morris, 1, 0.05) << order;
    }
}

TEST(KernelSamples, RenormaliseTakesTheDefectAway)
{
    KernelSettings kernel = sampledGaussian(4, 2, 4);
    EXPECT_NEAR(onSquare(160, kernel).gradientError(2 * pi) / 3.5e-5, 1, 0.05);
    kernel.renormalise = true;
    EXPECT_NEAR(std::abs(onSquare(160, kernel).gradientError(2 * pi)) / 1.7e-6, 1, 0.05);

    for (const LaplacianForm form : {LaplacianForm::morris, LaplacianForm::secondDerivative})
    {
        for (const auto make : {+[] { return sampledGaussian(4, 2, 4); }, +[] { return sampledGaussian(10, 1.3, 4); },
                                +[] { return quinticSpline(1.3); }})
        {
            KernelSettings settings = make();
            settings.renormalise = true;
            for (const Lattice& lattice : {unitSquare(16), test::unitCube(16)})
            {
                const Weights weights(lattice, settings, form);
                for (std::size_t d = 0; d < 2; ++d)
                {
                    // Round-off of a sum of some 1000 weights with x^2.
                    EXPECT_NEAR(weights.firstDerivativeOfX(d), 1, 1e-13);
                    EXPECT_NEAR(weights.laplacianOfHalfXSquared(d), 1, 1e-12);
                }
            }
        }
    }
}

TEST(KernelSamples, RenormalisedQuinticSplineIsOfSecondOrder)
{
    KernelSettings kernel = quinticSpline(1.3);
    kernel.renormalise = true;
    const auto error = [&](int n) { return std::abs(onSquare(n, kernel).gradientError(2 * pi)); };
    EXPECT_NEAR(std::log2(error(40) / error(80)), 2, 0.05);
    EXPECT_NEAR(std::log2(error(80) / error(160)), 2, 0.05);
}

TEST(KernelSamples, WeightsOfDerivativesAddUpToZero)
{
    for (const LaplacianForm form : {LaplacianForm::morris, LaplacianForm::secondDerivative})
    {
        for (const bool renormalise : {false, true})
        {
            for (const auto make : {+[] { return quinticSpline(1.5); }, +[] { return sampledGaussian(6, 1.3, 3); }})
            {
                KernelSettings kernel = make();
                kernel.renormalise = renormalise;
                for (const Lattice& lattice : {unitSquare(1), periodicBox({8, 8, 8}, {1, 2, 3})})
                {
                    const Weights weights(lattice, kernel, form);
                    const auto one = [](double) { return 1.0; };
                    double magnitude = 0;
                    for (const double weight : weights.samples.laplacian) { magnitude += std::abs(weight); }
                    EXPECT_NEAR(weights.sum(weights.samples.laplacian, 0, one), 0, 1e-15 * magnitude) << "round-off";
                    EXPECT_NEAR(weights.sum(weights.samples.gradient[0], 0, one), 0, 1e-15 * magnitude);
                }
            }
        }
    }
}

/// Largest value of the Laplacian's symbol, times dx^2, scanned over the Brillouin zone.
double largestLaplacian(const KernelSettings& kernel)
{
    const Weights weights = onSquare(64, kernel, LaplacianForm::secondDerivative);
    double largest = -1;
    for (int i = 0; i <= 32; ++i)
    {
        for (int j = 0; j <= i; ++j)
        {
            double total = 0;
            for (std::size_t b = 0; b < weights.samples.offsets.size(); ++b)
            {
                const auto& offset = weights.samples.offsets[b];
                total += weights.samples.laplacian[b] * std::cos(2 * pi / 64 * (i * offset[0] + j * offset[1]));
            }
            largest = std::max(largest, total / (64 * 64));
        }
    }
    return largest;
}

TEST(KernelSamples, SecondDerivativeCanBePositive)
{
    // As the theory prints it, in two digits: waves that should decay grow.
    EXPECT_NEAR(largestLaplacian(quinticSpline(1.5)), 7.2e-3, 0.05e-3);
    EXPECT_NEAR(largestLaplacian(quinticSpline(2.0)), 2.9e-4, 0.05e-4);
    EXPECT_NEAR(largestLaplacian(sampledGaussian(6, 2, 4)), 1.9e-4, 0.05e-4);
    EXPECT_NEAR(largestLaplacian(sampledGaussian(4, 2, 5)), 0, 1e-15) << "only constants stay";
}

TEST(KernelSamples, LaplaciansAreConsistentWhereSpacingsDiffer)
{
    for (const LaplacianForm form : {LaplacianForm::morris, LaplacianForm::secondDerivative})
    {
        for (const double ratio : {1.0, 2.0, 10.0, 100.0})
        {
            const Lattice lattice = periodicBox({16, 16, 1}, {ratio, 1, 0});
            const auto error = [&](const KernelSettings& kernel, std::size_t d)
            { return std::abs(Weights(lattice, kernel, form).laplacianOfHalfXSquared(d) - 1); };
            // What the narrow axis leaves along the wide one grows with the ratio squared; measured factors, and a half
            // more.
            const double squared = ratio * ratio;
            EXPECT_LT(error(sampledGaussian(10, 2, 6), 0), 2e-8 + 7e-9 * squared) << ratio;
            EXPECT_LT(error(sampledGaussian(4, 2, 5), 0), 3e-7 + 3e-8 * squared) << ratio;
            EXPECT_LT(error(sampledGaussian(4, 2, 4), 0), 8e-4 + 1.5e-4 * squared) << ratio;
            EXPECT_LT(error(quinticSpline(2), 0), 1e-4 + 9e-5 * squared) << ratio;
            // Along the narrow axis nothing of the kind happens.
            EXPECT_LT(error(sampledGaussian(10, 2, 6), 1), 2e-8);
            EXPECT_LT(error(sampledGaussian(4, 2, 5), 1), 3e-7);
            EXPECT_LT(error(quinticSpline(2), 1), 1e-4);
        }
    }
}

TEST(KernelSamples, MorrisIsContinuousWhereSpacingsBecomeEqual)
{
    const KernelSettings kernel = sampledGaussian(4, 1.3, 5);
    const Weights equal(periodicBox({16, 16, 1}, {1, 1, 0}), kernel, LaplacianForm::morris);
    const Weights almost(periodicBox({16, 16, 1}, {1 + 1e-9, 1, 0}), kernel, LaplacianForm::morris);
    for (std::size_t b = 0; b < equal.samples.laplacian.size(); ++b)
    {
        // 1e-9 of the largest weight, times the largest g/f.
        EXPECT_NEAR(equal.samples.laplacian[b], almost.samples.laplacian[b],
                    1e-7 * std::abs(equal.samples.laplacian.front() -
                                    equal.samples.laplacian[equal.samples.laplacian.size() / 2]));
    }
}

TEST(KernelSamples, MorrisIsTheSumOfThePaper)
{
    // sum_b V 2 x.gradW/r^2 (f_a - f_b), Fourtakas et al. 2021, eq. 3.2 with constant viscosity 1.
    const KernelSettings kernel = quinticSpline(1.3);
    const double dx = 1.0 / 16;
    const double h = 1.3 * dx;
    const Weights weights = onSquare(16, kernel);
    for (std::size_t b = 0; b < weights.samples.offsets.size(); ++b)
    {
        const double x = weights.samples.offsets[b][0] * dx;
        const double y = weights.samples.offsets[b][1] * dx;
        const double r = std::hypot(x, y);
        if (r == 0) { continue; }
        const double slope = r / h * kernel.kernel->f(r / h, 2) / (h * h * h);                    // dW/dr
        EXPECT_NEAR(weights.samples.laplacian[b], -2 * dx * dx * slope / r, 1e-12 * 4 / (h * h)); // of the largest
        EXPECT_NEAR(weights.samples.gradient[0][b], -dx * dx * slope * x / r, 1e-14 / h);
        EXPECT_NEAR(weights.samples.gradient[1][b], -dx * dx * slope * y / r, 1e-14 / h);
    }
}

TEST(KernelSamples, ExactLaplacianHasNone)
{
    const KernelSamples samples(unitSquare(8), quinticSpline(1.3), LaplacianForm::exact);
    EXPECT_TRUE(samples.laplacian.empty());
    EXPECT_EQ(samples.gradient[0].size(), samples.offsets.size());
    EXPECT_TRUE(samples.gradient[2].empty());
}

TEST(KernelSamples, RefuseASupportWithoutNeighbours)
{
    EXPECT_THAT(messageOf([] { onSquare(8, sampledGaussian(4, 0.3, 3)); }),
                AllOf(testing::HasSubstr("reaches no neighbour"), testing::HasSubstr("larger supportRadius")));
    EXPECT_THAT(messageOf([] { KernelSamples(test::unitCube(8), sampledGaussian(4, 80, 5), LaplacianForm::morris); }),
                testing::HasSubstr("20 million neighbours"));
}

} // namespace
} // namespace isph
