#include "transport/ScalarTransport.hpp"

#include "fields/reductions.hpp"
#include "flow/convectiveRates.hpp"
#include "operators/continuedBounds.hpp"
#include "operators/lineSymbolOf.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <ranges>
#include <span>
#include <utility>

namespace isph
{

namespace
{

/// A filter as the second derivative of a symbol: d2f = -second f.
LineSymbol symbolOf(std::span<const double> factors, int length)
{
    const auto modes = static_cast<std::size_t>(length / 2 + 1);
    LineSymbol symbol;
    symbol.first.assign(modes, 0.0);
    for (const double factor : factors.first(modes)) { symbol.second.push_back(-factor); }
    return symbol;
}

} // namespace

ScalarTransport::ScalarTransport(const Lattice& lattice, double diffusivity, const FlowSettings& settings,
                                 const GivenVelocity& velocity, ScalarBoundary& boundary, Timings& timings)
    : lattice_(lattice),
      diffusivity_(diffusivity),
      settings_(settings),
      given_(velocity),
      boundary_(boundary),
      timings_(timings),
      bounds_(continuedBounds(lattice, settings.continuations, settings.kernel, settings.laplacian)),
      velocity_(lattice.dimensions(), lattice.points()),
      values_(1, lattice.points()),
      before_(1, lattice.points()),
      rate_(1, lattice.points()),
      previousRate_(1, lattice.points())
{
    makeDerivatives();
    makeFilters();
}

ContinuedTransform ScalarTransport::transformAlong(int d) const
{
    const Axis& axis = lattice_.activeAxis(d);
    const int direction = lattice_.direction(d);
    const auto& continuation = settings_.continuations[static_cast<std::size_t>(direction)];
    std::optional<LineContinuation> ends;
    if (continuation)
    {
        ends.emplace(*continuation, axis.count, boundary_.endCondition(direction, Side::low),
                     boundary_.endCondition(direction, Side::high));
    }
    return {linesAlong(lattice_, direction), std::move(ends)};
}

void ScalarTransport::makeDerivatives()
{
    for (int d = 0; d < lattice_.dimensions(); ++d)
    {
        ContinuedTransform transform = transformAlong(d);
        const LineSymbol symbol =
            lineSymbolOf(settings_.kernel, settings_.laplacian, transform.length(), lattice_.activeAxis(d).spacing());
        derivatives_.emplace_back(std::move(transform), symbol);
    }
}

void ScalarTransport::makeFilters()
{
    const Lattice extended = extendedLattice(lattice_, settings_.continuations);
    const auto add = [&](std::vector<LineFilter>& filters, const FilterSettings& filter, bool boundedToo)
    {
        const auto factors = filterFactors(extended, filter);
        for (int d = 0; d < lattice_.dimensions(); ++d)
        {
            if (!boundedToo && !lattice_.activeAxis(d).periodic()) { continue; }
            ContinuedTransform transform = transformAlong(d);
            const LineSymbol symbol = symbolOf(factors[static_cast<std::size_t>(d)], transform.length());
            filters.push_back({d, {std::move(transform), symbol}});
        }
    };
    if (settings_.filter.type != FilterSettings::Type::none) { add(lowPass_, settings_.filter, true); }

    // A velocity that does not vary makes no product: it carries every mode as it is.
    evaluateVelocity(0);
    const bool varies = given_.dependsOnTime() ||
                        std::ranges::any_of(std::views::iota(0, velocity_.components()),
                                            [this](int d)
                                            {
                                                const auto u = velocity_[d];
                                                return std::ranges::adjacent_find(u, std::not_equal_to<>()) != u.end();
                                            });
    if (convects() && varies && settings_.dealiasing == Dealiasing::twoThirds)
    {
        add(dealiasing_, {.type = FilterSettings::Type::cutoff, .fraction = 0.6666}, false);
    }
}

void ScalarTransport::evaluateVelocity(double t)
{
    if (velocityTime_ && (!given_.dependsOnTime() || *velocityTime_ == t)) { return; }
    given_.evaluate(t, velocity_);
    velocityTime_ = t;
}

double ScalarTransport::prepare(RealField& values, double t)
{
    double dropped = 0;
    boundary_.update(t);
    if (dealiases())
    {
        const RealField given = copyOf(values);
        filter(dealiasing_, values);
        const double whole = sumOfSquares(given[0]);
        RealField difference = copyOf(given);
        std::ranges::transform(given[0], values[0], difference[0].begin(), std::minus<>());
        dropped = whole > 0 ? std::sqrt(sumOfSquares(difference[0]) / whole) : 0;
    }
    boundary_.impose(values[0]);
    return dropped;
}

void ScalarTransport::start(const RealField& values, double t)
{
    boundary_.update(t);
    std::ranges::copy(values[0], values_[0].begin());
    std::ranges::copy(values[0], before_[0].begin());
    largestStart_ = largestMagnitude(values_[0]);
}

void ScalarTransport::step(double t, double dt)
{
    std::ranges::copy(values_[0], before_[0].begin());
    for (const Substep& substep : settings_.time->substeps) { advance(substep, t, dt); }
}

void ScalarTransport::stepBack() { std::ranges::copy(before_[0], values_[0].begin()); }

void ScalarTransport::advance(const Substep& substep, double t, double dt)
{
    const double now = t + substep.start * dt;
    {
        const auto scope = timings_.scope(Phase::boundary);
        boundary_.update(now);
        if (convects()) { evaluateVelocity(now); }
    }
    std::ranges::fill(rate_[0], 0.0);
    addRate(rate_);
    if (dealiases()) { filter(dealiasing_, rate_); }
    {
        const auto scope = timings_.scope(Phase::pointwise);
        const std::span<double> T = values_[0];
        const std::span<const double> rate = rate_[0];
        const std::span<const double> previous = previousRate_[0];
        const double g = dt * substep.g;
        const double z = dt * substep.z;
        if (substep.first)
        {
            for (std::size_t i = 0; i < T.size(); ++i) { T[i] += g * rate[i]; }
        }
        else
        {
            for (std::size_t i = 0; i < T.size(); ++i) { T[i] += g * rate[i] + z * previous[i]; }
        }
        std::swap(rate_, previousRate_);
    }
    if (substep.last) { filter(lowPass_, values_); }
    const auto scope = timings_.scope(Phase::boundary);
    boundary_.update(t + (substep.start + substep.a) * dt);
    boundary_.impose(values_[0]);
}

void ScalarTransport::addRate(RealField& rate)
{
    const auto scope = timings_.scope(Phase::transforms);
    for (int d = 0; d < lattice_.dimensions(); ++d)
    {
        const std::span<const double> carrier = convects() ? std::as_const(velocity_)[d] : std::span<const double>();
        derivatives_[static_cast<std::size_t>(d)].addTransport(values_[0], carrier, diffusivity_, rate[0],
                                                               boundary_.endData(lattice_.direction(d)));
        transforms_ += 1 + (convects() ? 1 : 0) + (diffusivity_ > 0 ? 1 : 0);
    }
}

void ScalarTransport::filter(std::vector<LineFilter>& filters, RealField& values)
{
    const auto scope = timings_.scope(Phase::transforms);
    for (LineFilter& filter : filters)
    {
        filter.apply(values[0], {}, values[0], boundary_.endData(lattice_.direction(filter.axis)));
        transforms_ += 2;
    }
}

StepRates ScalarTransport::rates(double t)
{
    StepRates rates;
    rates.viscous = diffusivity_ * bounds_.laplacian;
    if (convects())
    {
        evaluateVelocity(t);
        addConvectiveRates(lattice_, velocity_, bounds_, diffusivity_, rates);
    }
    return rates;
}

double ScalarTransport::largest() const { return largestMagnitude(values_[0]); }

bool ScalarTransport::sound(double over) const
{
    const double now = largest();
    if (!std::isfinite(now)) { return false; }
    return boundary_.prescribesFlux() || now <= over * std::max(largestStart_, boundary_.largestValue());
}

double ScalarTransport::rateOfChange(double dt) const
{
    double change = 0;
    for (std::size_t i = 0; i < values_.size(); ++i)
    {
        change = std::max(change, std::abs(values_[0][i] - before_[0][i]));
    }
    return change / dt;
}

} // namespace isph
