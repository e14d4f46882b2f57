#include "sampling/LatticeMap.hpp"

#include "core/Error.hpp"
#include "sampling/Interpolator.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace isph
{

namespace
{

/// Lengths that are meant to be the same differ by round-off only, relative to the box.
constexpr double roundOff = 1e-9;

bool sameLength(double a, double b, double scale) { return std::abs(a - b) <= roundOff * scale; }

bool samePoints(const Axis& source, const Axis& target)
{
    if (!source.active() || !target.active()) { return source.active() == target.active(); }
    const double scale = source.spacing();
    return source.count == target.count && sameLength(source.coordinate(0), target.coordinate(0), scale) &&
           sameLength(source.coordinate(source.count - 1), target.coordinate(target.count - 1), scale);
}

/// Whether the modes of one axis are those of the other.
bool samePeriod(const Axis& source, const Axis& target)
{
    if (!source.active() || !target.active()) { return source.active() == target.active(); }
    return source.periodic() && target.periodic() && sameLength(source.extent, target.extent, source.extent);
}

/// A periodic source goes on for ever, but repeats itself: the target must be a whole number of periods, or lie within
/// one. Along a bounded axis it must lie inside.
void requireFit(const Axis& source, const Axis& target)
{
    if (!source.active()) { return; }
    const double below = target.origin - source.origin;
    const double above = below + target.extent - source.extent;
    const double margin = roundOff * source.extent;
    const bool within = below >= -margin && above <= margin;
    if (!source.periodic() && !within)
    {
        throw Error(Fault::input,
                    fmt::format("the box reaches from {0} = {1} to {0} = {2}, but the source only from {3} to {4}",
                                source.name, target.origin, target.origin + target.extent, source.origin,
                                source.origin + source.extent),
                    "there are no values outside of walls and other boundaries");
    }
    const double periods = target.extent / source.extent;
    const bool wholePeriods = std::round(periods) >= 1 && std::abs(periods - std::round(periods)) <= roundOff * periods;
    if (source.periodic() && target.active() && !wholePeriods && (target.periodic() || !within))
    {
        throw Error(Fault::input,
                    fmt::format("along {} the source has a period of {} m, and {} m is no whole number of them",
                                source.name, source.extent, target.extent),
                    "take a box of one, two, ... periods");
    }
}

} // namespace

LatticeMap::LatticeMap(const Lattice& source, const Lattice& target) : source_(source), target_(target)
{
    bool periods = true;
    samePoints_ = true;
    for (int d = 0; d < 3; ++d)
    {
        requireFit(source.axis(d), target.axis(d));
        samePoints_ = samePoints_ && samePoints(source.axis(d), target.axis(d));
        periods = periods && samePeriod(source.axis(d), target.axis(d));
    }
    if (periods && !samePoints_) { modes_.emplace(source, target); }
}

RealField LatticeMap::operator()(const RealField& field)
{
    assert(field.components() == 1 || field.components() == source_.dimensions());
    if (field.components() == 1)
    {
        RealField mapped(1, target_.points());
        map(field[0], mapped[0]);
        return mapped;
    }
    RealField mapped(target_.dimensions(), target_.points());
    for (int component = 0; component < target_.dimensions(); ++component)
    {
        for (int d = 0; d < source_.dimensions(); ++d)
        {
            if (source_.direction(d) == target_.direction(component)) { map(field[d], mapped[component]); }
        }
    }
    return mapped;
}

std::string LatticeMap::method() const
{
    if (samePoints_) { return "the points are the same"; }
    if (modes_) { return "Fourier modes"; }
    std::string text;
    for (int d = 0; d < source_.dimensions(); ++d)
    {
        const Axis& axis = source_.activeAxis(d);
        text += fmt::format("{}{} along {}", d > 0 ? ", " : "",
                            axis.periodic() ? "spectral" : "spectral by continuation", axis.name);
    }
    return text;
}

void LatticeMap::map(std::span<const double> field, std::span<double> mapped)
{
    if (samePoints_) { std::ranges::copy(field, mapped.begin()); }
    else if (modes_) { modes_->map(field, mapped); }
    else { interpolate(field, mapped); }
}

void LatticeMap::interpolate(std::span<const double> field, std::span<double> mapped) const
{
    // Plane by plane, so that the coordinates of all points never lie in memory.
    const auto nx = static_cast<std::size_t>(target_.axis(0).count);
    const auto ny = static_cast<std::size_t>(target_.axis(1).count);
    Points points;
    for (auto& coordinates : points) { coordinates.resize(nx * ny); }
    for (std::size_t n = 0; n < nx * ny; ++n)
    {
        points[0][n] = target_.axis(0).coordinate(static_cast<int>(n % nx));
        points[1][n] = target_.axis(1).coordinate(static_cast<int>(n / nx));
    }
    for (int iz = 0; iz < target_.axis(2).count; ++iz)
    {
        std::ranges::fill(points[2], target_.axis(2).coordinate(iz));
        const Interpolator interpolator(source_, points, Interpolation::spectral);
        interpolator(field, mapped.subspan(static_cast<std::size_t>(iz) * nx * ny, nx * ny));
    }
}

std::vector<LatticeMap::ModeStep> LatticeMap::stepsOf(const Axis& source, const Axis& target, bool half)
{
    const int n = source.count;
    const auto index = [half, &target](int mode)
    {
        assert(!half || mode >= 0);
        return static_cast<std::size_t>(mode >= 0 ? mode : target.count + mode);
    };
    const double shift = 2 * std::numbers::pi * (target.origin - source.origin) / source.extent;
    std::vector<ModeStep> steps;
    for (int i = 0; i < (half ? n / 2 + 1 : n); ++i)
    {
        const int mode = i <= n / 2 ? i : i - n;
        const auto from = static_cast<std::size_t>(i);
        if (2 * mode != n)
        {
            if (2 * std::abs(mode) < target.count)
            {
                steps.push_back({from, index(mode), std::polar(1.0, mode * shift)});
            }
        }
        else if (target.count == n) { steps.push_back({from, from, std::cos(mode * shift)}); }
        else if (target.count > n)
        {
            // The Nyquist mode is a cosine: half of it belongs to each sign.
            steps.push_back({from, index(mode), 0.5 * std::polar(1.0, mode * shift)});
            if (!half) { steps.push_back({from, index(-mode), 0.5 * std::polar(1.0, -mode * shift)}); }
        }
    }
    return steps;
}

LatticeMap::Modes::Modes(const Lattice& source, const Lattice& target)
    : sourceExtents(modeExtents(source)),
      targetExtents(modeExtents(target)),
      sourceTransform(source, 1),
      targetTransform(target, 1),
      sourceValues(1, source.points()),
      targetValues(1, target.points()),
      sourceModes(1, sourceTransform.modes()),
      targetModes(1, targetTransform.modes())
{
    steps.fill({{0, 0, 1.0}});
    for (int d = 0; d < source.dimensions(); ++d)
    {
        steps[static_cast<std::size_t>(d)] = stepsOf(source.activeAxis(d), target.activeAxis(d), d == 0);
    }
}

void LatticeMap::Modes::map(std::span<const double> field, std::span<double> mapped)
{
    std::ranges::copy(field, sourceValues[0].begin());
    sourceTransform.forward(sourceValues, sourceModes);
    std::ranges::fill(targetModes[0], 0.0);
    const double scale = 1 / static_cast<double>(sourceTransform.points());
    for (const ModeStep& outer : steps[2])
    {
        for (const ModeStep& middle : steps[1])
        {
            const std::complex<double> factor = scale * outer.factor * middle.factor;
            const std::size_t from = sourceExtents[0] * (middle.from + sourceExtents[1] * outer.from);
            const std::size_t to = targetExtents[0] * (middle.to + targetExtents[1] * outer.to);
            for (const ModeStep& inner : steps[0])
            {
                targetModes[0][to + inner.to] += factor * inner.factor * sourceModes[0][from + inner.from];
            }
        }
    }
    targetTransform.backward(targetModes, targetValues);
    std::ranges::copy(targetValues[0], mapped.begin());
}

} // namespace isph
