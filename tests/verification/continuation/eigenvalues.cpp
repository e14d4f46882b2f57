#include "continuation/Polynomial.hpp"
#include "continuation/SmoothGram.hpp"
#include "support/boundedLine.hpp"
#include "support/record.hpp"

#include <algorithm>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>
#include <numbers>

namespace isph
{
namespace
{

struct Matrices
{
    Eigen::MatrixXd first;
    Eigen::MatrixXd second;
};

Matrices matricesOf(int N, const Continuation& continuation, const KernelSettings& kernel)
{
    BoundedLine line(N, continuation, kernel);
    Matrices matrices{Eigen::MatrixXd(N + 1, N + 1), Eigen::MatrixXd(N + 1, N + 1)};
    std::vector<double> unit(static_cast<std::size_t>(N + 1));
    for (int column = 0; column <= N; ++column)
    {
        std::ranges::fill(unit, 0.0);
        unit[static_cast<std::size_t>(column)] = 1;
        const auto derivatives = line.of(unit);
        for (int row = 0; row <= N; ++row)
        {
            matrices.first(row, column) = derivatives.first[static_cast<std::size_t>(row)];
            matrices.second(row, column) = derivatives.second[static_cast<std::size_t>(row)];
        }
    }
    return matrices;
}

/// Eigenvalues of the second derivative with both wall values zero.
Eigen::VectorXcd diffusion(int N, const Continuation& continuation, const KernelSettings& kernel)
{
    return matricesOf(N, continuation, kernel).second.block(1, 1, N - 1, N - 1).eigenvalues();
}

/// Largest real part of minus the first derivative with the inflow value zero, times the spacing.
double advection(int N, const Continuation& continuation, const KernelSettings& kernel)
{
    const Eigen::MatrixXd matrix = -matricesOf(N, continuation, kernel).first.block(1, 1, N, N);
    return matrix.eigenvalues().real().maxCoeff() / N;
}

TEST(Eigenvalues, OfDiffusionAreRealAndNegativeByDefault)
{
    test::Bounds bounds;
    const int N = 64;
    for (const int degree : {3, 4})
    {
        const Eigen::VectorXcd values = diffusion(N, SmoothGram(25, degree), exactKernel());
        const double largest = values.real().maxCoeff();
        const double pi2 = std::numbers::pi * std::numbers::pi;
        EXPECT_TRUE(bounds.near(largest, -pi2, 1e-6 * pi2)) << degree;
        EXPECT_TRUE(bounds.atMost(values.imag().cwiseAbs().maxCoeff(), 1e-9 * values.cwiseAbs().maxCoeff())) << degree;
        // The spectral radius is what limits an explicit step.
        EXPECT_TRUE(bounds.near(-values.real().minCoeff() / (pi2 * N * N), 0.99, 0.02)) << degree;
    }
}

TEST(Eigenvalues, OfAdvectionHaveTheMeasuredMargins)
{
    test::Bounds bounds;
    EXPECT_LE(advection(64, SmoothGram(25, 3), exactKernel()), 0);
    EXPECT_LE(advection(64, SmoothGram(25, 3), gaussianKernel(4)), 0);
    EXPECT_LE(advection(64, SmoothGram(25, 4), exactKernel()), 0);
    EXPECT_TRUE(bounds.near(advection(64, SmoothGram(25, 4), gaussianKernel(4)), 1.0e-2, 1e-3));
    EXPECT_TRUE(bounds.near(advection(64, SmoothGram(25, 5), exactKernel()), 1.8e-2, 1e-3));
    EXPECT_TRUE(bounds.near(advection(64, SmoothGram(25, 6), exactKernel()), 1.2e-1, 1e-2));
}

TEST(Eigenvalues, OfThePublishedContinuationGrowWithFewPoints)
{
    // Degree 5, quintic, an extension of a quarter: under kernels of order 4 and 8; 7 points at once, 8 on finer
    // lattices.
    for (const int N : {64, 128})
    {
        EXPECT_GT(diffusion(N, Polynomial(N / 4, 5, 7), gaussianKernel(4)).real().maxCoeff(), 4e3) << N;
        EXPECT_GT(diffusion(N, Polynomial(N / 4, 5, 7), gaussianKernel(8)).real().maxCoeff(), 3e4) << N;
    }
    EXPECT_LT(diffusion(64, Polynomial(16, 5, 8), gaussianKernel(4)).real().maxCoeff(), 0);
    EXPECT_NEAR(diffusion(128, Polynomial(32, 5, 8), gaussianKernel(4)).real().maxCoeff(), 8e4, 1e4);
    EXPECT_GT(diffusion(128, Polynomial(32, 5, 8), gaussianKernel(8)).real().maxCoeff(), 2e4);
    // With an extension as long as the interval, even the exact derivative.
    EXPECT_GT(diffusion(128, Polynomial(128, 5, 8), exactKernel()).real().maxCoeff(), 1e5);
    // A quarter of the interval is stable.
    EXPECT_LT(diffusion(64, Polynomial(16, 5, 16), exactKernel()).real().maxCoeff(), 0);
    EXPECT_LT(diffusion(128, Polynomial(32, 5, 32), exactKernel()).real().maxCoeff(), 0);
    EXPECT_LT(diffusion(128, Polynomial(32, 5, 32), gaussianKernel(4)).real().maxCoeff(), 0);
}

} // namespace
} // namespace isph
