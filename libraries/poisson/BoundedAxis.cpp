#include "poisson/BoundedAxis.hpp"

#include "core/Error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <stdexcept>

namespace isph
{

namespace
{

RealBasis basisOf(AxisEnds ends, bool staggered)
{
    if (ends.low == End::periodic) { return RealBasis::fourier; }
    const bool cosines = ends.low == End::neumann;
    const bool quarterWave = ends.low != ends.high;
    if (cosines)
    {
        if (quarterWave) { return staggered ? RealBasis::cosine4 : RealBasis::cosine3; }
        return staggered ? RealBasis::cosine2 : RealBasis::cosine1;
    }
    if (quarterWave) { return staggered ? RealBasis::sine4 : RealBasis::sine3; }
    return staggered ? RealBasis::sine2 : RealBasis::sine1;
}

/// Half waves along the axis of the i-th mode.
double halfWaves(const BoundedAxis& axis, std::size_t i)
{
    const auto index = static_cast<double>(i);
    if (axis.ends.low == End::periodic) { return 2 * static_cast<double>(std::min(i, axis.count - i)); }
    if (axis.ends.low != axis.ends.high) { return index + 0.5; }
    return axis.ends.low == End::neumann ? index : index + 1;
}

} // namespace

BoundedAxis::BoundedAxis(const Axis& axis, AxisEnds conditions, const AxisSymbol& symbol)
    : ends(conditions),
      staggered(axis.staggered && !axis.periodic()),
      extent(axis.extent),
      spacing(axis.spacing()),
      basis(basisOf(conditions, staggered)),
      points(static_cast<std::size_t>(axis.count)),
      first(fixedLow() ? 1 : 0),
      k2(points),
      eigenvalue(points),
      sine2(points),
      low(points),
      high(points)
{
    const bool periodicEnds = ends.low == End::periodic;
    if (periodicEnds != (ends.high == End::periodic) || periodicEnds != axis.periodic())
    {
        throw std::logic_error("BoundedAxis: the conditions do not suit the axis");
    }
    const std::size_t fixed = (fixedLow() ? 1U : 0U) + (fixedHigh() ? 1U : 0U);
    if (points < fixed + 1 || (bounded() && !staggered && points < 2))
    {
        throw Error(Fault::input, fmt::format("axis {} has no point inside its walls", axis.name),
                    "give it at least three");
    }
    count = points - fixed;

    for (std::size_t i = 0; i < count; ++i)
    {
        const double halfPhase = 0.5 * std::numbers::pi * halfWaves(*this, i) * spacing / extent;
        const double sine = std::sin(halfPhase);
        // At the last mode of Neumann walls cos(pi/2) must be the zero it stands for.
        const double cosine = sine == 1.0 ? 0.0 : std::cos(halfPhase);
        const double k = 2 * halfPhase / spacing;
        const std::size_t at = first + i;
        k2[at] = k * k;
        eigenvalue[at] = symbol(k, spacing);
        sine2[at] = sine * sine;
        if (!bounded()) { continue; }
        const double slope = 0.5 * spacing * (staggered ? cosine : 1);
        const double value = sine * (staggered ? 1 : cosine);
        const double sign = i % 2 == 0 ? 1 : -1;
        low[at] = ends.low == End::neumann ? -slope : value;
        high[at] = sign * (ends.high == End::neumann ? slope : value);
    }
}

bool BoundedAxis::constantMode() const { return !bounded() || (ends.low == End::neumann && ends.high == End::neumann); }

} // namespace isph
