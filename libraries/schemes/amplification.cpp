#include "schemes/amplification.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isph
{

namespace
{

/// Whether a step adds no growth of its own to what a mode does in exact time.
bool bears(const TimeScheme& scheme, const ModeRate& mode, double dt)
{
    // A scheme follows growth in time only to its order: a tenth of it is not its fault.
    constexpr double ofOrder = 1.1;
    constexpr double roundOff = 1e-13;
    const double allowed = ofOrder * dt * std::max(mode.growth(), 0.0);
    const double factor = std::abs(amplification(scheme, mode, dt));
    return factor == 0 || std::log(factor) <= allowed + roundOff;
}

bool bearsAll(const TimeScheme& scheme, std::span<const ModeRate> modes, double dt)
{
    return std::ranges::all_of(modes, [&](const ModeRate& mode) { return bears(scheme, mode, dt); });
}

} // namespace

std::complex<double> amplification(const TimeScheme& scheme, const ModeRate& mode, double dt)
{
    std::complex<double> value = 1;
    std::complex<double> before = 0; // the rate of the substep before, carried along
    for (const Substep& substep : scheme.substeps)
    {
        const std::complex<double> rate = mode.explicitRate * value;
        const double factor = std::exp(-mode.integratedRate * substep.a * dt);
        value = factor * (value + dt * (substep.g * rate + substep.z * before));
        before = factor * rate;
    }
    return mode.filter * value;
}

double largestGrowth(const TimeScheme& scheme, std::span<const ModeRate> modes, double dt)
{
    double largest = 0;
    for (const ModeRate& mode : modes) { largest = std::max(largest, std::abs(amplification(scheme, mode, dt))); }
    return largest > 0 ? std::log(largest) : -std::numeric_limits<double>::infinity();
}

double exactGrowth(std::span<const ModeRate> modes)
{
    double largest = 0;
    for (const ModeRate& mode : modes) { largest = std::max(largest, mode.growth()); }
    return largest;
}

double largestStableStep(const TimeScheme& scheme, std::span<const ModeRate> modes)
{
    double fastest = 0;
    for (const ModeRate& mode : modes) { fastest = std::max(fastest, std::abs(mode.explicitRate)); }
    if (fastest == 0) { return std::numeric_limits<double>::infinity(); }

    double high = 8 / fastest; // beyond what any scheme here bears of a mode by itself
    if (bearsAll(scheme, modes, 1e6 * high)) { return std::numeric_limits<double>::infinity(); }
    const double least = 1e-6 * high; // the growth of shorter steps is lost in rounding
    while (bearsAll(scheme, modes, high)) { high *= 2; }
    double low = 0;
    while (high - low > 1e-12 * high && high > least)
    {
        const double middle = 0.5 * (low + high);
        (bearsAll(scheme, modes, middle) ? low : high) = middle;
    }
    return high > least ? low : 0;
}

} // namespace isph
