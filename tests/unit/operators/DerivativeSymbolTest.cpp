#include "operators/DerivativeSymbol.hpp"

#include "support/kernels.hpp"
#include "support/periodicBox.hpp"
#include "support/record.hpp"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <optional>
#include <vector>

namespace isph
{
namespace
{

using std::numbers::pi;
using test::closedGaussian;
using test::exactKernel;
using test::periodicBox;
using test::quinticSpline;
using test::sampledGaussian;
using test::unitSquare;

DerivativeSymbol derivativeOf(const Lattice& lattice, const KernelSettings& kernel)
{
    if (kernel.symbol == KernelSettings::Symbol::closed) { return DerivativeSymbol(lattice, kernel, nullptr); }
    const KernelSamples samples(lattice, kernel, LaplacianForm::exact);
    return DerivativeSymbol(lattice, kernel, &samples);
}

AlignedVector<double> laplacianOf(const Lattice& lattice, const KernelSettings& kernel, LaplacianForm form)
{
    if (kernel.symbol == KernelSettings::Symbol::closed) { return laplacianSymbol(lattice, kernel, form, nullptr); }
    const KernelSamples samples(lattice, kernel, form);
    return laplacianSymbol(lattice, kernel, form, &samples);
}

/// Mode, its wave vector, and the symbol of the first derivative there.
struct Mode
{
    std::size_t mode;
    std::array<double, 3> k{0, 0, 0};
    std::array<bool, 3> nyquist{false, false, false};
    std::array<double, 3> d{0, 0, 0};

