#pragma once

#include "kernels/KernelSettings.hpp"
#include "lattice/Lattice.hpp"
#include "operators/LaplacianForm.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace isph
{

/// What a kernel makes of waves along an axis of the lattice, which for equal h/dx is the same for every axis.
struct KernelResolution
{
    /// Relative errors of the derivative of a wave, and of the viscous operator's Laplacian if there is one.
    struct Wave
    {
        int pointsPerWavelength;
        double gradient;
        std::optional<double> laplacian;
    };

    std::array<double, 3> h{}; ///< of each active axis [m]; zeros for the exact derivative
    std::vector<Wave> waves;

    /// Wavenumber at which the derivative keeps half of a wave's slope, over the Nyquist wavenumber; nothing if it
    /// keeps more of every wave there is (exact).
    std::optional<double> cutOff;

    std::optional<double> supportPoints; ///< radius of the samples [dx]; nothing for closed symbols
    std::size_t neighbours = 0;          ///< points in the support of a sampled kernel (on a line where an axis is
                                         ///< bounded), the point itself included
    double defect = 0;                   ///< sampled: relative error of the derivative of the longest waves
};

/// \param laplacian form of the viscous operator; nothing where there is none
KernelResolution kernelResolution(const Lattice& lattice, const KernelSettings& kernel,
                                  const std::optional<LaplacianForm>& laplacian);

} // namespace isph
