#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace isph
{

/// The exponent of a power law y = c x^slope.
struct Slope
{
    double slope;
    std::size_t points; ///< that it was fitted to
};

/// Least squares through the logarithms of the pairs that are positive and finite. Nothing with fewer than two, or if
/// all have the same x.
std::optional<Slope> fitSlope(const std::vector<double>& x, const std::vector<double>& y);

/// A curve of errors against what they cost.
struct CostCurve
{
    std::string title;
    std::vector<double> cost;
    std::vector<double> error; ///< in the order of the resolution, from either end
};

/// The cost of reaching an error.
struct CostOf
{
    double cost;
    bool atMost; ///< the cheapest run is better than asked: something coarser may be cheaper
};

/// The smallest cost at which a curve reaches an error: between runs along the straight line of the logarithms. Nothing
/// if it never does.
std::optional<CostOf> costOf(const CostCurve& curve, double error);

/// Who reaches an error for least, and who comes second.
struct Cheapest
{
    double error;
    std::size_t curve;
    CostOf cost;
    std::optional<std::size_t> second;
    std::optional<CostOf> secondCost;
};

/// The cheapest curve for each decade of error that any curve reaches, coarse ones first; where there are fewer than
/// two decades, for each of 1, 2, 5, 10, ...
std::vector<Cheapest> cheapest(const std::vector<CostCurve>& curves);

} // namespace isph
