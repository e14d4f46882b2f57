#include "flow/BoundedFlow.hpp"

#include "fields/fieldOperations.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace isph
{

namespace
{

std::size_t at(int i) { return static_cast<std::size_t>(i); }

} // namespace

void BoundedFlow::addTransport(int component, int d, std::span<const double> u, std::span<const double> carrier,
                               double nu, std::span<double> rate)
{
    transforms_ += (carrier.empty() ? 0 : 1) + (nu > 0 ? 1 : 0);
    if (extended_.empty())
    {
        ++transforms_;
        derivative(component, d).addTransport(u, carrier, nu, rate, endData(component, d));
        return;
    }
    ExtendedOperators& operators = extended_[extendedOf_[at(component)]];
    if (d == 0)
    {
        ++transforms_;
        operators.take(u, allEndData(component));
    }
    operators.addTransport(d, carrier, nu, rate);
}

void BoundedFlow::slopeOfVelocity(const RealField& u, int d, std::span<double> slope)
{
    transforms_ += 2;
    if (extended_.empty())
    {
        derivative(d, d)(u[d], slope, {}, endData(d, d));
        return;
    }
    ExtendedOperators& operators = extended_[extendedOf_[at(d)]];
    operators.take(u[d], allEndData(d));
    operators.derivative(d, slope);
}

void BoundedFlow::slopeOfPressure(const RealField& phi, int d, std::span<double> slope)
{
    ++transforms_;
    if (extended_.empty())
    {
        ++transforms_;
        derivatives_[pressureDerivative_[at(d)]](phi[0], slope, {});
        return;
    }
    ExtendedOperators& operators = extended_[extendedOf_[at(dimensions_)]];
    if (d == 0)
    {
        ++transforms_;
        operators.take(phi[0]);
    }
    operators.derivative(d, slope);
}

void BoundedFlow::evaluateRate(double t, double nu)
{
    for (int c = 0; c < dimensions_; ++c) { std::ranges::fill(rate_[c], uniformForce_[at(c)]); }
    const bool convects = settings_.convection != ConvectionForm::none;
    if (convects || nu > 0)
    {
        const auto scope = timings_.scope(Phase::transforms);
        for (int c = 0; c < dimensions_; ++c)
        {
            for (int d = 0; d < dimensions_; ++d)
            {
                const auto carrier = convects ? std::span<const double>(velocity_[d]) : std::span<const double>();
                outflow_.keep(d, rate_[c]);
                addTransport(c, d, velocity_[c], carrier, nu, rate_[c]);
                outflow_.replace(d, velocity_[c], carrier, rate_[c]);
            }
        }
    }
    if (force_.components() > 0)
    {
        if (!forceKnown_ || fluid_.bodyForce->dependsOnTime()) { fluid_.bodyForce->evaluate(t, force_); }
        forceKnown_ = true;
        for (int c = 0; c < dimensions_; ++c)
        {
            std::ranges::transform(rate_[c], force_[c], rate_[c].begin(), std::plus<>());
        }
    }
}

void BoundedFlow::divergenceOf(const RealField& u, double factor, RealField& divergence)
{
    const auto scope = timings_.scope(Phase::transforms);
    slopeOfVelocity(u, 0, divergence[0]);
    for (int d = 1; d < dimensions_; ++d)
    {
        slopeOfVelocity(u, d, scratch_[0]);
        const double ofSum = d == dimensions_ - 1 ? factor : 1;
        std::ranges::transform(divergence[0], scratch_[0], divergence[0].begin(),
                               [ofSum](double sum, double slope) { return ofSum * (sum + slope); });
    }
}

void BoundedFlow::subtractGradient(double period, const RealField& phi, RealField& u)
{
    const auto scope = timings_.scope(Phase::transforms);
    for (int d = 0; d < dimensions_; ++d)
    {
        const bool known = periodicSlope_ && periodicSlope_->direction == lattice_.direction(d);
        if (!known) { slopeOfPressure(phi, d, scratch_[0]); }
        std::ranges::transform(u[d], (known ? slope_ : scratch_)[0], u[d].begin(),
                               [period](double v, double slope) { return v - period * slope; });
    }
}

void BoundedFlow::readNormal(const RealField& u, double factor, bool add)
{
    for (int d = 0; d < dimensions_; ++d)
    {
        if (lattice_.activeAxis(d).periodic()) { continue; }
        const LineLayout lines = linesAlong(lattice_, lattice_.direction(d));
        for (std::size_t side = 0; side < 2; ++side)
        {
            const std::size_t end = side * (lines.count - 1) * lines.inner;
            auto& slopes = slopes_[at(d)][side];
            for (std::size_t l = 0; l < slopes.size(); ++l)
            {
                slopes[l] = (add ? slopes[l] : 0) + factor * u[d][lines.start(l) + end];
            }
        }
    }
}

void BoundedFlow::subtractPrescribed(double factor)
{
    for (int d = 0; d < dimensions_; ++d)
    {
        const int direction = lattice_.direction(d);
        if (lattice_.axis(direction).periodic()) { continue; }
        for (const Side side : {Side::low, Side::high})
        {
            auto& slopes = slopes_[at(d)][side == Side::low ? 0 : 1];
            const auto prescribed = boundary_.normalVelocity(direction, side);
            for (std::size_t l = 0; l < prescribed.size(); ++l) { slopes[l] -= factor * prescribed[l]; }
        }
    }
}

void BoundedFlow::readPressures()
{
    for (int d = 0; d < dimensions_; ++d)
    {
        const int direction = lattice_.direction(d);
        if (lattice_.axis(direction).periodic()) { continue; }
        for (const Side side : {Side::low, Side::high})
        {
            const PressureCondition condition = boundary_.face(direction, side).pressure;
            if (condition == PressureCondition::zeroGradient) { continue; }
            auto& slopes = slopes_[at(d)][side == Side::low ? 0 : 1];
            // Values as they are; outward slopes turned along the axis.
            const double sign = condition == PressureCondition::gradient && side == Side::low ? -1 : 1;
            const auto given = boundary_.pressure(direction, side);
            for (std::size_t l = 0; l < slopes.size(); ++l) { slopes[l] = given.empty() ? 0 : sign * given[l]; }
        }
    }
}

void BoundedFlow::slopesOfSource(int d)
{
    // One-sided differences of fifth order.
    constexpr std::array<double, pointsOfSlopes> weights{-137.0 / 60, 5, -5, 10.0 / 3, -5.0 / 4, 1.0 / 5};
    const int direction = lattice_.direction(d);
    const LineLayout lines = linesAlong(lattice_, direction);
    const double spacing = lattice_.axis(direction).spacing();
    const auto source = source_[0];
    for (std::size_t l = 0; l < lines.lines(); ++l)
    {
        const std::size_t low = lines.start(l);
        const std::size_t high = low + (lines.count - 1) * lines.inner;
        double slopeLow = 0;
        double slopeHigh = 0;
        for (std::size_t j = 0; j < weights.size(); ++j)
        {
            slopeLow += weights[j] * source[low + j * lines.inner];
            slopeHigh -= weights[j] * source[high - j * lines.inner];
        }
        const bool lowValue = boundary_.face(direction, Side::low).pressure == PressureCondition::value;
        const bool highValue = boundary_.face(direction, Side::high).pressure == PressureCondition::value;
        sourceSlopes_[0][l] = lowValue ? source[low] : slopeLow / spacing;
        sourceSlopes_[1][l] = highValue ? source[high] : slopeHigh / spacing;
    }
}

void BoundedFlow::solvePressure(const RealField& u, double period, bool keepsWalls, RealField& phi)
{
    divergenceOf(u, 1 / period, source_);
    solvePoisson(keepsWalls, phi);
}

void BoundedFlow::solvePoisson(bool keepsWalls, RealField& phi)
{
    const auto scope = timings_.scope(Phase::poisson);
    readPressures();
    WallData walls;
    for (int d = 0; d < dimensions_; ++d)
    {
        const int direction = lattice_.direction(d);
        const Axis& axis = lattice_.axis(direction);
        if (axis.periodic()) { continue; }
        const auto given = [&](Side side, std::size_t s) -> std::span<const double>
        {
            const bool slope = boundary_.face(direction, side).pressure == PressureCondition::zeroGradient;
            // Walls that were reset, or lie off the points, ask for no correction.
            if (slope && (keepsWalls || axis.staggered)) { return {}; }
            return slopes_[at(d)][s];
        };
        walls[at(direction)] = {given(Side::low, 0), given(Side::high, 1)};
    }
    if (direct_)
    {
        direct_->solve(0, -1, source_[0], walls, phi[0]);
        return;
    }
    if (iterated_)
    {
        if (apart_) { iterated_->solveApart(source_, walls, phi); }
        else { iterated_->solve(source_, walls, phi); }
        return;
    }
    transforms_ += extended_.empty() ? 2 * dimensions_ : 2;
    if (mirrored_)
    {
        mirrored_->solve(source_, walls, phi);
        return;
    }
    const PeriodicSlope* slope = periodicSlope_ ? &*periodicSlope_ : nullptr;
    if (slope != nullptr) { ++transforms_; }
    if (!closedAxis_)
    {
        poisson_->solve(source_, walls, phi, slope);
        return;
    }
    slopesOfSource(*closedAxis_);
    poisson_->solveClosed(source_, walls, {sourceSlopes_[0], sourceSlopes_[1]}, phi, slope);
}

void BoundedFlow::addRates(const Substep& substep, double dt)
{
    const auto scope = timings_.scope(Phase::pointwise);
    const double g = dt * substep.g;
    const double z = dt * substep.z;
    for (int c = 0; c < dimensions_; ++c)
    {
        const auto u = velocity_[c];
        const auto now = rate_[c];
        const auto past = previousRate_[c];
        if (substep.first)
        {
            for (std::size_t i = 0; i < u.size(); ++i) { u[i] += g * now[i]; }
        }
        else
        {
            for (std::size_t i = 0; i < u.size(); ++i) { u[i] += g * now[i] + z * past[i]; }
        }
    }
    std::swap(rate_, previousRate_);
}

void BoundedFlow::advance(const Substep& substep, double t, double dt)
{
    const double period = substep.a * dt;
    if (iterated_) { iterated_->begin(substep); }
    if (substep.first)
    {
        copyInto(velocity_, before_);
        stepBefore_ = std::exchange(lastStep_, dt);
        if (mayYield_ && explicitRate_ == 0) { rates(); }
        implicit_ = fluid_.nu > 0 && (settings_.crankNicolson || (mayYield_ && dt * explicitRate_ > 1 && canYield()));
        // What an explicit step leaves is of a substep, not of the time it ends at: it is not marched on.
        if (!marchesPressure()) { pressureKnown_ = false; }
        else if (!pressureKnown_ && !marches(WallTreatment::pressurePoisson))
        {
            copyInto(pressure(t), phi_);
            pressureKnown_ = true;
        }
        if (marchesPressure()) { copyInto(phi_, phiBefore_); }
    }
    boundary_.update(t + substep.start * dt);
    // What slips along walls after the projection of the start does so no longer.
    if (substep.first) { boundary_.impose(velocity_); }
    if (marches(WallTreatment::pressurePoisson)) { return advanceByPressurePoisson(substep, t, dt); }

    evaluateRate(t + substep.start * dt, implicit_ ? 0 : fluid_.nu);
    const double beta = 0.5 * period * fluid_.nu;
    if (implicit_)
    {
        laplacian(velocity_, laplacian_);
        addScaled(beta, laplacian_, velocity_);
    }
    addRates(substep, dt);
    boundary_.update(t + (substep.start + substep.a) * dt);

    // An implicit viscous term leaves the walls no momentum to take the pressure's slope from: it goes by increments.
    const bool incremental = implicit_ || marches(WallTreatment::incremental) || marches(WallTreatment::rotational);
    const bool keepsWalls = incremental || marches(WallTreatment::paper);
    if (incremental)
    {
        gradientOf(phi_, gradient_);
        addScaled(-period, gradient_, velocity_);
    }
    if (implicit_) { solveViscous(beta); }
    else if (keepsWalls) { boundary_.impose(velocity_); }
    if (marches(WallTreatment::slip))
    {
        gradientOf(phi_, gradient_);
        presetTangential(period);
    }
    readNormal(velocity_, 1 / period);
    subtractPrescribed(1 / period);
    if (incremental) { projectIncrement(period); }
    else
    {
        solvePressure(velocity_, period, keepsWalls, phi_);
        subtractGradient(period, phi_, velocity_);
    }
    finishStep(substep);
}

void BoundedFlow::finishStep(const Substep& substep)
{
    if (substep.last && !filters_.empty())
    {
        const auto scope = timings_.scope(Phase::transforms);
        for (int c = 0; c < dimensions_; ++c)
        {
            for (int d = 0; d < dimensions_; ++d)
            {
                filters_[derivativeOf_[at(c)][at(d)]](velocity_[c], endData(c, d));
            }
        }
        transforms_ += 2 * dimensions_ * dimensions_;
    }
    const auto scope = timings_.scope(Phase::boundary);
    boundary_.impose(velocity_);
    if (balance_) { balance_->correct(velocity_); }
}

const RealField& BoundedFlow::pressure(double t)
{
    if (pressure_.components() == 0) { pressure_ = RealField(1, lattice_.points()); }
    // The rate of change itself, projected: its prescribed normal component is the walls' acceleration.
    const long made = transforms_;
    apart_ = true;
    boundary_.update(t);
    evaluateRate(t, fluid_.nu);
    readNormal(rate_, 1);
    if (balance_) { balance_->begin(); }
    subtractAcceleration(t);
    solvePressure(rate_, 1, false, pressure_);
    if (balance_)
    {
        subtractGradient(1, pressure_, rate_);
        balance_->addPressure(rate_, pressure_);
    }
    transforms_ = made;
    apart_ = false;
    return pressure_;
}

} // namespace isph
