#pragma once

#include <span>

namespace isph
{

/// Sums run over fixed blocks in a fixed order: the same bits every time, whatever the number of threads.

double sum(std::span<const double> values);
double sumOfSquares(std::span<const double> values);
double sumOfProducts(std::span<const double> a, std::span<const double> b);
double sumOfProducts(std::span<const double> a, std::span<const double> b, std::span<const double> c);

/// Largest absolute value; 0 for an empty span; NaN if any value is NaN.
double largestMagnitude(std::span<const double> values);

/// Whether every value is a finite number.
bool allFinite(std::span<const double> values);

} // namespace isph
