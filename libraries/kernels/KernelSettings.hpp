#pragma once

#include "kernels/Kernel.hpp"

#include <memory>

namespace isph
{

/// A kernel and how it becomes an operator on a lattice (system/schemes, kernel).
struct KernelSettings
{
    enum class Symbol
    {
        closed,  ///< the analytic Fourier symbol at the lattice's wavenumbers
        sampled, ///< the transform of the truncated kernel sampled on the lattice
    };

    std::unique_ptr<Kernel> kernel;
    double smoothingLength = 1.5; ///< h/dx, on each axis
    Symbol symbol = Symbol::closed;
    double supportRadius = 0; ///< cut-off of the samples [h]
    bool renormalise = false; ///< sampled: divide by the discrete second moment

    bool exact() const { return kernel->order() == 0; }
};

} // namespace isph
