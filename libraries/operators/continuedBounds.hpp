#pragma once

#include "continuation/continuedField.hpp"
#include "kernels/KernelSettings.hpp"
#include "lattice/Lattice.hpp"
#include "operators/DerivativeSymbol.hpp"
#include "operators/LaplacianForm.hpp"

namespace isph
{

/// The largest symbols of operators that act line by line, over the modes of the lines with their new points.
///
/// They bound the operators between walls, too: the eigenvalues of a continued second derivative without its walls lie
/// below the largest symbol, and within 2 % of it for the exact one (tests/verification/continuation).
///
/// \throws Error(input) without origin if the samples of a kernel reach around a line
OperatorBounds continuedBounds(const Lattice& lattice, const Continuations& continuations, const KernelSettings& kernel,
                               LaplacianForm form = LaplacianForm::secondDerivative);

} // namespace isph
