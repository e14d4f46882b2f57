#include "lattice/Quadrature.hpp"

#include "fields/reductions.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace isph
{

namespace
{

/// Gregory's coefficients of the first six differences at an end (Abramowitz & Stegun 1964, section 25.4).
constexpr std::array<double, 6> gregory{1.0 / 12, 1.0 / 24, 19.0 / 720, 3.0 / 160, 863.0 / 60480.0, 275.0 / 24192};

/// Integral from a to b of the polynomial that is 1 at node j and 0 at the others, by Gauss's rule of three points
/// (exact up to degree 5).
double lagrangeIntegral(std::span<const double> nodes, std::size_t j, double a, double b)
{
    constexpr double inner = 0.774596669241483377;
    constexpr std::array<std::array<double, 2>, 3> gauss{{{-inner, 5.0 / 9}, {0, 8.0 / 9}, {inner, 5.0 / 9}}};
    double integral = 0;
    for (const auto& [at, weight] : gauss)
    {
        const double s = 0.5 * (a + b) + 0.5 * (b - a) * at;
        double value = 0.5 * (b - a) * weight;
        for (std::size_t k = 0; k < nodes.size(); ++k)
        {
            if (k != j) { value *= (s - nodes[k]) / (nodes[j] - nodes[k]); }
        }
        integral += value;
    }
    return integral;
}

} // namespace

std::vector<double> quadratureWeights(const Axis& axis)
{
    const auto n = static_cast<std::size_t>(axis.count);
    if (!axis.active()) { return std::vector<double>(n, 1.0); }
    std::vector<double> weights(n, axis.spacing());
    if (axis.periodic() || axis.staggered || n < 2) { return weights; }

    weights.front() = weights.back() = 0.5 * axis.spacing();
    for (std::size_t k = 1; k <= std::min(gregory.size(), n - 1); ++k)
    {
        double alternatingBinomial = gregory[k - 1] * axis.spacing(); // times (-1)^j binom(k, j)
        for (std::size_t j = 0; j <= k; ++j)
        {
            weights[j] -= alternatingBinomial;
            weights[n - 1 - j] -= alternatingBinomial;
            alternatingBinomial *= -static_cast<double>(k - j) / static_cast<double>(j + 1);
        }
    }
    return weights;
}

std::vector<double> runningIntegral(const Axis& axis, std::span<const double> values)
{
    const int n = axis.count;
    assert(static_cast<int>(values.size()) == n);
    const int used = std::min(6, n);
    const double shift = !axis.periodic() && axis.staggered ? 0.5 : 0.0; // of point 0 from the end, in spacings
    const double length = axis.extent / axis.spacing();

    std::vector<double> integral;
    double sum = 0;
    double from = 0;
    for (int i = 0; i <= n; ++i)
    {
        const double to = i < n ? i + shift : length;
        // The points on both sides of the interval; at bounded ends as far inside as they have to be.
        int first = static_cast<int>(0.5 * (from + to) - shift + 1) - used / 2;
        if (!axis.periodic()) { first = std::clamp(first, 0, n - used); }
        std::vector<double> nodes;
        for (int j = 0; j < used; ++j) { nodes.push_back(first + j + shift); }
        for (int j = 0; to > from && j < used; ++j)
        {
            sum += axis.spacing() * lagrangeIntegral(nodes, static_cast<std::size_t>(j), from, to) *
                   values[static_cast<std::size_t>((first + j + n) % n)];
        }
        integral.push_back(sum);
        from = to;
    }
    return integral;
}

Quadrature::Quadrature(const Lattice& lattice) : pointVolume_(lattice.pointVolume()), points_(lattice.points())
{
    const std::array<std::vector<double>, 3> weights{
        quadratureWeights(lattice.axis(0)), quadratureWeights(lattice.axis(1)), quadratureWeights(lattice.axis(2))};
    uniform_ = std::ranges::all_of(weights,
                                   [](const std::vector<double>& ofAxis) {
                                       return ofAxis.empty() || std::ranges::count(ofAxis, ofAxis.front()) ==
                                                                    static_cast<std::ptrdiff_t>(ofAxis.size());
                                   });
    alongRow_ = weights[0];
    for (const double z : weights[2])
    {
        for (const double y : weights[1]) { rowWeight_.push_back(y * z); }
    }
}

template<class RowSum>
double Quadrature::weighted(RowSum rowSum) const
{
    std::vector<double> rows(rowWeight_.size());
    for (std::size_t row = 0; row < rows.size(); ++row) { rows[row] = rowSum(row * alongRow_.size()); }
    return sumOfProducts(rows, rowWeight_);
}

double Quadrature::of(std::span<const double> values) const
{
    assert(values.size() == points_);
    if (uniform_) { return pointVolume_ * sum(values); }
    return weighted([&](std::size_t first)
                    { return sumOfProducts(values.subspan(first, alongRow_.size()), alongRow_); });
}

double Quadrature::ofProducts(std::span<const double> a, std::span<const double> b) const
{
    assert(a.size() == points_ && b.size() == points_);
    if (uniform_) { return pointVolume_ * sumOfProducts(a, b); }
    return weighted(
        [&](std::size_t first)
        {
            double total = 0;
            for (std::size_t i = 0; i < alongRow_.size(); ++i) { total += alongRow_[i] * a[first + i] * b[first + i]; }
            return total;
        });
}

} // namespace isph
