#include "continuation/smoothness.hpp"

#include "spectral/LineTransform.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace isph
{

std::vector<double> differenceWeights(std::span<const double> nodes, int p)
{
    const std::size_t n = nodes.size();
    const auto highest = static_cast<std::size_t>(p);
    assert(n > highest);
    // weights[m][j] of derivative m, by adding one node after the other.
    std::vector<std::vector<double>> weights(highest + 1, std::vector<double>(n, 0.0));
    weights[0][0] = 1;
    double product = 1;
    for (std::size_t i = 1; i < n; ++i)
    {
        double newProduct = 1;
        const double before = nodes[i - 1];
        for (std::size_t j = 0; j < i; ++j)
        {
            const double distance = nodes[i] - nodes[j];
            newProduct *= distance;
            if (j + 1 == i)
            {
                for (std::size_t m = std::min(i, highest) + 1; m-- > 0;)
                {
                    const double lower = m > 0 ? static_cast<double>(m) * weights[m - 1][i - 1] : 0;
                    weights[m][i] = product * (lower - before * weights[m][i - 1]) / newProduct;
                }
            }
            for (std::size_t m = std::min(i, highest) + 1; m-- > 0;)
            {
                const double lower = m > 0 ? static_cast<double>(m) * weights[m - 1][j] : 0;
                weights[m][j] = (nodes[i] * weights[m][j] - lower) / distance;
            }
        }
        product = newProduct;
    }
    return weights[highest];
}

namespace
{

/// One-sided derivatives at a place of a closed line, times dx^p, looking forward (1) or back (-1).
double oneSided(std::span<const double> line, std::size_t at, int direction, int p)
{
    constexpr int order = 2; // longer stencils see more of the blending than of the seam
    std::vector<double> nodes;
    for (int j = 0; j < p + order; ++j) { nodes.push_back(direction * j); }
    const std::vector<double> weights = differenceWeights(nodes, p);
    const auto size = static_cast<long>(line.size());
    double value = 0;
    for (int j = 0; j < p + order; ++j)
    {
        const long place = (static_cast<long>(at) + direction * j + size) % size;
        value += weights[static_cast<std::size_t>(j)] * line[static_cast<std::size_t>(place)];
    }
    return value;
}

} // namespace

std::vector<double> spectrumOf(std::span<const double> line)
{
    const LineTransform transform(static_cast<int>(line.size()), 1);
    RealField values = transform.realLines();
    SpectralField modes = transform.modesOfLines();
    std::ranges::copy(line, values[0].begin());
    transform.forward(values, modes);
    std::vector<double> magnitudes;
    for (const auto& mode : modes[0]) { magnitudes.push_back(std::abs(mode) / static_cast<double>(line.size())); }
    return magnitudes;
}

Smoothness smoothnessOf(std::span<const double> line, int points)
{
    Smoothness smoothness;
    double largest = 0;
    for (const double value : line) { largest = std::max(largest, std::abs(value)); }
    if (largest == 0) { return smoothness; }
    for (int p = 1; p <= Smoothness::derivatives; ++p)
    {
        const auto jumpAt = [&](std::size_t at)
        { return std::abs(oneSided(line, at, 1, p) - oneSided(line, at, -1, p)) / largest; };
        smoothness.upperJump[static_cast<std::size_t>(p - 1)] = jumpAt(static_cast<std::size_t>(points) - 1);
        smoothness.lowerJump[static_cast<std::size_t>(p - 1)] = jumpAt(0);
    }
    const std::vector<double> spectrum = spectrumOf(line);
    const auto third = static_cast<std::ptrdiff_t>(2 * spectrum.size() / 3);
    smoothness.tail = *std::max_element(spectrum.begin() + third, spectrum.end()) / *std::ranges::max_element(spectrum);
    return smoothness;
}

} // namespace isph
