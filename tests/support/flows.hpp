#pragma once

#include "flow/SpectralFlow.hpp"
#include "schemes/TimeScheme.hpp"
#include "support/fields.hpp"
#include "support/kernels.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace isph::test
{

inline const TimeScheme* scheme(const char* name) { return timeSchemes()[Word{name, {}}]; }

/// Plain settings: everything optional is off.
inline FlowSettings plainSettings(KernelSettings kernel, const char* time = "RK3")
{
    FlowSettings settings;
    settings.kernel = std::move(kernel);
    settings.time = scheme(time);
    settings.integratingFactor = false;
    settings.exactMeanFlow = false;
    settings.dealiasing = Dealiasing::none;
    return settings;
}

/// Taylor-Green vortex of the unit box, carried by a mean flow (exact_solutions 1 and 2 of docs/theory).
struct TaylorGreen
{
    double nu = 0.01;
    double U0 = 0;
    double V0 = 0;

    double velocity(int component, double x, double y, double t) const
    {
        using std::numbers::pi;
        const double a = 2 * pi * (x - U0 * t);
        const double b = 2 * pi * (y - V0 * t);
        const double decay = std::exp(-8 * pi * pi * nu * t);
        return component == 0 ? U0 - std::cos(a) * std::sin(b) * decay : V0 + std::sin(a) * std::cos(b) * decay;
    }
    double pressure(double x, double y, double t) const
    {
        using std::numbers::pi;
        return -0.25 * (std::cos(4 * pi * (x - U0 * t)) + std::cos(4 * pi * (y - V0 * t))) *
               std::exp(-16 * pi * pi * nu * t);
    }
};

/// Marches from 0 to end in equal steps.
inline void march(IncompressibleFlow& flow, const TimeScheme& scheme, double end, int steps)
{
    const double dt = end / steps;
    for (int n = 0; n < steps; ++n) { advance(scheme, flow, n * dt, dt); }
}

} // namespace isph::test
