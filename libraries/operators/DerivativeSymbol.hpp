#pragma once

#include "fields/Field.hpp"
#include "kernels/KernelSettings.hpp"
#include "operators/KernelSamples.hpp"
#include "spectral/dealiasing.hpp"
#include "spectral/FourierTransform.hpp"
#include "spectral/ModeRows.hpp"

#include <span>

namespace isph
{

/// The first derivative of a kernel in Fourier space: D_j f = i d_j(k) f, with d_j real, odd, and zero at the Nyquist
/// wavenumber of its own axis.
///
/// Closed kernels: d_j = k_j Q(k) with one table for Q, none for the exact derivative. Sampled kernels: a table for
/// each axis, the transform of the samples.
class DerivativeSymbol
{
public:
    DerivativeSymbol(const Lattice& lattice, const KernelSettings& settings, const KernelSamples* samples);

    /// d_j of the modes begin <= i < end of a row, for every active axis j; out[j] has room for end - begin values.
    void row(std::size_t row, std::size_t begin, std::size_t end, const std::array<double*, 3>& out) const;

    /// The wave vector that d is parallel to (Nyquist wavenumbers zero), in the same form.
    void wavevectorRow(std::size_t row, std::size_t begin, std::size_t end, const std::array<double*, 3>& out) const;

    /// Whether d is parallel to the wave vector: then projecting along k is projecting along d.
    bool parallel() const { return sampled_.components() == 0; }

    /// Q of D_j = i k_j Q by mode, where d is parallel to the wave vector; empty: 1.
    std::span<const double> smoothing() const { return smoothing_; }

    const ModeRows& rows() const { return rows_; }

private:
    ModeRows rows_;
    AlignedVector<double> smoothing_; ///< Q by mode; empty means 1
    RealField sampled_;               ///< d_j by mode; no components for closed kernels
};

/// A real table of modes, the transform of weights on the lattice: sum_b w_b cos(k x_b) for even weights, or
/// sum_b w_b sin(k x_b) for odd ones. Offsets beyond the box wrap to their images.
AlignedVector<double> symbolOfWeights(const Lattice& lattice, FourierTransform& transform,
                                      const std::vector<std::array<int, 3>>& offsets,
                                      const std::vector<double>& weights, bool odd);

/// Minus the Laplacian's symbol by mode, >= 0 up to the defects of the form (sampled secondDerivative can be negative).
/// \param samples of the same form; unused (may be null) for closed kernels and LaplacianForm::exact
AlignedVector<double> laplacianSymbol(const Lattice& lattice, const KernelSettings& settings, LaplacianForm form,
                                      const KernelSamples* samples);

/// Largest symbols of the operators over the modes that are kept: what stability limits are made of.
struct OperatorBounds
{
    std::array<double, 3> derivative{0, 0, 0}; ///< max |d_j| [1/m]
    double derivativeMagnitude = 0;            ///< max |d| [1/m]
    double laplacian = 0;                      ///< max of minus the Laplacian [1/m2]
    double leastLaplacian = 0;                 ///< its min: negative values grow
    double derivativeOverLaplacian = 0;        ///< max |d|^2 over minus the Laplacian
};

/// \param laplacian table of laplacianSymbol; empty: no viscous term
OperatorBounds operatorBounds(const DerivativeSymbol& derivative, std::span<const double> laplacian,
                              const RetainedModes& retained);

} // namespace isph
