#include "flow/BoundedFlow.hpp"

#include "fields/fieldOperations.hpp"
#include "flow/convectiveRates.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace isph
{

namespace
{

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr std::array<Side, 2> sides{Side::low, Side::high};

} // namespace

void BoundedFlow::laplacian(const RealField& u, RealField& result)
{
    const auto scope = timings_.scope(Phase::transforms);
    for (int c = 0; c < dimensions_; ++c)
    {
        std::ranges::fill(result[c], 0.0);
        for (int d = 0; d < dimensions_; ++d)
        {
            if (!extended_.empty())
            {
                addTransport(c, d, u[c], {}, 1, result[c]);
                continue;
            }
            derivatives_[viscousDerivativeOf_[at(c)][at(d)]].addTransport(u[c], {}, 1, result[c], endData(c, d));
        }
    }
}

void BoundedFlow::gradientOf(const RealField& phi, RealField& result)
{
    const auto scope = timings_.scope(Phase::transforms);
    for (int d = 0; d < dimensions_; ++d) { slopeOfPressure(phi, d, result[d]); }
}

void BoundedFlow::presetTangential(double period)
{
    for (int d = 0; d < dimensions_; ++d)
    {
        const int direction = lattice_.direction(d);
        const LineLayout lines = linesAlong(lattice_, direction);
        for (const Side side : sides)
        {
            const std::size_t end = side == Side::high ? (lines.count - 1) * lines.inner : 0;
            for (int c = 0; c < dimensions_; ++c)
            {
                const auto prescribed = boundary_.velocity(direction, side, c);
                const LineLayout along = linesAlong(lattice_, lattice_.direction(c));
                const bool meetsWalls = !lattice_.activeAxis(c).periodic();
                for (std::size_t l = 0; c != d && l < prescribed.size(); ++l)
                {
                    const std::size_t point = lines.start(l) + end;
                    // In corners it is the velocity normal to another wall.
                    const std::size_t place = point / along.inner % along.count;
                    if (meetsWalls && (place == 0 || place + 1 == along.count)) { continue; }
                    velocity_[c][point] = prescribed[l] + period * gradient_[c][point];
                }
            }
        }
    }
}

void BoundedFlow::solveViscous(double beta)
{
    const auto scope = timings_.scope(Phase::poisson);
    for (int c = 0; c < dimensions_; ++c)
    {
        WallData walls;
        for (int d = 0; d < dimensions_; ++d)
        {
            const int direction = lattice_.direction(d);
            if (lattice_.axis(direction).periodic()) { continue; }
            walls[at(direction)] = {boundary_.velocity(direction, Side::low, c),
                                    boundary_.velocity(direction, Side::high, c)};
        }
        helmholtz_[at(c)].solve(1, beta, velocity_[c], walls, velocity_[c]);
    }
}

void BoundedFlow::projectIncrement(double period)
{
    solvePressure(velocity_, period, true, increment_);
    subtractGradient(period, increment_, velocity_);
    addScaled(1, increment_, phi_);
    if (marches(WallTreatment::rotational)) { addScaled(-fluid_.nu * period, source_, phi_); }
}

double BoundedFlow::pauseAt(double t) const
{
    double scale = lastStep_;
    if (scale == 0)
    {
        StepRates rates;
        addConvectiveRates(lattice_, velocity_, bounds_, 0, rates);
        const double rate = rates.convective + fluid_.nu * bounds_.laplacian;
        // Where nothing moves yet and nothing diffuses, no time is longer than another.
        scale = rate > 0 ? 1 / rate : 1;
    }
    // Late times have no digits left for short pauses.
    return std::max(0.01 * scale, 1e-8 * std::abs(t));
}

void BoundedFlow::subtractAcceleration(double t)
{
    if (!boundary_.dependsOnTime()) { return; }
    const double pause = pauseAt(t);
    const double before = std::max(t - pause, std::min(t, 0.0));
    const double weight = 1 / (t + pause - before);
    boundary_.update(t + pause);
    subtractPrescribed(weight);
    if (balance_) { balance_->prescribe(weight); }
    boundary_.update(before);
    subtractPrescribed(-weight);
    if (balance_) { balance_->prescribe(-weight); }
    boundary_.update(t);
}

void BoundedFlow::advanceByPressurePoisson(const Substep& substep, double t, double dt)
{
    // Below 0.1 divergence gathers, at 1 the feedback is unstable.
    constexpr double feedback = 0.2;
    const double start = t + substep.start * dt;
    evaluateRate(start, 0);
    divergenceOf(velocity_, 1, increment_);
    divergenceOf(rate_, 1, source_);
    addScaled(feedback / dt, increment_, source_);
    if (fluid_.nu > 0)
    {
        laplacian(velocity_, laplacian_);
        addScaled(fluid_.nu, laplacian_, rate_);
        gradientOf(increment_, gradient_);
    }
    // -curl curl u = lap u - grad div u.
    readNormal(rate_, 1);
    if (fluid_.nu > 0) { readNormal(gradient_, -fluid_.nu, true); }
    subtractAcceleration(start);
    solvePoisson(false, phi_);
    subtractGradient(1, phi_, rate_);
    addRates(substep, dt);
    boundary_.update(start + substep.a * dt);
    finishStep(substep);
}

} // namespace isph
