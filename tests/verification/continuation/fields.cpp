#include "operators/ContinuedOperators.hpp"

#include "continuation/SmoothGram.hpp"
#include "operators/SpectralOperators.hpp"
#include "support/boundedLine.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

namespace isph
{
namespace
{

constexpr double pi = std::numbers::pi;

Axis axisOf(char name, int count, bool bounded)
{
    return {name, 0, 1, count, bounded ? Axis::Ends::bounded : Axis::Ends::periodic, false};
}

template<class Function>
void evaluate(const Lattice& lattice, Function f, std::span<double> values)
{
    const auto at = lattice.coordinates();
    for (std::size_t n = 0; n < values.size(); ++n) { values[n] = f(at[0][n], at[1][n], at[2][n]); }
}

double largestDifference(std::span<const double> a, std::span<const double> b)
{
    double largest = 0;
    for (std::size_t n = 0; n < a.size(); ++n) { largest = std::max(largest, std::abs(a[n] - b[n])); }
    return largest;
}

TEST(ContinuedOperators, AreThoseOfAPeriodicBoxWhereThereAreNoWalls)
{
    const Lattice lattice({axisOf('x', 24, false), axisOf('y', 20, false), Axis{'z', 0, 0, 1}}, {});
    RealField f(1, lattice.points());
    // The kernel of each axis acts on that axis alone: a function of one coordinate sees the same either way.
    evaluate(
        lattice, [](double x, double y, double) { return std::sin(2 * pi * x) + std::cos(6 * pi * y); }, f[0]);
    ContinuedOperators lines(lattice, {}, gaussianKernel(6));
    const KernelSettings kernel = gaussianKernel(6);
    SpectralOperators box(lattice, DerivativeSymbol(lattice, kernel, nullptr),
                          laplacianSymbol(lattice, kernel, LaplacianForm::secondDerivative, nullptr));
    RealField gradient(2, lattice.points());
    RealField expected(2, lattice.points());
    lines.gradient(f, 0, gradient);
    box.gradient(f, 0, expected);
    for (int d = 0; d < 2; ++d) { EXPECT_LT(largestDifference(gradient[d], expected[d]), 1e-12); }
    RealField laplacian(1, lattice.points());
    RealField expectedLaplacian(1, lattice.points());
    lines.laplacian(f, laplacian);
    box.laplacian(f, expectedLaplacian);
    EXPECT_LT(largestDifference(laplacian[0], expectedLaplacian[0]), 1e-10);
}

TEST(ContinuedOperators, ConvergeInThreeDimensionsWithWallsOnTwoAxes)
{
    // L2 orders 4.5 and 3.5; the largest error, at walls, falls with 4 and 3.
    const auto errors = [](int N)
    {
        const Lattice lattice({axisOf('x', 8, false), axisOf('y', N + 1, true), axisOf('z', N + 1, true)}, {});
        Continuations continuations;
        continuations[1] = std::make_unique<SmoothGram>(automaticNewPoints(N + 1));
        continuations[2] = std::make_unique<SmoothGram>(automaticNewPoints(N + 1));
        ContinuedOperators operators(lattice, continuations, exactKernel());
        RealField u(3, lattice.points());
        evaluate(
            lattice, [](double x, double y, double z) { return std::sin(2 * pi * x) * std::exp(y) * z; }, u[0]);
        evaluate(
            lattice, [](double x, double y, double z) { return std::cos(2 * pi * x) * std::sin(5 * y) * z; }, u[1]);
        evaluate(
            lattice, [](double, double y, double z) { return y * std::exp(y) * std::sin(4 * z); }, u[2]);
        RealField divergence(1, lattice.points());
        RealField expected(1, lattice.points());
        operators.divergence(u, divergence);
        evaluate(
            lattice,
            [](double x, double y, double z)
            {
                return 2 * pi * std::cos(2 * pi * x) * std::exp(y) * z +
                       5 * std::cos(2 * pi * x) * std::cos(5 * y) * z + 4 * y * std::exp(y) * std::cos(4 * z);
            },
            expected[0]);
        const double first = largestDifference(divergence[0], expected[0]);
        RealField laplacian(3, lattice.points());
        operators.laplacian(u, laplacian);
        evaluate(
            lattice, [](double, double y, double z) { return (2 + y - 16 * y) * std::exp(y) * std::sin(4 * z); },
            expected[0]);
        return BoundedLine::Errors{first, largestDifference(laplacian[2], expected[0])};
    };
    const auto coarse = errors(24);
    const auto fine = errors(48);
    EXPECT_GT(std::log2(coarse.first / fine.first), 3.7);
    EXPECT_GT(std::log2(coarse.second / fine.second), 2.7);
    EXPECT_LT(fine.first, 1e-3);
}

} // namespace
} // namespace isph
