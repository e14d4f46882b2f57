#include "flow/BoundedFlow.hpp"

#include "core/Error.hpp"
#include "fields/reductions.hpp"
#include "flow/convectiveRates.hpp"
#include "flow/faceConditions.hpp"
#include "flow/projectionRatio.hpp"
#include "flow/stableNumbers.hpp"
#include "operators/continuedBounds.hpp"
#include "operators/lineSymbolOf.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

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

EndCondition pressureEnd(const FaceCondition& face, bool staggered)
{
    return staggered && endOf(face) == End::neumann ? EndCondition::neumann : EndCondition::dirichlet;
}

/// What an implicit viscous term knows of a velocity component at a face.
LineEnd viscousEnd(const FaceCondition& face, bool normal, bool staggered)
{
    return holdsValue(face, normal) && !staggered ? LineEnd::value : LineEnd::free;
}

/// What flows out is differenced from inside.
void requirePointsBehindOutlets(const Lattice& lattice, const FlowBoundary& boundary)
{
    constexpr int least = 4;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const Axis& axis = lattice.activeAxis(d);
        if (axis.periodic() || axis.count >= least) { continue; }
        for (const Side side : {Side::low, Side::high})
        {
            if (boundary.face(lattice.direction(d), side).velocity != VelocityCondition::outflow) { continue; }
            throw Error(
                Fault::input,
                fmt::format("axis {} has an outlet, which needs {} points, but has {}", axis.name, least, axis.count),
                "take more lattice points in system/latticeDict");
        }
    }
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
    if (settings_.crankNicolson && !marches(WallTreatment::consistent))
    {
        throw Error(Fault::input, "viscous CrankNicolson goes with walls consistent only",
                    "write walls consistent; or viscous explicit;");
    }
    makeDerivatives(effort);
    if (settings_.extended) { makeExtended(effort); }

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
    requirePointsBehindOutlets(lattice_, boundary_);
    if (VolumeBalance::concerns(lattice_, boundary_)) { balance_.emplace(lattice_, boundary_); }
    if (balance_ && marches(WallTreatment::slip))
    {
        throw Error(Fault::input, "walls slip makes the flow at an outlet grow without limit",
                    "write walls consistent; in system/schemes");
    }
    const bool closes = marches(WallTreatment::consistent) || marches(WallTreatment::pressurePoisson);
    const Axis& last = lattice_.activeAxis(*closedAxis_);
    if (boundedAxes != 1 || last.staggered || last.count < pointsOfSlopes || !closes) { closedAxis_.reset(); }
    makePoisson(ends, effort);
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
    for (int d = 0; d < dimensions_ && poisson_ && extended_.empty() && !periodicSlope_; ++d)
    {
        const Axis& axis = lattice_.activeAxis(d);
        if (!axis.periodic()) { continue; }
        slope_ = RealField(1, points);
        periodicSymbol_ = lineSymbolOf(settings_.kernel, settings_.laplacian, axis.count, axis.spacing()).first;
        periodicSlope_.emplace(PeriodicSlope{lattice_.direction(d), periodicSymbol_, slope_[0]});
    }
    if (fluid_.bodyForce)
    {
        if (const auto uniform = fluid_.bodyForce->uniform()) { uniformForce_ = *uniform; }
        else { force_ = RealField(dimensions_, points); }
    }
    if (marchesPressure()) { makeIncrements(); }
    if (marches(WallTreatment::pressurePoisson)) { laplacian_ = RealField(dimensions_, points); }
    if (settings_.crankNicolson && fluid_.nu > 0) { makeHelmholtz(); }
    // Increments of the pressure, which an implicit term needs, suffer where an inlet meets a wall.
    mayYield_ = settings_.automaticViscous && fluid_.nu > 0 && marches(WallTreatment::consistent) && !balance_;
    fingerprint_ = probe();
}

bool BoundedFlow::marchesPressure() const
{
    return implicit_ || (!marches(WallTreatment::consistent) && !marches(WallTreatment::paper));
}

void BoundedFlow::makeIncrements()
{
    phiBefore_ = RealField(1, lattice_.points());
    gradient_ = RealField(dimensions_, lattice_.points());
    increment_ = RealField(1, lattice_.points());
}

