#pragma once

#include "flow/flowDiagnostics.hpp"
#include "support/flows.hpp"
#include "support/periodicBox.hpp"

#include <utility>

namespace isph::test
{

using std::numbers::pi;

/// A flow with all it refers to, and the time it has come to.
template<class Flow>
struct RunOf
{
    RunOf(Lattice points, Fluid what, FlowSettings how)
        : lattice(std::move(points)), fluid(std::move(what)), settings(std::move(how)), flow(makeFlow())
    {
    }

    RunOf(const RunOf&) = delete; // the flow refers to its neighbours
    RunOf& operator=(const RunOf&) = delete;

    /// Starts from a velocity given as a function of the component and x, y, z.
    StartReport start(const std::function<double(int, double, double, double)>& velocity, bool project = true)
    {
        return flow.start(fieldOf(lattice, lattice.dimensions(), velocity), project);
    }

    /// Equal steps to a later time.
    void march(double end, int steps)
    {
        const double begin = t;
        const double dt = (end - begin) / steps;
        for (int n = 0; n < steps; ++n) { advance(*settings.time, flow, begin + n * dt, dt); }
        t = end;
    }

    /// One step of dt.
    void step(double dt)
    {
        advance(*settings.time, flow, t, dt);
        t += dt;
    }

    FlowStatistics statistics() { return FlowDiagnostics(lattice, fluid.nu).evaluate(flow, nullptr, t); }

    Lattice lattice;
    Fluid fluid;
    FlowSettings settings;
    Timings timings;
    Flow flow;
    double t = 0;

private:
    Flow makeFlow()
    {
        if constexpr (std::is_same_v<Flow, SpectralFlow>)
        {
            return Flow(lattice, fluid, settings, timings, PlanEffort::estimated);
        }
        else { return Flow(lattice, fluid, settings, timings); }
    }
};

using FlowRun = RunOf<SpectralFlow>;

/// What the notes recommend for a kernel: divergence form, 2/3, integrating factor, no mean flow carried.
inline FlowSettings recommendedSettings(KernelSettings kernel)
{
    FlowSettings settings = plainSettings(std::move(kernel));
    settings.dealiasing = Dealiasing::twoThirds;
    settings.integratingFactor = true;
    return settings;
}

/// exp(-36 (|k_j|/k_Nyquist)^16) on each axis, once a step.
inline FilterSettings exponentialFilter() { return {.type = FilterSettings::Type::exponential}; }

/// 1/2 the mean of |u|^2.
inline double kineticEnergy(const RealField& velocity)
{
    const double magnitude = norm(velocity);
    return 0.5 * magnitude * magnitude / static_cast<double>(velocity.size());
}

/// ||a - b||/||b|| after both means are taken out, as pressures are compared.
inline double relativeL2WithoutMeans(const RealField& a, const RealField& b)
{
    const auto withoutMean = [](const RealField& field)
    {
        RealField result = copyOf(field);
        for (int c = 0; c < field.components(); ++c)
        {
            double mean = 0;
            for (const double value : field[c]) { mean += value / static_cast<double>(field.size()); }
            for (double& value : result[c]) { value -= mean; }
        }
        return result;
    };
    return relativeL2(withoutMean(a), withoutMean(b));
}

/// Largest difference of any value.
inline double largestDifference(const RealField& a, const RealField& b)
{
    double largest = 0;
    for (int c = 0; c < a.components(); ++c)
    {
        for (std::size_t i = 0; i < a.size(); ++i)
        {
            const double difference = std::abs(a[c][i] - b[c][i]);
            if (!(difference <= largest)) { largest = difference; }
        }
    }
    return largest;
}

} // namespace isph::test
