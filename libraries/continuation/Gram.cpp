#include "continuation/Gram.hpp"

#include "continuation/DoubleDouble.hpp"
#include "core/Error.hpp"

#include <string>
#include <utility>

namespace isph
{

namespace
{

/// Columns one after the other.
struct Matrix
{
    Matrix(int rowCount, int columnCount)
        : rows(rowCount), columns(columnCount), values(static_cast<std::size_t>(rowCount * columnCount))
    {
    }
    DoubleDouble& operator()(int row, int column) { return values[static_cast<std::size_t>(column * rows + row)]; }

    int rows;
    int columns;
    std::vector<DoubleDouble> values;
};

/// cos and sin of 2 pi numerator/denominator, by their series for angles below pi/4 and doubling.
std::pair<DoubleDouble, DoubleDouble> cosineAndSine(long numerator, long denominator)
{
    const DoubleDouble twoPi(6.283185307179586, 2.4492935982947064e-16);
    constexpr int doublings = 3;
    const DoubleDouble angle = twoPi * DoubleDouble(static_cast<double>(numerator % denominator)) /
                               DoubleDouble(static_cast<double>(denominator << doublings));
    DoubleDouble cosineLess1 = 0; // cos - 1 keeps the digits that doubling a cosine would lose
    DoubleDouble sine = angle;
    DoubleDouble term = angle;
    for (int n = 2; n < 40; ++n)
    {
        term = term * angle / DoubleDouble(n);
        const DoubleDouble next = n % 4 < 2 ? term : -term;
        if (n % 2 == 0) { cosineLess1 = cosineLess1 + next; }
        else { sine = sine + next; }
    }
    for (int doubling = 0; doubling < doublings; ++doubling)
    {
        const DoubleDouble doubledSine = DoubleDouble(2) * sine * (cosineLess1 + DoubleDouble(1));
        cosineLess1 = -(DoubleDouble(2) * sine * sine);
        sine = doubledSine;
    }
    return {cosineLess1 + DoubleDouble(1), sine};
}

/// Makes the columns of A upper triangular by Householder reflections, those of B with them, and solves; the first
/// A.columns rows of B become the least-squares solution.
void solveLeastSquares(Matrix& A, Matrix& B)
{
    const auto reflect = [](Matrix& of, int column, int from, const std::vector<DoubleDouble>& v, DoubleDouble scale)
    {
        DoubleDouble product = 0;
        for (int row = from; row < of.rows; ++row)
        {
            product = product + v[static_cast<std::size_t>(row)] * of(row, column);
        }
        product = product * scale;
        for (int row = from; row < of.rows; ++row)
        {
            of(row, column) = of(row, column) - product * v[static_cast<std::size_t>(row)];
        }
    };
    std::vector<DoubleDouble> v(static_cast<std::size_t>(A.rows));
    for (int j = 0; j < A.columns; ++j)
    {
        DoubleDouble squares = 0;
        for (int row = j; row < A.rows; ++row)
        {
            v[static_cast<std::size_t>(row)] = A(row, j);
            squares = squares + A(row, j) * A(row, j);
        }
        const DoubleDouble norm = squareRoot(squares);
        const DoubleDouble head = v[static_cast<std::size_t>(j)];
        const DoubleDouble signedNorm = head.rounded() < 0 ? -norm : norm;
        v[static_cast<std::size_t>(j)] = head + signedNorm;
        const DoubleDouble scale = DoubleDouble(1) / (squares + signedNorm * head); // 2/|v|^2
        for (int column = j; column < A.columns; ++column) { reflect(A, column, j, v, scale); }
        for (int column = 0; column < B.columns; ++column) { reflect(B, column, j, v, scale); }
    }
    for (int column = 0; column < B.columns; ++column)
    {
        for (int j = A.columns - 1; j >= 0; --j)
        {
            DoubleDouble rest = B(j, column);
            for (int k = j + 1; k < A.columns; ++k) { rest = rest - A(j, k) * B(k, column); }
            B(j, column) = rest / A(j, j);
        }
    }
}

/// Polynomials of degree 0, 1, ... that are orthonormal on the points, at places oversampling times as dense.
Matrix gramPolynomials(int points, int oversampling)
{
    const int last = (points - 1) * oversampling;
    Matrix polynomials(last + 1, points);
    for (int i = 0; i < points; ++i)
    {
        for (int node = 0; node <= last; ++node)
        {
            const DoubleDouble t = DoubleDouble(2 * node - last) / DoubleDouble(last);
            polynomials(node, i) = i == 0 ? DoubleDouble(1) : t * polynomials(node, i - 1);
        }
        // Twice: once loses digits where the columns are nearly parallel.
        for (int pass = 0; pass < 2; ++pass)
        {
            for (int lower = 0; lower < i; ++lower)
            {
                DoubleDouble product = 0;
                for (int node = 0; node <= last; node += oversampling)
                {
                    product = product + polynomials(node, i) * polynomials(node, lower);
                }
                for (int node = 0; node <= last; ++node)
                {
                    polynomials(node, i) = polynomials(node, i) - product * polynomials(node, lower);
                }
            }
        }
        DoubleDouble squares = 0;
        for (int node = 0; node <= last; node += oversampling)
        {
            squares = squares + polynomials(node, i) * polynomials(node, i);
        }
        const DoubleDouble norm = squareRoot(squares);
        for (int node = 0; node <= last; ++node) { polynomials(node, i) = polynomials(node, i) / norm; }
    }
    return polynomials;
}

} // namespace

Gram::Gram(int newPoints, int degree) : Continuation(newPoints), points_(degree + 1)
{
    if (degree < 2 || degree > 8)
    {
        throw Error(Fault::input, "degree " + std::to_string(degree) + " is not one of 2 ... 8");
    }
    if (newPoints < leastNewPoints || newPoints > largestNewPoints)
    {
        throw Error(Fault::input, "an extension of " + std::to_string(newPoints) + " points has no table of FC(Gram)",
                    "write auto, or " + std::to_string(leastNewPoints) + " ... " + std::to_string(largestNewPoints));
    }

    // Along one period: the points, the new points, a zone where the polynomial is zero, and one that is left free.
    constexpr int oversampling = 20;
    constexpr double regularisation = 1e-29; // nothing but a guard: larger ones cost accuracy
    const int zeros = newPoints / 2;
    const int period = points_ + newPoints + zeros + newPoints;
    const int largestWavenumber = (period - 4) / 2;
    const int columns = 2 * largestWavenumber + 1;
    const int matched = (points_ - 1) * oversampling + 1;
    const int zeroed = (zeros - 1) * oversampling + 1;

    const auto basis = [period](int column, long place, long placesPerPoint)
    {
        const long wavenumber = (column + 1) / 2;
        const auto [cosine, sine] = cosineAndSine(wavenumber * place, period * placesPerPoint);
        return column % 2 == 1 ? sine : cosine;
    };
    Matrix A(matched + zeroed + columns, columns);
    Matrix B(A.rows, points_);
    Matrix polynomials = gramPolynomials(points_, oversampling);
    for (int column = 0; column < columns; ++column)
    {
        for (int row = 0; row < matched + zeroed; ++row)
        {
            const int place = row < matched ? row : (points_ + newPoints) * oversampling + row - matched;
            A(row, column) = basis(column, place, oversampling);
        }
        A(matched + zeroed + column, column) = regularisation;
    }
    for (int i = 0; i < points_; ++i)
    {
        for (int row = 0; row < matched; ++row) { B(row, i) = polynomials(row, i); }
    }
    solveLeastSquares(A, B);

    for (int k = 1; k <= newPoints; ++k)
    {
        std::vector<DoubleDouble> continued(static_cast<std::size_t>(points_)); // of each polynomial
        for (int column = 0; column < columns; ++column)
        {
            const DoubleDouble value = basis(column, points_ - 1 + k, 1);
            for (int i = 0; i < points_; ++i)
            {
                auto& sum = continued[static_cast<std::size_t>(i)];
                sum = sum + value * B(column, i);
            }
        }
        for (int c = 0; c < points_; ++c)
        {
            DoubleDouble weight = 0;
            for (int i = 0; i < points_; ++i)
            {
                weight =
                    weight + continued[static_cast<std::size_t>(i)] * polynomials((points_ - 1 - c) * oversampling, i);
            }
            weights_.push_back(weight.rounded());
        }
    }
}

EndBlock Gram::end(EndCondition condition) const
{
    if (condition == EndCondition::neumann)
    {
        throw Error(Fault::input, "FC(Gram) tables continue values, not derivatives at the wall",
                    "choose smoothGram, polynomial or mirror");
    }
    return {newPoints(), points_, weights_, {}};
}

} // namespace isph