void BoundedFlow::makeDerivatives(PlanEffort effort)
{
    struct Made
    {
        int d;
        EndCondition low;
        EndCondition high;
    };
    std::vector<Made> made;
    const auto make = [&](int d, EndCondition low, EndCondition high)
    {
        for (std::size_t i = 0; i < made.size(); ++i)
        {
            if (made[i].d == d && made[i].low == low && made[i].high == high) { return i; }
        }
        const int direction = lattice_.direction(d);
        const Axis& axis = lattice_.axis(direction);
        const auto transformOfLines = [&]
        {
            std::optional<LineContinuation> line;
            if (const auto& continuation = settings_.continuations[at(direction)])
            {
                line.emplace(*continuation, axis.count, low, high);
            }
            // Slopes at the ends of lines are zero here, so data are values and need no scale.
            return ContinuedTransform(linesAlong(lattice_, direction), std::move(line), 1, effort);
        };
        ContinuedTransform transform = transformOfLines();
        const int length = transform.length();
        derivatives_.emplace_back(std::move(transform),
                                  lineSymbolOf(settings_.kernel, settings_.laplacian, length, axis.spacing()));
        if (settings_.filter.type != FilterSettings::Type::none)
        {
            std::vector<double> factors;
            for (int m = 0; m <= length / 2; ++m)
            {
                factors.push_back(filterFactor(settings_.filter, 2.0 * m / length));
            }
            filters_.emplace_back(transformOfLines(), std::move(factors));
        }
        made.push_back({d, low, high});
        return made.size() - 1;
    };
    for (int d = 0; d < dimensions_; ++d)
    {
        const auto direction = at(lattice_.direction(d));
        for (int c = 0; c <= dimensions_; ++c)
        {
            const auto [low, high] = endsOf(c)[direction];
            (c < dimensions_ ? derivativeOf_[at(c)] : pressureDerivative_)[at(d)] = make(d, low, high);
            if (c == dimensions_) { continue; }
            const auto viscous = [&](Side side) {
                return viscousCondition(boundary_.face(lattice_.direction(d), side), c == d,
                                        lattice_.activeAxis(d).staggered);
            };
            viscousDerivativeOf_[at(c)][at(d)] = make(d, viscous(Side::low), viscous(Side::high));
        }
    }
}

ExtendedOperators::Ends BoundedFlow::endsOf(int component) const
{
    ExtendedOperators::Ends ends{};
    for (int d = 0; d < dimensions_; ++d)
    {
        const int direction = lattice_.direction(d);
        const bool staggered = lattice_.axis(direction).staggered;
        for (const Side side : {Side::low, Side::high})
        {
            const FaceCondition& face = boundary_.face(direction, side);
            ends[at(direction)][side == Side::low ? 0 : 1] =
                component < dimensions_ ? velocityEnd(face, component == d, staggered) : pressureEnd(face, staggered);
        }
    }
    return ends;
}

void BoundedFlow::makeExtended(PlanEffort effort)
{
    std::vector<ExtendedOperators::Ends> made;
    for (int c = 0; c <= dimensions_; ++c)
    {
        const ExtendedOperators::Ends ends = endsOf(c);
        const auto known = std::ranges::find(made, ends);
        extendedOf_[at(c)] = static_cast<std::size_t>(known - made.begin());
        if (known != made.end()) { continue; }
        made.push_back(ends);
        extended_.emplace_back(lattice_, settings_.continuations, ends, settings_.kernel, settings_.laplacian, effort);
    }
}

void BoundedFlow::makePoisson(const std::array<AxisEnds, 3>& ends, PlanEffort effort)
{
    const bool morris = settings_.iteration || settings_.eigenvalues == Eigenvalues::morris;
    if (settings_.directPressure || morris) { closedAxis_.reset(); }
    if (settings_.directPressure)
    {
        direct_.emplace(lattice_, continuedAxes(lattice_, settings_.continuations, settings_.kernel, ends), effort);
    }
    else if (settings_.iteration)
    {
        iterated_.emplace(lattice_, settings_.kernel, ends, *settings_.iteration, *settings_.time);
    }
    else if (morris)
    {
        mirrored_.emplace(lattice_, KernelSamples(lattice_, settings_.kernel, LaplacianForm::morris), ends, effort);
    }
    else { poisson_.emplace(lattice_, ends, effort); }
}

