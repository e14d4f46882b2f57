#pragma once

#include "Sweep.hpp"

namespace isph
{

/// Columns that every run has besides its parameters and quantities.
std::vector<std::string> runColumns();

/// The number that a run left behind, of a quantity that does not depend on others. Not-a-number where the run has none
/// (no peak, no row of that time). \param caseDirectory of the sweep, which reference files are relative to \param
/// folder of the run \throws Error(input) at the quantity's entry if what it names (file, column, key) does not exist;
/// names the nearest.
double evaluate(const Quantity& quantity, const std::filesystem::path& caseDirectory,
                const std::filesystem::path& folder);

/// The numbers of all quantities of a run, those that are the largest of others included.
/// \throws Error(input) as above
std::vector<double> evaluateAll(const std::vector<Quantity>& quantities, const std::filesystem::path& caseDirectory,
                                const std::filesystem::path& folder);

/// A column reduced to one number. Not-a-number if no row counts.
/// \param times of the rows [s], or places along a line; increasing
double reduce(const Quantity& quantity, const std::vector<double>& times, const std::vector<double>& values);

/// Largest or root mean square deviation of a profile, interpolated linearly, from a reference, at the points of the
/// reference; those outside of the profile are left out. Not-a-number if none is left, or the profile has one point.
double deviation(Quantity::Norm norm, const std::vector<double>& abscissae, const std::vector<double>& values,
                 const std::vector<double>& referenceAbscissae, const std::vector<double>& reference);

} // namespace isph