    double k2() const { return k[0] * k[0] + k[1] * k[1] + k[2] * k[2]; }
};

std::vector<Mode> modesOf(const DerivativeSymbol& derivative)
{
    const ModeRows& rows = derivative.rows();
    std::vector<Mode> modes;
    std::array<std::vector<double>, 3> d;
    for (auto& values : d) { values.resize(rows.length()); }
    for (std::size_t row = 0; row < rows.count(); ++row)
    {
        derivative.row(row, 0, rows.length(), {d[0].data(), d[1].data(), d[2].data()});
        for (std::size_t i = 0; i < rows.length(); ++i)
        {
            Mode mode{.mode = rows.offset(row) + i};
            for (std::size_t axis = 0; axis < static_cast<std::size_t>(rows.dimensions()); ++axis)
            {
                const std::size_t index = axis == 0 ? i : rows.index(row, static_cast<int>(axis));
                mode.k[axis] = rows.wavenumbers().k[axis][index];
                mode.nyquist[axis] = mode.k[axis] != 0 && rows.wavenumbers().derivative[axis][index] == 0;
                mode.d[axis] = d[axis][i];
            }
            modes.push_back(mode);
        }
    }
    return modes;
}

TEST(DerivativeSymbol, ClosedOneIsTheFormula)
{
    // docs/theory/periodic.md, anisotropic included: s = sum (k_j h_j)^2/4 with one h/dx for every axis.
    for (const Lattice& lattice : {unitSquare(12), periodicBox({12, 9, 1}, {1000, 1, 0}),
                                   periodicBox({1, 8, 6}, {0, 2, 3}), periodicBox({8, 7, 6}, {1, 2, 30})})
    {
        for (const int order : {2, 4, 10, 66})
        {
            const KernelSettings kernel = closedGaussian(order, 1.3);
            const auto morris = laplacianOf(lattice, kernel, LaplacianForm::morris);
            const auto second = laplacianOf(lattice, kernel, LaplacianForm::secondDerivative);
            const auto exact = laplacianOf(lattice, kernel, LaplacianForm::exact);
            const DerivativeSymbol derivative = derivativeOf(lattice, kernel);
            EXPECT_TRUE(derivative.parallel());
            for (const Mode& mode : modesOf(derivative))
            {
                double s = 0;
                for (int d = 0; d < lattice.dimensions(); ++d)
                {
                    const double h = 1.3 * lattice.activeAxis(d).spacing();
                    s += std::pow(mode.k[static_cast<std::size_t>(d)] * h / 2, 2);
                }
                const double q = kernel.kernel->symbol(s);
                for (std::size_t d = 0; d < 3; ++d)
                {
                    if (mode.nyquist[d]) { EXPECT_EQ(mode.d[d], 0) << "exactly"; }
                    // s is rounded in its last digits, and Q answers with s times that.
                    else { EXPECT_NEAR(mode.d[d], mode.k[d] * q, std::abs(mode.k[d]) * (q * 1e-13 + 1e-16)); }
                }
                EXPECT_NEAR(second[mode.mode], mode.k2() * q, mode.k2() * (q * 1e-13 + 1e-16));
                EXPECT_NEAR(morris[mode.mode], mode.k2() * kernel.kernel->morrisSymbol(s), 1e-13 * mode.k2());
                EXPECT_DOUBLE_EQ(exact[mode.mode], mode.k2());
                if (mode.mode > 0) { EXPECT_GT(morris[mode.mode], 0) << "negative Laplacian for every wave"; }
                else { EXPECT_EQ(morris[0], 0); }
            }
        }
    }
}

TEST(DerivativeSymbol, ExactOneIsTheWaveVector)
{
    const Lattice lattice = periodicBox({8, 5, 6}, {1, 2, 3});
    const DerivativeSymbol derivative = derivativeOf(lattice, exactKernel());
    EXPECT_TRUE(derivative.parallel());
    for (const Mode& mode : modesOf(derivative))
    {
        for (std::size_t d = 0; d < 3; ++d) { EXPECT_EQ(mode.d[d], mode.nyquist[d] ? 0 : mode.k[d]); }
    }
}

TEST(DerivativeSymbol, VanishesExactlyAtNyquistOfItsAxis)
{
    for (const Lattice& lattice : {unitSquare(8), periodicBox({6, 10, 1}, {1, 3, 0}), periodicBox({2, 2, 2}, {1, 1, 1}),
                                   periodicBox({6, 8, 4}, {1, 2, 1}), periodicBox({1, 4, 6}, {0, 1, 1})})
    {
        for (const auto make : {+[] { return sampledGaussian(4, 2, 4); }, +[] { return quinticSpline(1.3); },
                                +[] { return closedGaussian(4, 1.3); }, +[] { return exactKernel(); }})
        {
            int atNyquist = 0;
            for (const Mode& mode : modesOf(derivativeOf(lattice, make())))
            {
                for (std::size_t d = 0; d < 3; ++d)
                {
                    if (!mode.nyquist[d] && mode.k[d] != 0) { continue; }
                    EXPECT_EQ(mode.d[d], 0) << "axis " << d << ", mode " << mode.mode;
                    atNyquist += mode.nyquist[d] ? 1 : 0;
                }
            }
            EXPECT_GT(atNyquist, 0);
        }
    }
}

TEST(DerivativeSymbol, AStretchOfARowIsPartOfIt)
{
    const Lattice lattice = periodicBox({16, 6, 4}, {1, 1, 1});
    for (const auto make : {+[] { return sampledGaussian(4, 2, 4); }, +[] { return closedGaussian(4, 1.3); }})
    {
        const DerivativeSymbol derivative = derivativeOf(lattice, make());
        const auto whole = modesOf(derivative);
        std::array<std::array<double, 9>, 3> part{};
        for (const std::size_t row : {std::size_t{0}, std::size_t{7}, derivative.rows().count() - 1})
        {
            derivative.row(row, 3, 7, {part[0].data(), part[1].data(), part[2].data()});
            for (std::size_t i = 3; i < 7; ++i)
            {
                for (std::size_t d = 0; d < 3; ++d)
                {
                    EXPECT_EQ(part[d][i - 3], whole[derivative.rows().offset(row) + i].d[d]);
                }
            }
        }
    }
}

TEST(DerivativeSymbol, SampledOneIsTheClosedOneWhereNothingIsCutOff)
{
    test::Bounds bounds;
    // R = 8h, h/dx = 2.5, up to a quarter of Nyquist: aliasing and truncation are below round-off.
    constexpr int n = 64;
    for (const int order : {2, 4, 6, 8, 10})
    {
        const KernelSettings sampled = sampledGaussian(order, 2.5, 8);
        const KernelSettings closed = closedGaussian(order, 2.5);
        const auto ofSamples = modesOf(derivativeOf(unitSquare(n), sampled));
        const auto ofFormula = modesOf(derivativeOf(unitSquare(n), closed));
        const auto morris = laplacianOf(unitSquare(n), sampled, LaplacianForm::morris);
        const auto morrisFormula = laplacianOf(unitSquare(n), closed, LaplacianForm::morris);
        int compared = 0;
        for (std::size_t i = 1; i < ofSamples.size(); ++i)
        {
            if (ofFormula[i].k2() > std::pow(pi * n / 4, 2)) { continue; }
            ++compared;
            const double difference =
                std::hypot(ofSamples[i].d[0] - ofFormula[i].d[0], ofSamples[i].d[1] - ofFormula[i].d[1]);
            // Round-off 1e-16 of samples that add up to about n, where d is 2 pi at least.
            EXPECT_TRUE(bounds.atMost(difference, 1e-12 * std::hypot(ofFormula[i].d[0], ofFormula[i].d[1])))
                << "order " << order;
            EXPECT_TRUE(bounds.near(morris[i] / morrisFormula[i], 1, 1e-11)) << "round-off of 4n/h^2 = 1e3 k^2";
        }
        EXPECT_GT(compared, 90);
    }
}

TEST(DerivativeSymbol, SupportsLargerThanTheBoxReachItsImages)
{
    test::Bounds bounds;
    // By Poisson's summation formula the samples of the infinite kernel have the sum of the closed symbol's aliases,
    // whatever the box: here supports of 16 dx and more in boxes of 5 to 9 points.
    for (const Lattice& lattice : {periodicBox({9, 8, 1}, {1, 1, 0}), periodicBox({6, 5, 7}, {1, 2, 3})})
    {
        for (const int order : {2, 4, 10})
        {
            for (const double smoothingLength : {1.0, 2.0})
            {
                const KernelSettings kernel = sampledGaussian(order, smoothingLength, 8.5);
                double largest = 0;
                double difference = 0;
                for (const Mode& mode : modesOf(derivativeOf(lattice, kernel)))
                {
                    std::array<double, 3> aliases{0, 0, 0};
                    const int reachZ = lattice.dimensions() == 3 ? 3 : 0;
                    for (int a = -3; a <= 3; ++a)
                    {
                        for (int b = -3; b <= 3; ++b)
                        {
                            for (int c = -reachZ; c <= reachZ; ++c)
                            {
                                const std::array<int, 3> m{a, b, c};
                                std::array<double, 3> k{0, 0, 0};
                                double s = 0;
                                for (int d = 0; d < lattice.dimensions(); ++d)
                                {
                                    const auto i = static_cast<std::size_t>(d);
                                    const double dx = lattice.activeAxis(d).spacing();
                                    k[i] = mode.k[i] + 2 * pi * m[i] / dx;
                                    s += std::pow(0.5 * k[i] * smoothingLength * dx, 2);
                                }
                                const double q = kernel.kernel->symbol(s);
                                for (std::size_t d = 0; d < 3; ++d) { aliases[d] += k[d] * q; }
                            }
                        }
                    }
                    for (std::size_t d = 0; d < 3; ++d)
                    {
                        largest = std::max(largest, std::abs(mode.d[d]));
                        difference = std::max(difference, std::abs(mode.d[d] - aliases[d]));
                    }
                }
                // Outside 8.5h order 10 has exp(-72) 8.5^10 or so; round-off of the aliases and of the samples.
                EXPECT_TRUE(bounds.atMost(difference, 1e-13 * largest))
                    << "order " << order << ", h/dx " << smoothingLength;
                EXPECT_GT(largest, 1);
            }
        }
    }
}

TEST(SymbolOfWeights, IsTheSumOfWavesOverTheOffsets)
{
    const Lattice lattice = periodicBox({6, 5, 4}, {1, 1, 1});
    const std::vector<std::array<int, 3>> offsets{{1, 0, 0}, {-1, 0, 0}, {7, -6, 9}, {-7, 6, -9}};
    const std::vector<double> even{2, 2, 0.5, 0.5};
    const std::vector<double> odd{1, -1, 3, -3};
    FourierTransform transform(lattice, 1);
    const auto cosines = symbolOfWeights(lattice, transform, offsets, even, false);
    const auto sines = symbolOfWeights(lattice, transform, offsets, odd, true);
    for (const Mode& mode : modesOf(derivativeOf(lattice, exactKernel())))
    {
        const double first = mode.k[0] / 6;
        const double second = 7 * mode.k[0] / 6 - 6 * mode.k[1] / 5 + 9 * mode.k[2] / 4;
        EXPECT_NEAR(cosines[mode.mode], 4 * std::cos(first) + std::cos(second), 1e-13); // phases up to 50
        EXPECT_NEAR(sines[mode.mode], 2 * std::sin(first) + 6 * std::sin(second), 3e-13);
    }
}

TEST(OperatorBounds, AreTheLargestOfTheKeptModes)
{
    const Lattice lattice = unitSquare(12);
    const auto laplacian = laplacianOf(lattice, exactKernel(), LaplacianForm::exact);
    const DerivativeSymbol derivative = derivativeOf(lattice, exactKernel());

    const OperatorBounds all = operatorBounds(derivative, laplacian, {lattice, Dealiasing::none});
    EXPECT_DOUBLE_EQ(all.derivative[0], 2 * pi * 5) << "Nyquist has none";
    EXPECT_DOUBLE_EQ(all.derivative[1], 2 * pi * 5);
    EXPECT_EQ(all.derivative[2], 0);
    EXPECT_DOUBLE_EQ(all.derivativeMagnitude, 2 * pi * std::sqrt(50.0));
    EXPECT_DOUBLE_EQ(all.laplacian, 4 * pi * pi * (36 + 25)) << "but the Laplacian does; no checkerboard";
    EXPECT_EQ(all.leastLaplacian, 0);
    EXPECT_DOUBLE_EQ(all.derivativeOverLaplacian, 1);

    const OperatorBounds kept = operatorBounds(derivative, laplacian, {lattice, Dealiasing::twoThirds});
    EXPECT_DOUBLE_EQ(kept.derivative[0], 2 * pi * 3);
    EXPECT_DOUBLE_EQ(kept.derivativeMagnitude, 2 * pi * std::sqrt(18.0));
    EXPECT_DOUBLE_EQ(kept.laplacian, 4 * pi * pi * 18);

    const OperatorBounds inviscid = operatorBounds(derivative, {}, {lattice, Dealiasing::none});
    EXPECT_EQ(inviscid.laplacian, 0);
    EXPECT_EQ(inviscid.derivativeOverLaplacian, 0);
}

TEST(OperatorBounds, OfAFineLatticeAreThoseOfTheKernel)
{
    // max |D| = c_n/h and Morris 4n/h^2, both from below; the scan of the lattice is dense enough for a percent.
    constexpr int n = 64;
    for (const int order : {2, 4})
    {
        const KernelSettings kernel = closedGaussian(order, 2);
        const auto laplacian = laplacianOf(unitSquare(n), kernel, LaplacianForm::morris);
        const OperatorBounds bounds =
            operatorBounds(derivativeOf(unitSquare(n), kernel), laplacian, {unitSquare(n), Dealiasing::none});
        const double h = 2.0 / n;
        const double c = Gaussian(order).largestDerivative();
        EXPECT_NEAR(bounds.derivativeMagnitude * h / c, 1, 0.01);
        EXPECT_LE(bounds.derivativeMagnitude, c / h * (1 + 1e-14));
        EXPECT_NEAR(bounds.laplacian * h * h / (2 * order), 1, 0.01);
        EXPECT_LE(bounds.laplacian, 2 * order / (h * h) * (1 + 1e-14));
    }
}

TEST(OperatorBounds, TellWhatGrows)
{
    const KernelSettings kernel = quinticSpline(1.5);
    const auto laplacian = laplacianOf(unitSquare(64), kernel, LaplacianForm::secondDerivative);
    const OperatorBounds bounds =
        operatorBounds(derivativeOf(unitSquare(64), kernel), laplacian, {unitSquare(64), Dealiasing::none});
    EXPECT_NEAR(bounds.leastLaplacian / (64 * 64), -7.2e-3, 0.05e-3);
}

} // namespace
} // namespace isph
