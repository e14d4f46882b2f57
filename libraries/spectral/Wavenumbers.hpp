#pragma once

#include "lattice/Lattice.hpp"

#include <array>
#include <vector>

namespace isph
{

/// Angular wavenumbers [rad/m] of each active axis of a periodic lattice, in the order of FourierTransform.
struct Wavenumbers
{
    explicit Wavenumbers(const Lattice& lattice);

    /// k[d][i] with the sign of the mode; the Nyquist wavenumber of an even count is pi/dx.
    std::array<std::vector<double>, 3> k;

    /// The same with the Nyquist wavenumber set to 0: what a first derivative of a real field must use.
    std::array<std::vector<double>, 3> derivative;
};

} // namespace isph
