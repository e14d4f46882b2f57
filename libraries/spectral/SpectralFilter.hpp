#pragma once

#include "core/Selection.hpp"
#include "lattice/Lattice.hpp"

#include <array>
#include <vector>

namespace isph
{

/// A low-pass filter applied once per step, axis by axis: sigma = prod_j sigma(|k_j|/k_Nyquist).
struct FilterSettings
{
    enum class Type
    {
        none,
        exponential,
        cutoff
    };

    Type type = Type::none;
    double strength = 36;   ///< exponential: sigma = exp(-strength (|k|/k_Nyquist)^order)
    double order = 16;      ///< exponential
    double fraction = 0.66; ///< cutoff: modes above this fraction of the Nyquist wavenumber are dropped
};

const Selection<FilterSettings::Type>& filters();

/// sigma of a mode at this fraction of the Nyquist wavenumber.
double filterFactor(const FilterSettings& settings, double fraction);

/// Factors of the modes' indices, for each active axis.
std::array<std::vector<double>, 3> filterFactors(const Lattice& lattice, const FilterSettings& settings);

} // namespace isph
