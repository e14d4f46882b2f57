#pragma once

#include "continuation/LineSymbol.hpp"
#include "operators/LaplacianForm.hpp"

namespace isph
{

/// A kernel's derivatives along one axis, the second one in a form of the Laplacian: of Morris, Fox & Zhu 1997 in one
/// dimension, of the kernel itself, or exact. A Laplacian is the sum over the axes.
/// \throws Error(input) without origin if the samples reach around the line.
LineSymbol lineSymbolOf(const KernelSettings& kernel, LaplacianForm form, int length, double spacing);

} // namespace isph
