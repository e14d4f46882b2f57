#include "operators/DirectSumOperators.hpp"
#include "operators/SpectralOperators.hpp"

#include "support/fields.hpp"
#include "support/kernels.hpp"
#include "support/periodicBox.hpp"
#include "support/record.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <initializer_list>
#include <omp.h>
#include <optional>
#include <utility>
#include <vector>

namespace isph
{
namespace
{

using test::periodicBox;
using test::quinticSpline;
using test::sampledGaussian;

using MakeKernel = KernelSettings (*)();

constexpr std::array<MakeKernel, 4> sampledKernels{
    +[] { return quinticSpline(1.3); }, +[] { return quinticSpline(2.0); }, +[] { return sampledGaussian(4, 1.3, 4); },
    +[] { return sampledGaussian(10, 1.5, 6); }};
constexpr std::array<MakeKernel, 3> closedKernels{+[] { return test::closedGaussian(4, 1.3); },
                                                  +[] { return test::closedGaussian(20, 2.0); },
                                                  +[] { return test::exactKernel(); }};

/// Two and three dimensions, unequal spacings, odd counts, boxes smaller than the supports.
std::vector<Lattice> lattices()
{
    return {periodicBox({24, 20, 1}, {1.2, 1, 0}), periodicBox({17, 8, 1}, {1, 3, 0}),
            periodicBox({1, 5, 14}, {0, 1, 1}), periodicBox({10, 9, 12}, {1, 0.9, 1.2}),
            periodicBox({5, 8, 3}, {1, 1, 1})};
}

SpectralOperators spectral(const Lattice& lattice, const KernelSettings& kernel, LaplacianForm form)
{
    if (kernel.symbol == KernelSettings::Symbol::closed)
    {
        return {lattice, DerivativeSymbol(lattice, kernel, nullptr), laplacianSymbol(lattice, kernel, form, nullptr)};
    }
    const KernelSamples samples(lattice, kernel, form);
    return {lattice, DerivativeSymbol(lattice, kernel, &samples), laplacianSymbol(lattice, kernel, form, &samples)};
}

double largest(const RealField& field)
{
    double value = 0;
    for (int c = 0; c < field.components(); ++c)
    {
        for (const double v : field[c]) { value = std::max(value, std::abs(v)); }
    }
    return value;
}

double largestDifference(const RealField& a, const RealField& b)
{
    double value = 0;
    for (int c = 0; c < a.components(); ++c)
    {
        for (std::size_t i = 0; i < a.size(); ++i) { value = std::max(value, std::abs(a[c][i] - b[c][i])); }
    }
    return value;
}

double dot(const RealField& a, const RealField& b)
{
    double total = 0;
    for (int c = 0; c < a.components(); ++c)
    {
        for (std::size_t i = 0; i < a.size(); ++i) { total += a[c][i] * b[c][i]; }
    }
    return total;
}

TEST(Operators, ConvolutionIsTheSumOverNeighbours)
{
    test::Bounds bounds;
    for (const Lattice& lattice : lattices())
    {
        const int dimensions = lattice.dimensions();
        const RealField u = test::noise(lattice, dimensions, 1);
        for (const MakeKernel make : sampledKernels)
        {
            for (const LaplacianForm form : {LaplacianForm::morris, LaplacianForm::secondDerivative})
            {
                for (const bool renormalise : {false, true})
                {
                    KernelSettings kernel = make();
                    kernel.renormalise = renormalise;
                    DirectSumOperators sums(lattice, KernelSamples(lattice, kernel, form));
                    SpectralOperators convolutions = spectral(lattice, kernel, form);
                    const auto agree = [&](RealField& a, RealField& b)
                    {
                        // Round-off of a sum of up to 1000 neighbours and of a transform.
                        EXPECT_TRUE(bounds.atMost(largestDifference(a, b), 1e-13 * largest(a)));
                        EXPECT_GT(largest(a), 0);
                    };
                    RealField a(dimensions, lattice.points());
                    RealField b(dimensions, lattice.points());
                    sums.gradient(u, 1, a);
                    convolutions.gradient(u, 1, b);
                    agree(a, b);
                    sums.laplacian(u, a);
                    convolutions.laplacian(u, b);
                    agree(a, b);
                    RealField scalarA(1, lattice.points());
                    RealField scalarB(1, lattice.points());
                    sums.divergence(u, scalarA);
                    convolutions.divergence(u, scalarB);
                    agree(scalarA, scalarB);
                }
            }
        }
    }
}

TEST(Operators, ResultsReplaceWhatWasThere)
{
    const Lattice lattice = test::unitSquare(8);
    const RealField u = test::noise(lattice, 2, 1);
    DirectSumOperators sums(lattice, KernelSamples(lattice, quinticSpline(1.3), LaplacianForm::morris));
    SpectralOperators convolutions = spectral(lattice, quinticSpline(1.3), LaplacianForm::morris);
    for (Operators* operators : std::initializer_list<Operators*>{&sums, &convolutions})
    {
        RealField once(2, lattice.points());
        RealField twice = test::noise(lattice, 2, 2);
        operators->gradient(u, 0, once);
        operators->gradient(u, 0, twice);
        EXPECT_EQ(largestDifference(once, twice), 0);
        operators->laplacian(u, once);
        operators->laplacian(u, twice);
        EXPECT_EQ(largestDifference(once, twice), 0);
        RealField scalarOnce(1, lattice.points());
        RealField scalarTwice = test::noise(lattice, 1, 2);
        operators->divergence(u, scalarOnce);
        operators->divergence(u, scalarTwice);
        EXPECT_EQ(largestDifference(scalarOnce, scalarTwice), 0);
    }
    EXPECT_EQ(sums.neighbours(), 45U) << "within 3.9 spacings";
}

TEST(Operators, SumsOverNeighboursHaveTheSameBitsForAnyNumberOfThreads)
{
    const Lattice lattice = periodicBox({10, 9, 12}, {1, 0.9, 1.2});
    const RealField u = test::noise(lattice, 3, 1);
    DirectSumOperators sums(lattice, KernelSamples(lattice, quinticSpline(1.3), LaplacianForm::morris));
    const int before = omp_get_max_threads();
    std::vector<RealField> results;
    for (const int threads : {1, 2, 3})
    {
        omp_set_num_threads(threads);
        results.emplace_back(3, lattice.points());
        sums.laplacian(u, results.back());
        EXPECT_EQ(largestDifference(results.back(), results.front()), 0);
    }
    omp_set_num_threads(before);
}

TEST(Operators, PlusMinusAndPlainGradientsAgree)
{
    test::Bounds bounds;
    // sum (f_b + f_a) W', sum (f_b - f_a) W' and sum f_b W' differ by f_a times the sum of the weights, which is zero.
    for (const Lattice& lattice : lattices())
    {
        for (const MakeKernel make : sampledKernels)
        {
            const KernelSamples samples(lattice, make(), LaplacianForm::exact);
            for (int d = 0; d < lattice.dimensions(); ++d)
            {
                const auto& weights = samples.gradient[static_cast<std::size_t>(d)];
                double sum = 0;
                double magnitude = 0;
                for (const double weight : weights)
                {
                    sum += weight;
                    magnitude += std::abs(weight);
                }
                EXPECT_TRUE(bounds.atMost(std::abs(sum), 1e-14 * magnitude)); // round-off of the sum
            }
        }
    }
}

TEST(Operators, OfConstantsAreZero)
{
    for (const Lattice& lattice : lattices())
    {
        const int dimensions = lattice.dimensions();
        const RealField one = test::fieldOf(lattice, dimensions, [](int c, double, double, double) { return 3 - c; });
        const auto vanish = [&](Operators& operators, double h)
        {
            RealField vector(dimensions, lattice.points());
            operators.gradient(one, 0, vector);
            EXPECT_LE(largest(vector), 1e-13 * 3 / h); // round-off of weights of some 1/h
            operators.laplacian(one, vector);
            EXPECT_LE(largest(vector), 1e-13 * 30 / (h * h));
            RealField scalar(1, lattice.points());
            operators.divergence(one, scalar);
            EXPECT_LE(largest(scalar), 1e-13 * 9 / h);
        };
        double dx = lattice.activeAxis(0).spacing();
        for (int d = 1; d < dimensions; ++d) { dx = std::min(dx, lattice.activeAxis(d).spacing()); }
        for (const MakeKernel make : sampledKernels)
        {
            for (const LaplacianForm form : {LaplacianForm::morris, LaplacianForm::secondDerivative})
            {
                DirectSumOperators sums(lattice, KernelSamples(lattice, make(), form));
                SpectralOperators convolutions = spectral(lattice, make(), form);
                vanish(sums, dx);
                vanish(convolutions, dx);
            }
        }
        for (const MakeKernel make : closedKernels)
        {
            SpectralOperators convolutions = spectral(lattice, make(), LaplacianForm::morris);
            vanish(convolutions, dx);
        }
    }
}

TEST(Operators, GradientIsMinusTheAdjointOfDivergence)
{
    for (const Lattice& lattice : lattices())
    {
        const int dimensions = lattice.dimensions();
        const RealField u = test::noise(lattice, dimensions, 3);
        const RealField p = test::noise(lattice, 1, 4);
        const auto adjoint = [&](Operators& operators)
        {
            RealField gradient(dimensions, lattice.points());
            RealField divergence(1, lattice.points());
            operators.gradient(p, 0, gradient);
            operators.divergence(u, divergence);
            const double scale =
                std::sqrt(dot(gradient, gradient) * dot(u, u)) + std::sqrt(dot(divergence, divergence) * dot(p, p));
            EXPECT_NEAR(dot(gradient, u) + dot(p, divergence), 0,
                        1e-14 * scale); // round-off of the operators and the dots
        };
        for (const MakeKernel make : sampledKernels)
        {
            DirectSumOperators sums(lattice, KernelSamples(lattice, make(), LaplacianForm::morris));
            SpectralOperators convolutions = spectral(lattice, make(), LaplacianForm::morris);
            adjoint(sums);
            adjoint(convolutions);
        }
        for (const MakeKernel make : closedKernels)
        {
            SpectralOperators convolutions = spectral(lattice, make(), LaplacianForm::morris);
            adjoint(convolutions);
        }
    }
}

TEST(Operators, LaplaciansAreSymmetricAndMorrisDamps)
{
    for (const Lattice& lattice : lattices())
    {
        const RealField a = test::noise(lattice, 1, 5);
        const RealField b = test::noise(lattice, 1, 6);
        RealField laplacianA(1, lattice.points());
        RealField laplacianB(1, lattice.points());
        for (const auto& kernels : {std::vector<MakeKernel>(sampledKernels.begin(), sampledKernels.end()),
                                    std::vector<MakeKernel>(closedKernels.begin(), closedKernels.end())})
        {
            for (const MakeKernel make : kernels)
            {
                SpectralOperators operators = spectral(lattice, make(), LaplacianForm::morris);
                operators.laplacian(a, laplacianA);
                operators.laplacian(b, laplacianB);
                const double scale = std::sqrt(dot(laplacianA, laplacianA) * dot(b, b));
                EXPECT_NEAR(dot(laplacianA, b), dot(a, laplacianB), 1e-14 * scale); // round-off
                EXPECT_LT(dot(a, laplacianA), 0);
            }
        }
    }
}

TEST(Operators, DerivativesOfRealFieldsAreReal)
{
    // Modes i d f must be those of a real field: a backward transform loses nothing of them, at Nyquist least of all.
    for (const Lattice& lattice :
         {periodicBox({8, 6, 1}, {1, 1, 0}), periodicBox({2, 2, 1}, {1, 1, 0}), periodicBox({6, 4, 8}, {1, 2, 3})})
    {
        for (const auto& kernels : {std::vector<MakeKernel>(sampledKernels.begin(), sampledKernels.end()),
                                    std::vector<MakeKernel>(closedKernels.begin(), closedKernels.end())})
        {
            for (const MakeKernel make : kernels)
            {
                const KernelSettings kernel = make();
                const bool closed = kernel.symbol == KernelSettings::Symbol::closed;
                const auto samples =
                    closed ? std::nullopt
                           : std::optional<KernelSamples>(std::in_place, lattice, kernel, LaplacianForm::exact);
                const DerivativeSymbol derivative(lattice, kernel, samples ? &*samples : nullptr);
                FourierTransform transform(lattice, 1);
                RealField real = test::noise(lattice, 1, 8);
                SpectralField modes(1, transform.modes());
                transform.forward(real, modes);
                const ModeRows& rows = derivative.rows();
                std::array<std::vector<double>, 3> d;
                for (auto& values : d) { values.resize(rows.length()); }
                for (int axis = 0; axis < lattice.dimensions(); ++axis)
                {
                    SpectralField slopes(1, transform.modes());
                    double scale = 0;
                    for (std::size_t row = 0; row < rows.count(); ++row)
                    {
                        derivative.row(row, 0, rows.length(), {d[0].data(), d[1].data(), d[2].data()});
                        for (std::size_t i = 0; i < rows.length(); ++i)
                        {
                            const double symbol = d[static_cast<std::size_t>(axis)][i];
                            slopes[0][rows.offset(row) + i] =
                                std::complex<double>(0, symbol) * modes[0][rows.offset(row) + i];
                            scale = std::max(scale, std::abs(slopes[0][rows.offset(row) + i]));
                        }
                    }
                    SpectralField before = copyOf(slopes);
                    transform.backward(slopes, real);
                    transform.forward(real, slopes);
                    for (std::size_t i = 0; i < transform.modes(); ++i)
                    {
                        const auto back = slopes[0][i] / static_cast<double>(lattice.points());
                        ASSERT_LE(std::abs(back - before[0][i]), 1e-14 * scale) << "round-off of two transforms";
                    }
                    real = test::noise(lattice, 1, 8);
                }
            }
        }
    }
}

TEST(Operators, DivergenceOfACurlIsZero)
{
    const Lattice lattice = periodicBox({10, 9, 12}, {1, 2, 1});
    const RealField a = test::noise(lattice, 3, 9);
    RealField curl(3, lattice.points());
    RealField divergence(1, lattice.points());
    for (const auto& kernels : {std::vector<MakeKernel>(sampledKernels.begin(), sampledKernels.end()),
                                std::vector<MakeKernel>(closedKernels.begin(), closedKernels.end())})
    {
        for (const MakeKernel make : kernels)
        {
            SpectralOperators operators = spectral(lattice, make(), LaplacianForm::exact);
            operators.curl(a, curl);
            operators.divergence(curl, divergence);
            // Derivatives of a lattice commute: round-off of |d| |curl|.
            EXPECT_LE(largest(divergence), 1e-13 * largest(curl) * 3 / lattice.activeAxis(0).spacing());
            EXPECT_GT(largest(curl), 0.1);
        }
    }
}

} // namespace
} // namespace isph
