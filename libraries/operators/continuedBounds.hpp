#pragma once

#include "continuation/continuedField.hpp"
#include "kernels/KernelSettings.hpp"
#include "lattice/Lattice.hpp"
#include "operators/DerivativeSymbol.hpp"
#include "operators/LaplacianForm.hpp"

namespace isph
{

/// The bounds of operators that act line by line: the largest symbols over the modes of the lines with their new points
/// and, where that is more, the spectral radius of a bounded line whose ends are held at zero. Kernels that smooth much
/// have modes at walls that no symbol knows: 0.25 (pi/dx)^2 instead of 0.09 for order 4 and h = 2 dx.
///
/// leastLaplacian is negative also where a continuation makes a mode grow, as polynomials through few points do.
///
/// \throws Error(input) without origin if the samples of a kernel reach around a line, or a line has too few points
OperatorBounds continuedBounds(const Lattice& lattice, const Continuations& continuations, const KernelSettings& kernel,
                               LaplacianForm form = LaplacianForm::secondDerivative);

} // namespace isph
