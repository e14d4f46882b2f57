#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace isph
{

/// All eigenvalues of a real square matrix, in no particular order.
/// \param matrix n rows of n values, row after row
/// \throws std::runtime_error if a value is not finite, or the iteration does not converge
std::vector<std::complex<double>> eigenvaluesOf(std::span<const double> matrix, std::size_t n);

} // namespace isph
