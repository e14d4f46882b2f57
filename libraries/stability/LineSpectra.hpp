#pragma once

#include "boundary/FlowBoundary.hpp"
#include "flow/FlowSettings.hpp"
#include "lattice/Lattice.hpp"

#include <complex>
#include <optional>
#include <vector>

namespace isph
{

/// Eigenvalues of the derivatives along the lines of a scene: symbols along periodic axes, those of the dense matrices
/// of continued lines along bounded ones, closed as a flow closes them (points that faces prescribe are no unknowns,
/// what flows out is differenced from inside).
class LineSpectra
{
public:
    using Spectrum = std::vector<std::complex<double>>;

    /// Longest bounded line whose matrix is taken apart: the work grows as the cube of its points.
    static constexpr int longest = 520;

    /// All must outlive this.
    LineSpectra(const Lattice& lattice, const FlowSettings& settings, const FlowBoundary& boundary)
        : lattice_(lattice), settings_(settings), boundary_(boundary)
    {
    }

    /// Of -sign d/dx along the d-th active axis: what a velocity of 1 m/s in the direction of sign makes of a component
    /// [1/m]. Empty for lines that are too long.
    std::optional<Spectrum> convection(int component, int d, int sign) const;

    /// Of the second derivative of a component [1/m2].
    std::optional<Spectrum> diffusion(int component, int d) const;

private:
    std::optional<Spectrum> ofBoundedLine(int component, int d, int sign) const;

    const Lattice& lattice_;
    const FlowSettings& settings_;
    const FlowBoundary& boundary_;
};

} // namespace isph
