#pragma once

#include "fields/Field.hpp"
#include "flow/SpectralFlow.hpp"
#include "kernels/ExactKernel.hpp"
#include "kernels/Gaussian.hpp"
#include "kernels/QuinticSpline.hpp"
#include "schemes/TimeScheme.hpp"

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>

namespace isph::test
{

inline KernelSettings closedGaussian(int order, double smoothingLength)
{
    KernelSettings kernel;
    kernel.kernel = std::make_unique<Gaussian>(order);
    kernel.smoothingLength = smoothingLength;
    kernel.supportRadius = kernel.kernel->supportRadius();
    return kernel;
}

inline KernelSettings sampledGaussian(int order, double smoothingLength, double supportRadius)
{
    KernelSettings kernel = closedGaussian(order, smoothingLength);
    kernel.symbol = KernelSettings::Symbol::sampled;
    kernel.supportRadius = supportRadius;
    return kernel;
}

inline KernelSettings quinticSpline(double smoothingLength)
{
    KernelSettings kernel;
    kernel.kernel = std::make_unique<QuinticSpline>();
    kernel.smoothingLength = smoothingLength;
    kernel.symbol = KernelSettings::Symbol::sampled;
    kernel.supportRadius = 3;
    return kernel;
}

inline KernelSettings exactKernel()
{
    KernelSettings kernel;
    kernel.kernel = std::make_unique<ExactKernel>();
    return kernel;
}

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

/// A field from a function of x, y, z and the component (along active axes).
inline RealField fieldOf(const Lattice& lattice, int components,
                         const std::function<double(int, double, double, double)>& function)
{
    RealField field(components, lattice.points());
    const auto [x, y, z] = lattice.coordinates();
    for (int c = 0; c < components; ++c)
    {
        for (std::size_t i = 0; i < lattice.points(); ++i) { field[c][i] = function(c, x[i], y[i], z[i]); }
    }
    return field;
}

/// Uniform noise in [-1, 1], the same for the same seed.
inline RealField noise(const Lattice& lattice, int components, unsigned seed)
{
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    return fieldOf(lattice, components, [&](int, double, double, double) { return uniform(engine); });
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

/// ||a - b|| / ||b - mean of b where asked|| over all components.
inline double relativeL2(const RealField& a, const RealField& b)
{
    double difference = 0;
    double norm = 0;
    for (int c = 0; c < a.components(); ++c)
    {
        for (std::size_t i = 0; i < a.size(); ++i)
        {
            difference += (a[c][i] - b[c][i]) * (a[c][i] - b[c][i]);
            norm += b[c][i] * b[c][i];
        }
    }
    return std::sqrt(difference / norm);
}

inline double norm(const RealField& a)
{
    double total = 0;
    for (int c = 0; c < a.components(); ++c)
    {
        for (const double value : a[c]) { total += value * value; }
    }
    return std::sqrt(total);
}

/// Marches from 0 to end in equal steps.
inline void march(IncompressibleFlow& flow, const TimeScheme& scheme, double end, int steps)
{
    const double dt = end / steps;
    for (int n = 0; n < steps; ++n) { advance(scheme, flow, n * dt, dt); }
}

} // namespace isph::test
