#pragma once

#include "kernels/KernelSettings.hpp"

#include <vector>

namespace isph
{

/// A kernel's derivatives along one axis in Fourier space, for the modes m = 0 ... length/2 of a periodic line:
/// df = i first f, d2f = -second f.
struct LineSymbol
{
    std::vector<double> first;  ///< k W(k) [rad/m]; 0 at the Nyquist wavenumber
    std::vector<double> second; ///< k^2 W(k) [rad2/m2]
};

/// The one-dimensional kernel on a line of this many points: its closed symbol, or the sum over its samples.
/// \throws Error(input) without origin if the samples reach around the line.
LineSymbol lineSymbol(const KernelSettings& settings, int length, double spacing);

} // namespace isph
