#include "kernels/Gaussian.hpp"

#include "core/Error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace isph
{

namespace
{

/// Generalised Laguerre polynomial L_degree^{(alpha)}(x) by its three-term recurrence.
double laguerre(int degree, double alpha, double x)
{
    double previous = 0;
    double value = 1;
    for (int m = 1; m <= degree; ++m)
    {
        const double next = ((2.0 * m - 1 + alpha - x) * value - (m - 1 + alpha) * previous) / m;
        previous = value;
        value = next;
    }
    return value;
}

double weight(double q, int dimensions) { return std::pow(std::numbers::pi, -0.5 * dimensions) * std::exp(-q * q); }

} // namespace

double upperGamma(int n, double s)
{
    if (n <= 0) { return 0; }
    if (s < 0.5 * n) { return 1 - lowerGamma(n, s); }
    double term = std::exp(-s);
    double total = term;
    for (int m = 1; m < n; ++m)
    {
        term *= s / m;
        total += term;
    }
    return total;
}

double lowerGamma(int n, double s)
{
    if (n <= 0) { return 1; }
    if (s <= 0) { return 0; }
    if (s > n + 1.0) { return 1 - upperGamma(n, s); }
    // exp(-s) s^n/n! (1 + s/(n+1) + ...): every term is positive, and factor by factor the first loses no digits.
    double term = std::exp(-s);
    for (int m = 1; m <= n; ++m) { term *= s / m; }
    double total = term;
    for (int m = n + 1; term > 1e-18 * total; ++m)
    {
        term *= s / m;
        total += term;
    }
    return total;
}

Gaussian::Gaussian(int order) : n_(order / 2)
{
    if (order < 2 || order > largestOrder || order % 2 != 0)
    {
        throw Error(Fault::input,
                    "is " + std::to_string(order) + " but must be even, from 2 to " + std::to_string(largestOrder),
                    "a symmetric kernel has an even order: write e.g. order 4;");
    }
}

double Gaussian::w(double q, int dimensions) const
{
    return weight(q, dimensions) * laguerre(n_ - 1, 0.5 * dimensions, q * q);
}

double Gaussian::f(double q, int dimensions) const
{
    return -2 * weight(q, dimensions) * laguerre(n_ - 1, 0.5 * dimensions + 1, q * q);
}

double Gaussian::g(double q, int dimensions) const
{
    return 4 * weight(q, dimensions) * laguerre(n_ - 1, 0.5 * dimensions + 2, q * q);
}

double Gaussian::supportRadius() const { return order() <= 4 ? 5 : order() <= 10 ? 6 : 7; }

double Gaussian::symbol(double s) const { return upperGamma(n_, s); }

double Gaussian::morrisSymbol(double s) const
{
    // -(4/h^2) sum_{j=1..n} P(j, s) over -k^2 = -4 s/h^2, in the form that loses no digits for small s.
    return s > 0 ? upperGamma(n_ - 1, s) + n_ * lowerGamma(n_, s) / s : 1;
}

double Gaussian::largestDerivative() const
{
    // d/ds [sqrt(s) Q(n, s)] = 0: Q/(2s) = s^(n-1) exp(-s)/(n-1)!; one sign change between 0 and n + 1.
    const auto slope = [this](double s)
    { return 0.5 * upperGamma(n_, s) - std::exp(-s + n_ * std::log(s) - std::lgamma(static_cast<double>(n_))); };
    double low = 1e-3;
    double high = n_ + 1.0;
    for (int i = 0; i < 200; ++i)
    {
        const double middle = 0.5 * (low + high);
        (slope(middle) > 0 ? low : high) = middle;
    }
    return 2 * std::sqrt(low) * upperGamma(n_, low);
}

} // namespace isph
