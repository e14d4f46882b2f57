#include "sampling/Interpolation.hpp"

#include "continuation/SmoothGram.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace isph
{

namespace
{

/// Coordinates that are meant to be a lattice point miss it by round-off only, in spacings.
constexpr double roundOff = 1e-9;

constexpr std::array<Selection<Interpolation>::Variant, 3> table{{
    {"spectral", "the Fourier series itself, on bounded axes of the continued values", Interpolation::spectral},
    {"linear", "between two points an axis, order 2", Interpolation::linear},
    {"cubic", "through four points an axis, order 4", Interpolation::cubic},
}};
static_assert(distinct(table));

/// Weights of the Fourier series of n points at position s (in spacings, not a whole number).
std::vector<double> fourierWeights(int n, double s)
{
    const double floor = std::floor(s);
    const double numerator = std::sin(std::numbers::pi * (s - floor)) / n;
    std::vector<double> weights(static_cast<std::size_t>(n));
    for (int j = 0; j < n; ++j)
    {
        // sin(pi (s - j)) without the round-off of a large argument.
        const double sine = (static_cast<long>(floor) - j) % 2 == 0 ? numerator : -numerator;
        const double angle = std::numbers::pi * (s - j) / n;
        weights[static_cast<std::size_t>(j)] = sine / (n % 2 == 0 ? std::tan(angle) : std::sin(angle));
    }
    return weights;
}

/// Weights of the Fourier series of n points and of what continues them periodically, at position s. The new points are
/// sums over points near both ends, and their weights go to these.
std::vector<double> continuedWeights(int n, double s)
{
    const SmoothGram continuation = defaultSmoothGram(n);
    const int newPoints = continuation.newPoints();
    const std::vector<double> extended = fourierWeights(n + newPoints, s);
    const EndBlock end = continuation.end(EndCondition::dirichlet);
    std::vector<double> weights(extended.begin(), extended.begin() + n);
    for (int k = 1; k <= newPoints; ++k)
    {
        const double ofUpper = extended[static_cast<std::size_t>(n - 1 + k)];
        const double ofLower = extended[static_cast<std::size_t>(n + newPoints - k)];
        for (int c = 0; c < end.points; ++c)
        {
            weights[static_cast<std::size_t>(n - 1 - c)] += end.weight(k, c) * ofUpper;
            weights[static_cast<std::size_t>(c)] += end.weight(k, c) * ofLower;
        }
    }
    return weights;
}

/// Weights of the polynomial through n points at 0, 1, ..., n - 1.
std::vector<double> lagrangeWeights(int n, double s)
{
    std::vector<double> weights(static_cast<std::size_t>(n), 1.0);
    for (int j = 0; j < n; ++j)
    {
        for (int k = 0; k < n; ++k)
        {
            if (k != j) { weights[static_cast<std::size_t>(j)] *= (s - k) / (j - k); }
        }
    }
    return weights;
}

} // namespace

const Selection<Interpolation>& interpolations()
{
    static constexpr Selection<Interpolation> selection("interpolation", table);
    return selection;
}

AxisStencil axisStencil(const Axis& axis, double coordinate, Interpolation interpolation)
{
    if (!axis.active()) { return {0, {1.0}}; }
    assert(inside(axis, coordinate));
    double s = (coordinate - axis.coordinate(0)) / axis.spacing();
    if (axis.periodic()) { s -= axis.count * std::floor(s / axis.count); }

    const double nearest = std::round(s);
    const bool isPoint = axis.periodic() || (nearest >= 0 && nearest < axis.count);
    if (isPoint && std::abs(s - nearest) < roundOff) { return {static_cast<int>(nearest) % axis.count, {1.0}}; }

    if (interpolation == Interpolation::spectral && axis.count > 1)
    {
        return {0, axis.periodic() ? fourierWeights(axis.count, s) : continuedWeights(axis.count, s)};
    }

    const int points = std::min(interpolation == Interpolation::linear ? 2 : 4, axis.count);
    int first = static_cast<int>(std::floor(s)) - (points / 2 - 1);
    if (axis.periodic()) { first = (first + axis.count) % axis.count; }
    else { first = std::clamp(first, 0, axis.count - points); }
    const double offset = std::floor(s) - (points / 2 - 1);
    return {first, lagrangeWeights(points, axis.periodic() ? s - offset : s - first)};
}

bool inside(const Axis& axis, double coordinate)
{
    if (!axis.active() || axis.periodic()) { return true; }
    const double margin = roundOff * axis.spacing();
    return coordinate >= axis.origin - margin && coordinate <= axis.origin + axis.extent + margin;
}

} // namespace isph
