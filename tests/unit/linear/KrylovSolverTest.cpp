#include "fields/reductions.hpp"
#include "linear/BiCGStab.hpp"
#include "linear/ConjugateGradient.hpp"
#include "linear/SparseMatrix.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

namespace isph
{
namespace
{

/// Rows of (column, value) pairs.
SparseMatrix matrixOf(std::size_t columns, const std::vector<std::vector<std::pair<int, double>>>& rows)
{
    AlignedVector<int> starts{0};
    AlignedVector<int> indices;
    AlignedVector<double> values;
    for (const auto& row : rows)
    {
        for (const auto& [column, value] : row)
        {
            indices.push_back(column);
            values.push_back(value);
        }
        starts.push_back(static_cast<int>(values.size()));
    }
    return {columns, std::move(starts), std::move(indices), std::move(values)};
}

/// Minus the second difference on n points: of a ring (its null space are the constants) or between fixed ends.
SparseMatrix differences(int n, bool ring)
{
    std::vector<std::vector<std::pair<int, double>>> rows;
    for (int i = 0; i < n; ++i)
    {
        std::vector<std::pair<int, double>> row;
        if (ring && i == n - 1) { row.emplace_back(0, -1.0); }
        if (i > 0) { row.emplace_back(i - 1, -1.0); }
        row.emplace_back(i, 2.0);
        if (i < n - 1) { row.emplace_back(i + 1, -1.0); }
        if (ring && i == 0) { row.emplace_back(n - 1, -1.0); }
        rows.push_back(row);
    }
    return matrixOf(static_cast<std::size_t>(n), rows);
}

AlignedVector<double> noise(std::size_t n, unsigned seed)
{
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    AlignedVector<double> values(n);
    for (double& value : values) { value = uniform(engine); }
    return values;
}

double residualOf(const SparseMatrix& matrix, std::span<const double> x, std::span<const double> b)
{
    AlignedVector<double> r(b.size());
    matrix.apply(x, r);
    for (std::size_t i = 0; i < r.size(); ++i) { r[i] -= b[i]; }
    return std::sqrt(sumOfSquares(r) / sumOfSquares(b));
}

enum class Method
{
    cg,
    biCGStab
};

std::unique_ptr<KrylovSolver> make(Method method, std::size_t n, KrylovSettings settings, KrylovSpace space = {})
{
    if (method == Method::cg) { return std::make_unique<ConjugateGradient>(n, settings, space); }
    return std::make_unique<BiCGStab>(n, settings, space);
}

class Krylov : public testing::TestWithParam<Method>
{
};

INSTANTIATE_TEST_SUITE_P(Of, Krylov, testing::Values(Method::cg, Method::biCGStab),
                         [](const auto& method) { return method.param == Method::cg ? "CG" : "BiCGStab"; });

TEST_P(Krylov, ReachesTheToleranceAndSaysTheTrueResidual)
{
    const SparseMatrix matrix = differences(60, false);
    const auto b = noise(60, 1);
    AlignedVector<double> x(60);
    const auto solver = make(GetParam(), 60, {1e-10, 1000});
    const KrylovResult result = solver->solve(matrix, JacobiPreconditioner(matrix.diagonal()), b, x);
    EXPECT_TRUE(result.converged);
    EXPECT_DOUBLE_EQ(result.initialResidual, 1);
    EXPECT_LE(result.finalResidual, 1e-10);
    EXPECT_NEAR(result.finalResidual, residualOf(matrix, x, b), 1e-14);
    EXPECT_GT(result.iterations, 10);
}

TEST_P(Krylov, StartsFromTheValueItIsGiven)
{
    const SparseMatrix matrix = differences(60, false);
    const auto b = noise(60, 2);
    AlignedVector<double> x(60);
    const auto solver = make(GetParam(), 60, {1e-10, 1000});
    const JacobiPreconditioner jacobi(matrix.diagonal());
    const int first = solver->solve(matrix, jacobi, b, x).iterations;
    EXPECT_EQ(solver->solve(matrix, jacobi, b, x).iterations, 0);
    for (double& value : x) { value *= 1 + 1e-8; }
    const KrylovResult again = solver->solve(matrix, jacobi, b, x);
    EXPECT_LE(again.initialResidual, 1.1e-8);
    EXPECT_LT(again.iterations, first);
}

TEST_P(Krylov, DoesNotUseAStartValueWorseThanNone)
{
    const SparseMatrix matrix = differences(40, false);
    const auto b = noise(40, 3);
    const JacobiPreconditioner jacobi(matrix.diagonal());
    const auto solver = make(GetParam(), 40, {1e-10, 1000});
    AlignedVector<double> fromZero(40);
    AlignedVector<double> fromFar(40, 1e30);
    AlignedVector<double> fromNaN(40, std::numeric_limits<double>::quiet_NaN());
    solver->solve(matrix, jacobi, b, fromZero);
    EXPECT_DOUBLE_EQ(solver->solve(matrix, jacobi, b, fromFar).initialResidual, 1);
    EXPECT_DOUBLE_EQ(solver->solve(matrix, jacobi, b, fromNaN).initialResidual, 1);
    EXPECT_EQ(fromFar, fromZero);
    EXPECT_EQ(fromNaN, fromZero);
}

TEST_P(Krylov, TakesTheMeanOutWhereConstantsAreNull)
{
    const SparseMatrix matrix = differences(50, true);
    auto b = noise(50, 4);
    for (double& value : b) { value += 7; }
    AlignedVector<double> x(50, 3.0);
    const auto solver = make(GetParam(), 50, {1e-12, 1000}, {.constantNull = true});
    const KrylovResult result = solver->solve(matrix, IdentityPreconditioner(), b, x);
    EXPECT_TRUE(result.converged);
    EXPECT_NEAR(sum(x), 0, 1e-12);
    const double mean = sum(b) / 50;
    for (double& value : b) { value -= mean; }
    EXPECT_LE(residualOf(matrix, x, b), 1e-11);
}

TEST_P(Krylov, AConstantRightHandSideHasTheZeroSolution)
{
    const SparseMatrix matrix = differences(50, true);
    const AlignedVector<double> b(50, 0.1);
    AlignedVector<double> x(50, 3.0);
    const auto solver = make(GetParam(), 50, {1e-12, 1000}, {.constantNull = true});
    const KrylovResult result = solver->solve(matrix, IdentityPreconditioner(), b, x);
    EXPECT_TRUE(result.converged);
    EXPECT_EQ(result.iterations, 0);
    EXPECT_EQ(x, AlignedVector<double>(50));
}

TEST_P(Krylov, IsIndifferentToUnits)
{
    const SparseMatrix matrix = differences(30, false);
    const JacobiPreconditioner jacobi(matrix.diagonal());
    const auto solver = make(GetParam(), 30, {1e-10, 1000});
    const auto b = noise(30, 5);
    AlignedVector<double> x(30);
    const KrylovResult plain = solver->solve(matrix, jacobi, b, x);
    for (const int exponent : {-900, 900}) // squares of these would underflow and overflow
    {
        AlignedVector<double> scaled = b;
        for (double& value : scaled) { value = std::ldexp(value, exponent); }
        AlignedVector<double> y(30);
        const KrylovResult result = solver->solve(matrix, jacobi, scaled, y);
        EXPECT_EQ(result.iterations, plain.iterations);
        for (double& value : y) { value = std::ldexp(value, -exponent); }
        EXPECT_EQ(y, x);
    }
}

TEST_P(Krylov, StopsAtTheMostIterationsAndSaysSo)
{
    const SparseMatrix matrix = differences(200, false);
    const auto b = noise(200, 6);
    AlignedVector<double> x(200);
    const auto solver = make(GetParam(), 200, {1e-10, 7});
    const KrylovResult result = solver->solve(matrix, JacobiPreconditioner(matrix.diagonal()), b, x);
    EXPECT_FALSE(result.converged);
    EXPECT_EQ(result.iterations, 7);
    EXPECT_GT(result.finalResidual, 1e-10);
    EXPECT_LE(result.finalResidual, 1);
}

TEST_P(Krylov, DoesNotChaseWhatRoundOffForbids)
{
    const SparseMatrix matrix = differences(60, false);
    const auto b = noise(60, 7);
    AlignedVector<double> x(60);
    const auto solver = make(GetParam(), 60, {1e-30, 100000});
    const KrylovResult result = solver->solve(matrix, JacobiPreconditioner(matrix.diagonal()), b, x);
    EXPECT_FALSE(result.converged);
    EXPECT_LE(result.finalResidual, 1e-12);
    EXPECT_LT(result.iterations, 5000);
}

TEST_P(Krylov, AStricterToleranceLeavesNoLargerResidual)
{
    // A source of three waves on a ring of many neighbours is solved in a few iterations; going on, a recurrence drifts
    // along the null space.
    constexpr int n = 64;
    std::vector<std::vector<std::pair<int, double>>> rows(n);
    AlignedVector<double> b(n);
    for (int i = 0; i < n; ++i)
    {
        double all = 0;
        for (int distance = -12; distance <= 12; ++distance)
        {
            const double weight = distance == 0 ? 0 : std::exp(-distance * distance / 16.0);
            rows[static_cast<std::size_t>(i)].emplace_back((i + distance + n) % n, -weight);
            all += weight;
        }
        rows[static_cast<std::size_t>(i)][12].second = all;
        const double angle = 2 * std::numbers::pi * i / n;
        b[static_cast<std::size_t>(i)] = std::sin(2 * angle) + 0.3 * std::cos(3 * angle) + 0.1 * std::sin(4 * angle);
    }
    for (auto& row : rows) { std::ranges::sort(row); }
    const SparseMatrix matrix = matrixOf(n, rows);
    for (const double tolerance : {1e-12, 1e-16, 1e-20, 1e-300})
    {
        AlignedVector<double> x(n);
        const auto solver = make(GetParam(), n, {tolerance, 1000}, {.constantNull = true});
        const KrylovResult result = solver->solve(matrix, JacobiPreconditioner(matrix.diagonal()), b, x);
        EXPECT_LE(result.finalResidual, std::max(tolerance, 1e-14)) << tolerance;
        EXPECT_LT(result.iterations, 30) << tolerance;
    }
}

TEST_P(Krylov, SaysWhenTheRightHandSideIsNoNumber)
{
    const SparseMatrix matrix = differences(10, false);
    auto b = noise(10, 8);
    b[3] = std::numeric_limits<double>::quiet_NaN();
    AlignedVector<double> x(10, 1.0);
    const auto solver = make(GetParam(), 10, {});
    const KrylovResult result = solver->solve(matrix, IdentityPreconditioner(), b, x);
    EXPECT_FALSE(result.converged);
    EXPECT_TRUE(std::isnan(result.finalResidual));
    EXPECT_EQ(x, AlignedVector<double>(10));
}

TEST_P(Krylov, BreakdownsLeaveAFiniteSolutionNoWorseThanTheStart)
{
    // A quarter turn: r.Ar = 0 for every r, on which both recurrences break down at once.
    const SparseMatrix turn = matrixOf(2, {{{1, 1.0}}, {{0, -1.0}}});
    const AlignedVector<double> b{1.0, 2.0};
    AlignedVector<double> x(2);
    const auto solver = make(GetParam(), 2, {});
    const KrylovResult result = solver->solve(turn, IdentityPreconditioner(), b, x);
    EXPECT_FALSE(result.converged);
    EXPECT_LE(result.finalResidual, 1);
    EXPECT_TRUE(allFinite(x));
}

TEST(BiCGStab, SolvesWhatIsNotSymmetric)
{
    // Convection and diffusion: central differences at a cell Peclet number of 1.5.
    std::vector<std::vector<std::pair<int, double>>> rows;
    for (int i = 0; i < 50; ++i)
    {
        std::vector<std::pair<int, double>> row;
        if (i > 0) { row.emplace_back(i - 1, -1.75); }
        row.emplace_back(i, 2.0);
        if (i < 49) { row.emplace_back(i + 1, -0.25); }
        rows.push_back(row);
    }
    const SparseMatrix matrix = matrixOf(50, rows);
    const auto b = noise(50, 9);
    AlignedVector<double> x(50);
    const KrylovResult result =
        BiCGStab(50, {1e-10, 1000}).solve(matrix, JacobiPreconditioner(matrix.diagonal()), b, x);
    EXPECT_TRUE(result.converged);
    EXPECT_LE(residualOf(matrix, x, b), 1e-10);
}

TEST(ConjugateGradient, NeedsTheWeightsInWhichTheMatrixIsSymmetric)
{
    // Points on walls, mirrored: the second difference at an end has its neighbour twice.
    constexpr int n = 40;
    std::vector<std::vector<std::pair<int, double>>> rows;
    for (int i = 0; i < n; ++i)
    {
        std::vector<std::pair<int, double>> row;
        if (i > 0) { row.emplace_back(i - 1, i == n - 1 ? -2.0 : -1.0); }
        row.emplace_back(i, 2.0);
        if (i < n - 1) { row.emplace_back(i + 1, i == 0 ? -2.0 : -1.0); }
        rows.push_back(row);
    }
    const SparseMatrix matrix = matrixOf(n, rows);
    AlignedVector<double> weights(n, 1.0);
    weights.front() = weights.back() = 0.5;
    auto b = noise(n, 10);
    const double mean = sumOfProducts(b, weights) / sum(weights);
    for (double& value : b) { value -= mean; }
    AlignedVector<double> x(n);
    const KrylovResult result =
        ConjugateGradient(n, {1e-10, 1000}, {weights, true}).solve(matrix, IdentityPreconditioner(), b, x);
    EXPECT_TRUE(result.converged);
    EXPECT_LE(result.iterations, n); // as many as there are eigenvalues
    EXPECT_LE(residualOf(matrix, x, b), 2e-10);
    EXPECT_NEAR(sumOfProducts(x, weights), 0, 1e-12);
}

TEST(SparseMatrix, AppliesAndKnowsItsDiagonal)
{
    const SparseMatrix matrix = matrixOf(3, {{{0, 2.0}, {2, 1.0}}, {}});
    AlignedVector<double> y(2, 9.0);
    matrix.apply(AlignedVector<double>{1, 10, 100}, y);
    EXPECT_EQ(y, (AlignedVector<double>{102, 0}));
    EXPECT_EQ(matrix.diagonal(), (AlignedVector<double>{2, 0}));
    EXPECT_EQ(matrix.entries(), 2U);
    EXPECT_THROW(SparseMatrix(2, {0, 2}, {0}, {1.0}), std::logic_error);
}

TEST(JacobiPreconditioner, CountsZerosAsOnes)
{
    AlignedVector<double> z(3);
    JacobiPreconditioner({2, 0, 1e-320}).apply(AlignedVector<double>{1, 1, 1}, z);
    EXPECT_EQ(z, (AlignedVector<double>{0.5, 1, 1}));
}

} // namespace
} // namespace isph
