#pragma once

#include "continuation/Mirror.hpp"
#include "continuation/SmoothGram.hpp"
#include "fields/reductions.hpp"
#include "kernels/ExactKernel.hpp"
#include "transport/ScalarTransport.hpp"

#include "support/fields.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace isph::test
{

/// A scalar of x, y, z and t.
using ScalarField = std::function<double(double, double, double, double)>;
/// A velocity: component by direction, of x, y, z and t.
using VelocityField = std::function<double(int, double, double, double, double)>;

class PlainScalarData : public FaceFunction
{
public:
    explicit PlainScalarData(ScalarField function) : function_(std::move(function)) {}

    void evaluate(int, std::span<const double> x, std::span<const double> y, std::span<const double> z, double t,
                  std::span<double> values) const override
    {
        for (std::size_t i = 0; i < values.size(); ++i) { values[i] = function_(x[i], y[i], z[i], t); }
    }
    bool dependsOnTime() const override { return true; }

private:
    ScalarField function_;
};

class PlainVelocity : public GivenVelocity
{
public:
    PlainVelocity(const Lattice& lattice, VelocityField function, bool changes)
        : lattice_(lattice), function_(std::move(function)), changes_(changes), coordinates_(lattice.coordinates())
    {
    }

    void evaluate(double t, RealField& U) const override
    {
        const auto& [x, y, z] = coordinates_;
        for (int d = 0; d < U.components(); ++d)
        {
            for (std::size_t i = 0; i < U.size(); ++i)
            {
                U[d][i] = function_(lattice_.direction(d), x[i], y[i], z[i], t);
            }
        }
    }
    bool dependsOnTime() const override { return changes_; }

private:
    Lattice lattice_;
    VelocityField function_;
    bool changes_;
    std::array<std::vector<double>, 3> coordinates_;
};

inline VelocityField uniformVelocity(std::array<double, 3> U)
{
    return [U](int direction, double, double, double, double) { return U[static_cast<std::size_t>(direction)]; };
}

/// A box with corner at the origin; intervals 0: the axis is left out.
inline Lattice boxOf(std::array<int, 3> intervals, std::array<bool, 3> bounded, bool staggered = false)
{
    constexpr std::array<char, 3> names{'x', 'y', 'z'};
    std::array<Axis, 3> axes;
    for (std::size_t d = 0; d < 3; ++d)
    {
        axes[d].name = names[d];
        if (intervals[d] == 0) { continue; }
        axes[d].extent = 1;
        axes[d].count = intervals[d] + (bounded[d] && !staggered ? 1 : 0);
        axes[d].ends = bounded[d] ? Axis::Ends::bounded : Axis::Ends::periodic;
        axes[d].staggered = bounded[d] && staggered;
    }
    return {axes, {}};
}

/// Exact kernel, RK3, smoothGram of degree 4 (on staggered axes mirror): more is for the test to change.
inline FlowSettings transportSettings(const Lattice& lattice, int degree = 4)
{
    FlowSettings settings;
    settings.kernel.kernel = std::make_unique<ExactKernel>();
    settings.convection = ConvectionForm::advective;
    settings.laplacian = LaplacianForm::secondDerivative;
    settings.time = timeSchemes()[Word{"RK3", {}}];
    settings.dealiasing = Dealiasing::none;
    for (int direction = 0; direction < 3; ++direction)
    {
        const Axis& axis = lattice.axis(direction);
        if (!axis.active() || axis.periodic()) { continue; }
        auto& continuation = settings.continuations[static_cast<std::size_t>(direction)];
        if (axis.staggered) { continuation = std::make_unique<Mirror>(axis.count, true); }
        else { continuation = std::make_unique<SmoothGram>(automaticNewPoints(axis.count), degree); }
    }
    return settings;
}

inline ScalarFace valueFace(ScalarField value)
{
    return {"values", ScalarCondition::value, std::make_unique<PlainScalarData>(std::move(value))};
}
inline ScalarFace gradientFace(ScalarField outwardDerivative)
{
    return {"gradients", ScalarCondition::gradient, std::make_unique<PlainScalarData>(std::move(outwardDerivative))};
}
inline ScalarFace insulatedFace() { return {"insulated", ScalarCondition::gradient, nullptr}; }
inline ScalarFace outflowFace() { return {"outflow", ScalarCondition::outflow, nullptr}; }

using ScalarFaces = std::array<std::array<ScalarFace, 2>, 3>;

/// A scalar with all it refers to.
class TransportRun
{
public:
    TransportRun(Lattice points, double DT, FlowSettings how, VelocityField U, ScalarFaces faces, bool changes = false)
        : lattice(std::move(points)),
          diffusivity(DT),
          settings(std::move(how)),
          velocity(lattice, std::move(U), changes),
          boundary(lattice, std::move(faces)),
          transport(lattice, DT, settings, velocity, boundary, timings)
    {
    }
    TransportRun(const TransportRun&) = delete; // the transport refers to its neighbours
    TransportRun& operator=(const TransportRun&) = delete;

    void start(const ScalarField& T)
    {
        RealField values = fieldOf(lattice, 1, [&T](int, double x, double y, double z) { return T(x, y, z, 0); });
        transport.prepare(values, 0);
        transport.start(values, 0);
    }

    /// Steps of this length to a time.
    void march(double end, int steps)
    {
        const double begin = time;
        for (int n = 0; n < steps; ++n) { transport.step(begin + (end - begin) * n / steps, (end - begin) / steps); }
        time = end;
    }

    /// Steps of this Courant number.
    void marchAtCourant(double end, double courant)
    {
        march(end, static_cast<int>(std::ceil((end - time) * transport.rates(time).courant / courant - 1e-9)));
    }

    /// Root mean square of the difference to a field.
    double error(const ScalarField& exact) const
    {
        const RealField values =
            fieldOf(lattice, 1, [&](int, double x, double y, double z) { return exact(x, y, z, time); });
        double squares = 0;
        for (std::size_t i = 0; i < values.size(); ++i)
        {
            squares += std::pow(values[0][i] - transport.values()[0][i], 2);
        }
        return std::sqrt(squares / static_cast<double>(values.size()));
    }

    Lattice lattice;
    double diffusivity;
    FlowSettings settings;
    PlainVelocity velocity;
    ScalarBoundary boundary;
    Timings timings;
    ScalarTransport transport;
    double time = 0;
};

} // namespace isph::test
