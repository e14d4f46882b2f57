#pragma once

#include "continuation/SmoothGram.hpp"
#include "flow/BoundedFlow.hpp"
#include "kernels/ExactKernel.hpp"
#include "support/fields.hpp"
#include "support/periodicBox.hpp"

#include <functional>
#include <utility>

namespace isph::test
{

/// A function of component, x, y, z and t.
using PlaceAndTime = std::function<double(int, double, double, double, double)>;

class PlainFaceFunction : public FaceFunction
{
public:
    PlainFaceFunction(PlaceAndTime function, bool changes) : function_(std::move(function)), changes_(changes) {}

    void evaluate(int component, std::span<const double> x, std::span<const double> y, std::span<const double> z,
                  double t, std::span<double> values) const override
    {
        for (std::size_t i = 0; i < values.size(); ++i) { values[i] = function_(component, x[i], y[i], z[i], t); }
    }
    bool dependsOnTime() const override { return changes_; }

private:
    PlaceAndTime function_;
    bool changes_;
};

class PlainForce : public BodyForce
{
public:
    PlainForce(const Lattice& lattice, PlaceAndTime function)
        : function_(std::move(function)), coordinates_(lattice.coordinates())
    {
    }

    void evaluate(double t, RealField& force) const override
    {
        for (int c = 0; c < force.components(); ++c)
        {
            for (std::size_t i = 0; i < force.size(); ++i)
            {
                force[c][i] = function_(c, coordinates_[0][i], coordinates_[1][i], coordinates_[2][i], t);
            }
        }
    }
    bool dependsOnTime() const override { return true; }

private:
    PlaceAndTime function_;
    std::array<std::vector<double>, 3> coordinates_;
};

inline FaceCondition wallAtRest(const std::string& patch)
{
    FaceCondition face;
    face.patch = patch;
    face.velocity = VelocityCondition::value;
    face.pressure = PressureCondition::zeroGradient;
    return face;
}

inline FaceCondition movingWall(const std::string& patch, PlaceAndTime U, bool changes)
{
    FaceCondition face = wallAtRest(patch);
    face.U = std::make_unique<PlainFaceFunction>(std::move(U), changes);
    return face;
}

/// The unit square, points on both ends of bounded axes, with walls at rest there.
inline Lattice unitBox(int xIntervals, int yIntervals, bool xBounded)
{
    Axis x{.name = 'x', .extent = 1, .count = xIntervals + (xBounded ? 1 : 0)};
    x.ends = xBounded ? Axis::Ends::bounded : Axis::Ends::periodic;
    Axis y{.name = 'y', .extent = 1, .count = yIntervals + 1, .ends = Axis::Ends::bounded};
    const Patch::Type sides = xBounded ? Patch::Type::wall : Patch::Type::periodic;
    return Lattice({x, y, Axis{.name = 'z'}},
                   {{"sides", sides, {"xMin", "xMax"}}, {"walls", Patch::Type::wall, {"yMin", "yMax"}}});
}

/// What a bounded scene has by default: exact kernel, advective, RK3, explicit viscosity, smoothGram of degree 4.
inline FlowSettings boundedSettings(const Lattice& lattice, int degree = 4)
{
    FlowSettings settings;
    settings.kernel.kernel = std::make_unique<ExactKernel>();
    settings.convection = ConvectionForm::advective;
    settings.laplacian = LaplacianForm::secondDerivative;
    settings.time = timeSchemes()[Word{"RK3", {}}];
    settings.integratingFactor = false;
    settings.exactMeanFlow = false;
    settings.dealiasing = Dealiasing::none;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const Axis& axis = lattice.activeAxis(d);
        if (axis.periodic()) { continue; }
        settings.continuations[static_cast<std::size_t>(lattice.direction(d))] =
            std::make_unique<SmoothGram>(automaticNewPoints(axis.count), degree);
    }
    return settings;
}

/// A bounded flow with all it refers to, and the time it has come to.
struct BoundedRun
{
    BoundedRun(Lattice points, Fluid what, FlowSettings how, std::array<std::array<FaceCondition, 2>, 3> faces)
        : lattice(std::move(points)),
          fluid(std::move(what)),
          settings(std::move(how)),
          boundary(lattice, std::move(faces)),
          flow((boundary.update(0), lattice), fluid, settings, boundary, timings, PlanEffort::estimated)
    {
    }

    BoundedRun(const BoundedRun&) = delete; // the flow refers to its neighbours
    BoundedRun& operator=(const BoundedRun&) = delete;

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

    Lattice lattice;
    Fluid fluid;
    FlowSettings settings;
    FlowBoundary boundary;
    Timings timings;
    BoundedFlow flow;
    double t = 0;
};

} // namespace isph::test
