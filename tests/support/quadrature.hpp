#pragma once

#include "kernels/Kernel.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace isph::test
{

/// Nodes and weights of Gauss-Legendre quadrature on [-1, 1], by Newton's method on the Legendre polynomial.
inline std::vector<std::pair<double, double>> gaussLegendre(int points)
{
    std::vector<std::pair<double, double>> rule;
    for (int i = 0; i < points; ++i)
    {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (points + 0.5));
        double slope = 0;
        for (int iteration = 0; iteration < 20; ++iteration)
        {
            double previous = 1;
            double value = x;
            for (int m = 2; m <= points; ++m)
            {
                previous = std::exchange(value, ((2 * m - 1) * x * value - (m - 1) * previous) / m);
            }
            slope = points * (x * value - previous) / (x * x - 1);
            x -= value / slope;
        }
        rule.emplace_back(x, 2 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

/// Integral of a function that is smooth between whole multiples of a quarter, where splines have their knots.
template<class Function>
double integral(double from, double to, Function function)
{
    static const auto rule = gaussLegendre(16);
    constexpr double panel = 0.25;
    double total = 0;
    for (double left = from; left < to; left += panel)
    {
        for (const auto& [x, weight] : rule) { total += 0.5 * panel * weight * function(left + 0.5 * panel * (1 + x)); }
    }
    return total;
}

/// Area of the unit sphere of d dimensions.
inline double sphere(int dimensions)
{
    return dimensions == 1 ? 2 : dimensions == 2 ? 2 * std::numbers::pi : 4 * std::numbers::pi;
}

/// Beyond this q every kernel and what it is multiplied with below is less than round-off.
constexpr double farAway = 13;

/// Integral over space of a function of q.
template<class Function>
double radialIntegral(int dimensions, Function function)
{
    return sphere(dimensions) *
           integral(0, farAway, [&](double q) { return function(q) * std::pow(q, dimensions - 1); });
}

/// Mean of exp(i k x) over the sphere of radius q.
inline double meanWave(int dimensions, double kq)
{
    if (dimensions == 1) { return std::cos(kq); }
    if (dimensions == 2) { return ::j0(kq); }
    return kq == 0 ? 1 : std::sin(kq) / kq;
}

} // namespace isph::test