void BoundedFlow::makeHelmholtz()
{
    for (int c = 0; c < dimensions_; ++c)
    {
        std::vector<ContinuedAxis> axes;
        for (int d = 0; d < dimensions_; ++d)
        {
            const int direction = lattice_.direction(d);
            const Axis& axis = lattice_.axis(direction);
            ContinuedAxis continued;
            int length = axis.count;
            if (const auto& continuation = settings_.continuations[at(direction)])
            {
                const FaceCondition& low = boundary_.face(direction, Side::low);
                const FaceCondition& high = boundary_.face(direction, Side::high);
                continued.continuation.emplace(*continuation, axis.count, viscousCondition(low, c == d, axis.staggered),
                                               viscousCondition(high, c == d, axis.staggered));
                continued.low = viscousEnd(low, c == d, axis.staggered);
                continued.high = viscousEnd(high, c == d, axis.staggered);
                length = continued.continuation->extendedPoints();
            }
            continued.symbol = lineSymbolOf(settings_.kernel, settings_.laplacian, length, axis.spacing());
            axes.push_back(std::move(continued));
        }
        helmholtz_.emplace_back(lattice_, axes);
    }
    makeIncrements();
    laplacian_ = RealField(dimensions_, lattice_.points());
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

std::array<EndData, 3> BoundedFlow::allEndData(int component) const
{
    std::array<EndData, 3> data;
    for (int d = 0; d < dimensions_; ++d) { data[at(lattice_.direction(d))] = endData(component, d); }
    return data;
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
        apart_ = true;
        solvePressure(velocity_, 1, false, phi_);
        apart_ = false;
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
    pressureKnown_ = false;
    transforms_ = 0;
    return report;
}

void BoundedFlow::save(FieldWriter& writer) const
{
    writer.writeState("boundedU", velocity_);
    if (pressureKnown_) { writer.writeState("phi", phi_); }
    if (iterated_) { iterated_->save(writer); }
}

void BoundedFlow::restore(const FieldReader& reader)
{
    reader.readState("boundedU", velocity_);
    pressureKnown_ = reader.hasState("phi");
    if (pressureKnown_) { reader.readState("phi", phi_); }
    if (iterated_) { iterated_->restore(reader); }
}

bool BoundedFlow::restores(const FieldReader& reader) const { return reader.hasState("boundedU"); }

void BoundedFlow::stepBack()
{
    std::swap(velocity_, before_);
    if (marchesPressure()) { std::swap(phi_, phiBefore_); }
    if (iterated_) { iterated_->stepBack(); }
    lastStep_ = stepBefore_;
}

StepRates BoundedFlow::rates()
{
    const auto scope = timings_.scope(Phase::pointwise);
    StepRates rates;
    if (fluid_.nu > 0 && !settings_.crankNicolson) { rates.viscous = fluid_.nu * bounds_.laplacian; }
    if (lastStep_ == 0)
    {
        // The first step begins by giving walls their velocity.
        before_ = copyOf(velocity_);
        boundary_.impose(before_);
    }
    addConvectiveRates(lattice_, lastStep_ == 0 ? before_ : velocity_, bounds_, fluid_.nu, rates);
    if (settings_.convection == ConvectionForm::none) { rates.convective = rates.unbalancedConvection = 0; }
    rates.viscousYields = mayYield_;
    explicitRate_ = 1 / largestStableStep(*settings_.time, rates);
    if (mayYield_ && crankNicolsonPays(*settings_.time, rates) && canYield()) { rates.viscous = 0; }
    return rates;
}

bool BoundedFlow::canYield()
{
    // Increments of the pressure work until no divergence is left, at such corners at the expense of all the flow.
    if (boundary_.flowsThroughCorners()) { return false; }
    if (!helmholtz_.empty() || !mayYield_) { return mayYield_; }
    try
    {
        makeHelmholtz();
    }
    catch (const Error&)
    {
        // A kernel whose second derivative has no real eigenvectors: the term stays explicit.
        helmholtz_.clear();
        mayYield_ = false;
    }
    return mayYield_;
}

std::vector<std::string> BoundedFlow::cautions() const
{
    std::vector<std::string> cautions;
    const bool increments = (settings_.crankNicolson && fluid_.nu > 0) || marches(WallTreatment::incremental) ||
                            marches(WallTreatment::rotational);
    if (increments && boundary_.flowsThroughCorners())
    {
        cautions.emplace_back(
            "a lid moves towards a wall at rest, and increments of the pressure (walls incremental or rotational, "
            "viscous CrankNicolson) end in another flow there: 20 % off in a cavity. Write walls consistent; viscous "
            "explicit;");
    }
    if (auto caution = mirrorCaution(lattice_, settings_); !caution.empty()) { cautions.push_back(std::move(caution)); }
    return cautions;
}

std::string_view BoundedFlow::viscousStep() const { return !mayYield_ ? "" : implicit_ ? "CrankNicolson" : "explicit"; }

const RealField& BoundedFlow::divergence()
{
    const long made = transforms_; // counted are those of steps
    divergenceOf(velocity_, 1, source_);
    transforms_ = made;
    return source_;
}

} // namespace isph
