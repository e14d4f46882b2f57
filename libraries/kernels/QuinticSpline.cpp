#include "kernels/QuinticSpline.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace isph
{

namespace
{

/// The spline is sum_c weight (radius - q)^5 over the pieces that q lies in.
struct Piece
{
    double radius;
    double weight;
};
constexpr std::array<Piece, 3> pieces{{{3, 1}, {2, -6}, {1, 15}}};

double normalisation(int dimensions)
{
    using std::numbers::pi;
    switch (dimensions)
    {
    case 1:
        return 1.0 / 120;
    case 2:
        return 7.0 / (478 * pi);
    default:
        return 1.0 / (120 * pi);
    }
}

/// Sum over the pieces of weight * term(radius - q).
template<class Term>
double sumOfPieces(double q, Term term)
{
    double total = 0;
    for (const Piece& piece : pieces)
    {
        if (q < piece.radius) { total += piece.weight * term(piece.radius - q); }
    }
    return total;
}

/// Up to here w = 66 - 60 q^2 + 30 q^4 - 10 q^5, whose quotients by q lose no digits.
constexpr double innerPiece = 1;

} // namespace

double QuinticSpline::w(double q, int dimensions) const
{
    return normalisation(dimensions) * sumOfPieces(q, [](double a) { return std::pow(a, 5); });
}

double QuinticSpline::f(double q, int dimensions) const
{
    if (q < innerPiece) { return normalisation(dimensions) * (-120 + 120 * q * q - 50 * q * q * q); }
    return normalisation(dimensions) * sumOfPieces(q, [](double a) { return -5 * std::pow(a, 4); }) / q;
}

double QuinticSpline::g(double q, int dimensions) const
{
    if (q < innerPiece) { return normalisation(dimensions) * (240 - 150 * q); }
    const double first = sumOfPieces(q, [](double a) { return -5 * std::pow(a, 4); });
    const double second = sumOfPieces(q, [](double a) { return 20 * std::pow(a, 3); });
    return normalisation(dimensions) * (second / (q * q) - first / (q * q * q));
}

double QuinticSpline::symbol(double) const { throw std::logic_error("the quintic spline has no closed symbol"); }
double QuinticSpline::morrisSymbol(double) const { throw std::logic_error("the quintic spline has no closed symbol"); }

} // namespace isph
