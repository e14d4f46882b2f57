#include "poisson/eigenvalues.hpp"

#include "support/kernels.hpp"
#include "support/periodicBox.hpp"

#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>
#include <optional>
#include <stdexcept>
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

/// Calls visit(mode, multiplicity, k, d) for every mode.
template<class Visit>
void forEachMode(const DerivativeSymbol& derivative, Visit visit)
{
    const ModeRows& rows = derivative.rows();
    std::array<std::vector<double>, 3> d;
    for (auto& values : d) { values.assign(rows.length(), 0.0); }
    for (std::size_t row = 0; row < rows.count(); ++row)
    {
        derivative.row(row, 0, rows.length(), {d[0].data(), d[1].data(), d[2].data()});
        for (std::size_t i = 0; i < rows.length(); ++i)
        {
            std::array<double, 3> k{rows.wavenumbers().k[0][i], 0, 0};
            for (int axis = 1; axis < rows.dimensions(); ++axis)
            {
                k[static_cast<std::size_t>(axis)] = rows.k(row, axis);
            }
            visit(rows.offset(row) + i, rows.multiplicity(i), k, std::array<double, 3>{d[0][i], d[1][i], d[2][i]});
        }
    }
}

double square(const std::array<double, 3>& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

TEST(PoissonEigenvalues, AreTheirDefinitions)
{
    for (const Lattice& lattice :
         {periodicBox({12, 9, 1}, {1, 2, 0}), periodicBox({1, 8, 6}, {0, 1, 500}), periodicBox({6, 8, 5}, {1, 2, 3})})
    {
        for (const auto make : {+[] { return sampledGaussian(4, 1.5, 5); }, +[] { return closedGaussian(10, 1.5); }})
        {
            const DerivativeSymbol derivative = derivativeOf(lattice, make());
            const auto table = [&](Eigenvalues form) { return poissonEigenvalues(lattice, form, derivative, {}); };
            const auto consistent = table(Eigenvalues::consistent);
            const auto exact = table(Eigenvalues::exact);
            const auto second = table(Eigenvalues::secondOrder);
            const auto fourth = table(Eigenvalues::fourthOrder);
            forEachMode(derivative,
                        [&](std::size_t mode, double, const auto& k, const auto& d)
                        {
                            EXPECT_DOUBLE_EQ(consistent[mode], square(d));
                            EXPECT_DOUBLE_EQ(exact[mode], square(k));
                            double three = 0;
                            double five = 0;
                            double largest = 0;
                            for (int axis = 0; axis < lattice.dimensions(); ++axis)
                            {
                                const double dx = lattice.activeAxis(axis).spacing();
                                const double theta = k[static_cast<std::size_t>(axis)] * dx;
                                three += (2 - 2 * std::cos(theta)) / (dx * dx);
                                five += (30 - 32 * std::cos(theta) + 2 * std::cos(2 * theta)) / (12 * dx * dx);
                                largest = std::max(largest, 64 / (12 * dx * dx));
                            }
                            // The plain formulas cancel: round-off of their largest terms.
                            EXPECT_NEAR(second[mode], three, 1e-15 * largest);
                            EXPECT_NEAR(fourth[mode], five, 1e-15 * largest);
                        });
        }
    }
}

TEST(PoissonEigenvalues, OfDifferencesKeepTheirDigitsForLongWaves)
{
    // Longest wave of 10^4 points: k dx = 6e-4, errors (k dx)^2/12 and (k dx)^4/90.
    const Lattice lattice = periodicBox({4, 10000, 1}, {4e-4, 1, 0});
    const DerivativeSymbol derivative = derivativeOf(lattice, exactKernel());
    const double k = 2 * pi;
    const double theta2 = std::pow(k * 1e-4, 2);
    const std::size_t mode = derivative.rows().offset(1);
    const auto second = poissonEigenvalues(lattice, Eigenvalues::secondOrder, derivative, {});
    const auto fourth = poissonEigenvalues(lattice, Eigenvalues::fourthOrder, derivative, {});
    EXPECT_NEAR(second[mode] / (k * k), 1 - theta2 / 12, 1e-14);
    EXPECT_NEAR(fourth[mode] / (k * k), 1 - theta2 * theta2 / 90, 1e-14);
}

TEST(PoissonEigenvalues, OfMorrisAreItsTable)
{
    const Lattice lattice = unitSquare(8);
    const KernelSettings kernel = closedGaussian(4, 1.5);
    const DerivativeSymbol derivative = derivativeOf(lattice, kernel);
    const auto morris = laplacianSymbol(lattice, kernel, LaplacianForm::morris, nullptr);
    EXPECT_EQ(poissonEigenvalues(lattice, Eigenvalues::morris, derivative, morris), morris);
    EXPECT_THROW(poissonEigenvalues(lattice, Eigenvalues::morris, derivative, {}), std::logic_error);
}

/// ||div u|| after one projection over that before, expected of white noise.
double residualDivergence(const KernelSettings& kernel, Eigenvalues form)
{
    const Lattice lattice = unitSquare(64);
    const DerivativeSymbol derivative = derivativeOf(lattice, kernel);
    const auto inverse = invertedEigenvalues(derivative.rows(), poissonEigenvalues(lattice, form, derivative, {}));
    double before = 0;
    double after = 0;
    forEachMode(derivative,
                [&](std::size_t mode, double multiplicity, const auto&, const auto& d)
                {
                    const double left = 1 - square(d) * inverse[mode];
                    before += multiplicity * square(d);
                    after += multiplicity * square(d) * left * left;
                });
    return std::sqrt(after / before);
}

TEST(PoissonEigenvalues, LeaveTheDivergenceOfTheTheory)
{
    struct Row
    {
        KernelSettings kernel;
        double exact;
        double second;
        double fourth;
    };
    std::vector<Row> table; // printed to two digits, for one draw of noise; here for its expectation
    table.push_back({quinticSpline(2), 0.75, 0.77, 0.76});
    table.push_back({sampledGaussian(4, 2, 4), 0.65, 0.64, 0.67});
    table.push_back({closedGaussian(10, 1.5), 0.48, 0.37, 0.42});
    // -k^2 under an exact derivative fails on the Nyquist lines only: 3 (pi/8 - 1/4)/64 of the squares.
    table.push_back({exactKernel(), 0.082, 0.73, 0.38});
    for (const auto& [kernel, exact, second, fourth] : table)
    {
        EXPECT_NEAR(residualDivergence(kernel, Eigenvalues::exact), exact, 0.02 * exact + 0.005);
        EXPECT_NEAR(residualDivergence(kernel, Eigenvalues::secondOrder), second, 0.02 * second + 0.005);
        EXPECT_NEAR(residualDivergence(kernel, Eigenvalues::fourthOrder), fourth, 0.02 * fourth + 0.005);
        EXPECT_LE(residualDivergence(kernel, Eigenvalues::consistent), 1e-15) << "round-off";
    }
}

TEST(PoissonEigenvalues, MismatchedOnesLeaveAndAddDivergence)
{
    // What is left of mode (1, 1), exact k^2: closed G4 and the quintic spline at h/dx = 2, 64 points.
    const auto left = [](const KernelSettings& kernel, Eigenvalues form)
    {
        const Lattice lattice = unitSquare(64);
        const DerivativeSymbol derivative = derivativeOf(lattice, kernel);
        const auto inverse = invertedEigenvalues(derivative.rows(), poissonEigenvalues(lattice, form, derivative, {}));
        double low = 0;
        double largest = 0;
        forEachMode(derivative,
                    [&](std::size_t mode, double, const auto&, const auto& d)
                    {
                        const double share = std::abs(1 - square(d) * inverse[mode]);
                        if (mode == derivative.rows().offset(1) + 1) { low = share; }
                        if (square(d) > 0) { largest = std::max(largest, share); }
                    });
        return std::pair{low, largest};
    };
    EXPECT_NEAR(left(closedGaussian(4, 2), Eigenvalues::exact).first, 3.7e-4, 0.05e-4);
    EXPECT_NEAR(left(quinticSpline(2), Eigenvalues::exact).first, 3.7e-2, 0.05e-2);
    EXPECT_NEAR(left(closedGaussian(20, 1.3), Eigenvalues::secondOrder).second, 1.29, 0.005) << "grows";
    EXPECT_NEAR(left(exactKernel(), Eigenvalues::secondOrder).second, 1.32, 0.005) << "grows";
}

TEST(InvertedEigenvalues, AreZeroForNullModesOnly)
{
    // Aspect ratio 1000: the smallest |D|^2 is 12 decades or more below the largest, and yet no null mode.
    for (const Lattice& lattice : {periodicBox({32, 32, 1}, {1000, 1, 0}), periodicBox({8, 64, 1}, {1, 1000, 0}),
                                   periodicBox({8, 6, 4}, {1000, 1, 30})})
    {
        for (const auto make : {+[] { return exactKernel(); }, +[] { return closedGaussian(4, 1.3); },
                                +[] { return sampledGaussian(4, 1.5, 5); }, +[] { return quinticSpline(1.3); }})
        {
            const DerivativeSymbol derivative = derivativeOf(lattice, make());
            for (const Eigenvalues form :
                 {Eigenvalues::consistent, Eigenvalues::exact, Eigenvalues::secondOrder, Eigenvalues::fourthOrder})
            {
                const auto values = poissonEigenvalues(lattice, form, derivative, {});
                const auto inverse = invertedEigenvalues(derivative.rows(), values);
                int nulls = 0;
                forEachMode(derivative,
                            [&](std::size_t mode, double, const auto& k, const auto& d)
                            {
                                const double value = form == Eigenvalues::consistent ? square(d) : square(k);
                                if (value == 0)
                                {
                                    EXPECT_EQ(inverse[mode], 0);
                                    ++nulls;
                                }
                                else { EXPECT_NEAR(inverse[mode] * values[mode], 1, 1e-15); }
                            });
                const int corners = 1 << lattice.dimensions(); // the mean, and where every wavenumber is 0 or Nyquist's
                EXPECT_EQ(nulls, form == Eigenvalues::consistent ? corners : 1);
            }
        }
    }
}

TEST(InvertedEigenvalues, TakeWhatAWideKernelCannotSeeForNull)
{
    // h/dx = 5: at the highest modes Q is far below 1e-12, and an inverse would be made of round-off.
    const Lattice lattice = unitSquare(16);
    const DerivativeSymbol derivative = derivativeOf(lattice, closedGaussian(2, 5));
    const auto inverse =
        invertedEigenvalues(derivative.rows(), poissonEigenvalues(lattice, Eigenvalues::consistent, derivative, {}));
    forEachMode(derivative,
                [&](std::size_t mode, double, const auto& k, const auto& d)
                {
                    const bool seen = std::sqrt(square(d)) > 1e-12 * std::sqrt(square(k));
                    EXPECT_EQ(inverse[mode] > 0, seen);
                });
}

TEST(EigenvalueForms, AreListed)
{
    EXPECT_THAT(eigenvalueForms().names(),
                testing::ElementsAre("consistent", "exact", "morris", "secondOrder", "fourthOrder"));
}

} // namespace
} // namespace isph
