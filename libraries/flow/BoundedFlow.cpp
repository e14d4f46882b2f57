#include "flow/BoundedFlow.hpp"

#include "fields/reductions.hpp"
#include "flow/convectiveRates.hpp"
#include "kernels/ExactKernel.hpp"
#include "operators/continuedBounds.hpp"

#include <algorithm>
#include <cmath>

namespace isph
{

namespace
{

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// What the solver of the pressure knows at a face.
End endOf(const FaceCondition& face)
{
    return face.pressure == PressureCondition::value ? End::dirichlet : End::neumann;
}

/// What the continuation of a velocity component knows at a face: on walls its points are values like any other.
EndCondition velocityEnd(const FaceCondition& face, bool normal, bool staggered)
{
    if (face.velocity == VelocityCondition::slip && !normal) { return EndCondition::neumann; }
    // Off the points nothing is known of what flows out but that it hardly changes.
    if (face.velocity == VelocityCondition::outflow && staggered) { return EndCondition::neumann; }
    return EndCondition::dirichlet;
}

EndCondition pressureEnd(const FaceCondition& face, bool staggered)
{
    return staggered && endOf(face) == End::neumann ? EndCondition::neumann : EndCondition::dirichlet;
}

} // namespace

BoundedFlow::BoundedFlow(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings,
                         FlowBoundary& boundary, Timings& timings, PlanEffort effort)
    : lattice_(lattice),
      fluid_(fluid),
      settings_(settings),
      boundary_(boundary),
      timings_(timings),
      dimensions_(lattice.dimensions()),
      bounds_(continuedBounds(lattice, settings.continuations, settings.kernel, settings.laplacian)),
      outflow_(lattice, boundary)
{
    makeDerivatives(effort);

    std::array<AxisEnds, 3> ends{};
    int boundedAxes = 0;
    for (int d = 0; d < dimensions_; ++d)
    {
        const int direction = lattice_.direction(d);
        const Axis& axis = lattice_.axis(direction);
        if (axis.periodic()) { continue; }
        ends[at(direction)] = {endOf(boundary_.face(direction, Side::low)),
                               endOf(boundary_.face(direction, Side::high))};
        ++boundedAxes;
        closedAxis_ = d;
        const std::size_t facePoints = lattice_.points() / at(axis.count);
        for (auto& side : slopes_[at(d)]) { side.assign(facePoints, 0.0); }
    }
    poisson_.emplace(lattice_, ends, effort);
    if (VolumeBalance::concerns(lattice_, boundary_)) { balance_.emplace(lattice_, boundary_); }
    if (boundedAxes != 1 || lattice_.activeAxis(*closedAxis_).staggered || settings_.walls != WallTreatment::consistent)
    {
        closedAxis_.reset();
    }
    if (closedAxis_)
    {
        for (auto& side : sourceSlopes_) { side.assign(slopes_[at(*closedAxis_)][0].size(), 0.0); }
    }

    const std::size_t points = lattice_.points();
    velocity_ = RealField(dimensions_, points);
    before_ = RealField(dimensions_, points);
    rate_ = RealField(dimensions_, points);
    previousRate_ = RealField(dimensions_, points);
    scratch_ = RealField(1, points);
    source_ = RealField(1, points);
    phi_ = RealField(1, points);
    if (fluid_.bodyForce) { force_ = RealField(dimensions_, points); }
}

void BoundedFlow::makeDerivatives(PlanEffort effort)
{
    struct Made
    {
        int d;
        EndCondition low;
        EndCondition high;
        std::size_t index;
    };
    std::vector<Made> made;
    const auto make = [&](int d, EndCondition low, EndCondition high)
    {
        for (const Made& other : made)
        {
            if (other.d == d && other.low == low && other.high == high) { return other.index; }
        }
        const int direction = lattice_.direction(d);
        const Axis& axis = lattice_.axis(direction);
        std::optional<LineContinuation> line;
        if (const auto& continuation = settings_.continuations[at(direction)])
        {
            line.emplace(*continuation, axis.count, low, high);
        }
        ContinuedTransform transform(linesAlong(lattice_, direction), std::move(line), axis.spacing(), effort);
        LineSymbol symbol = lineSymbol(settings_.kernel, transform.length(), axis.spacing());
        if (settings_.laplacian == LaplacianForm::exact)
        {
            KernelSettings exact;
            exact.kernel = std::make_unique<ExactKernel>();
            symbol.second = lineSymbol(exact, transform.length(), axis.spacing()).second;
        }
        derivatives_.emplace_back(std::move(transform), symbol);
        made.push_back({d, low, high, derivatives_.size() - 1});
        return made.back().index;
    };
    for (int d = 0; d < dimensions_; ++d)
    {
        const int direction = lattice_.direction(d);
        const bool staggered = lattice_.axis(direction).staggered;
        const FaceCondition& low = boundary_.face(direction, Side::low);
        const FaceCondition& high = boundary_.face(direction, Side::high);
        for (int c = 0; c < dimensions_; ++c)
        {
            derivativeOf_[at(c)][at(d)] =
                make(d, velocityEnd(low, c == d, staggered), velocityEnd(high, c == d, staggered));
        }
        pressureDerivative_[at(d)] = make(d, pressureEnd(low, staggered), pressureEnd(high, staggered));
    }
}

ContinuedDerivative& BoundedFlow::derivative(int component, int d)
{
    return derivatives_[derivativeOf_[at(component)][at(d)]];
}

EndData BoundedFlow::endData(int component, int d) const
{
    const int direction = lattice_.direction(d);
    if (!lattice_.axis(direction).staggered) { return {}; }
    return {boundary_.velocity(direction, Side::low, component), boundary_.velocity(direction, Side::high, component)};
}

StartReport BoundedFlow::start(const RealField& velocity, bool project)
{
    velocity_ = copyOf(velocity);
    StartReport report;
    if (project)
    {
        RealField given = copyOf(velocity);
        readNormal(velocity_, 1);
        subtractPrescribed(1);
        solvePressure(velocity_, 1, false, phi_);
        subtractGradient(1, phi_, velocity_);
        boundary_.imposeNormal(velocity_);
        if (balance_) { balance_->correct(velocity_); }
        double norm = 0;
        for (int c = 0; c < dimensions_; ++c)
        {
            norm += sumOfSquares(given[c]);
            for (std::size_t i = 0; i < given.size(); ++i) { given[c][i] -= velocity_[c][i]; }
            report.projected += sumOfSquares(given[c]);
        }
        report.projected = norm > 0 ? std::sqrt(report.projected / norm) : 0;
    }
    transforms_ = 0;
    return report;
}

void BoundedFlow::save(FieldWriter& writer) const
{
    writer.writeState("boundedU", velocity_);
    if (oldPressure_.components() > 0) { writer.writeState("p", oldPressure_); }
}

void BoundedFlow::restore(const FieldReader& reader)
{
    reader.readState("boundedU", velocity_);
    if (oldPressure_.components() > 0 && reader.hasState("p")) { reader.readState("p", oldPressure_); }
}

bool BoundedFlow::restores(const FieldReader& reader) const { return reader.hasState("boundedU"); }

void BoundedFlow::stepBack()
{
    std::swap(velocity_, before_);
    std::swap(oldPressure_, oldPressureBefore_);
}

StepRates BoundedFlow::rates()
{
    const auto scope = timings_.scope(Phase::pointwise);
    StepRates rates;
    if (fluid_.nu > 0 && !settings_.crankNicolson) { rates.viscous = fluid_.nu * bounds_.laplacian; }
    addConvectiveRates(lattice_, velocity_, bounds_, fluid_.nu, rates);
    if (settings_.convection == ConvectionForm::none) { rates.convective = rates.unbalancedConvection = 0; }
    return rates;
}

const RealField& BoundedFlow::divergence()
{
    addDivergence(velocity_, source_);
    return source_;
}

} // namespace isph
