#pragma once

#include <array>
#include <span>
#include <vector>

namespace isph
{

/// How smooth a continued line is.
struct Smoothness
{
    static constexpr int derivatives = 4;

    /// Jump of derivative p = 1, 2, ... (element p - 1) from the points to the new points, at the last point and at the
    /// first, where the line closes: |difference of one-sided derivatives| dx^p over the largest value. A jump that is
    /// there falls as dx^p when the lattice is refined, none as dx^(p + 3), down to what p + 2 points see of the
    /// blending (with 25 new points 1e-8, 1e-6 and 3e-5 in the second to fourth derivative).
    std::array<double, derivatives> upperJump{};
    std::array<double, derivatives> lowerJump{};

    /// Largest mode of the upper third of the wavenumbers, over the largest of all.
    double tail = 0;
};

/// \param line of one period: points values, then the new ones
Smoothness smoothnessOf(std::span<const double> line, int points);

/// Magnitudes of the modes 0 ... size/2 of a line, over its size.
std::vector<double> spectrumOf(std::span<const double> line);

/// Weights of values at nodes for derivative p at 0 (Fornberg 1988).
std::vector<double> differenceWeights(std::span<const double> nodes, int p);

} // namespace isph
