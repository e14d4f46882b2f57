#pragma once

#include "spectral/Wavenumbers.hpp"

#include <array>
#include <cstddef>

namespace isph
{

/// How the modes of a lattice are walked: rows of contiguous wavenumbers along the first active axis.
class ModeRows
{
public:
    explicit ModeRows(const Lattice& lattice);

    int dimensions() const { return dimensions_; }
    std::size_t length() const { return extents_[0]; }              ///< modes in a row
    std::size_t count() const { return extents_[1] * extents_[2]; } ///< rows
    std::size_t modes() const { return length() * count(); }
    std::size_t offset(std::size_t row) const { return row * length(); }

    /// Index on axis d (1 or 2) of a row.
    std::size_t index(std::size_t row, int d) const
    {
        // A division costs as much as several modes do.
        if (extents_[2] == 1) { return d == 1 ? row : 0; }
        return d == 1 ? row % extents_[1] : row / extents_[1];
    }

    const Wavenumbers& wavenumbers() const { return wavenumbers_; }

    /// Wavenumber of a row on axis d (1 or 2), and the one for first derivatives.
    double k(std::size_t row, int d) const { return wavenumbers_.k[static_cast<std::size_t>(d)][index(row, d)]; }
    double derivative(std::size_t row, int d) const
    {
        return wavenumbers_.derivative[static_cast<std::size_t>(d)][index(row, d)];
    }

    /// Squared length of the wave vector without its first component.
    double k2OfRow(std::size_t row) const;

    /// Whether a mode is a checkerboard: Nyquist or 0 on every axis, but not the mean. No first derivative sees it, so
    /// that neither convection by a divergence nor the pressure acts on it.
    bool checkerboard(std::size_t row, std::size_t i) const;

    /// How many modes of the full complex spectrum a stored one stands for: 1 on the planes k0 = 0 and Nyquist, else 2.
    double multiplicity(std::size_t i) const { return i == 0 || 2 * i == points0_ ? 1.0 : 2.0; }

private:
    int dimensions_;
    std::size_t points0_;
    std::array<std::size_t, 3> extents_;
    Wavenumbers wavenumbers_;
};

} // namespace isph
