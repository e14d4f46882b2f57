#include "stability/StabilityTrial.hpp"

#include "fields/fieldOperations.hpp"
#include "fields/reductions.hpp"
#include "flow/BoundedFlow.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace isph
{

namespace
{

constexpr double noiseLevel = 1e-6; ///< of the velocity
constexpr double beyondDoubt = 1e4; ///< growth after which a trial ends: still small against the base
constexpr int amplitudesTaken = 30;

double largestSpeed(const RealField& velocity)
{
    double largest = 0;
    for (int c = 0; c < velocity.components(); ++c) { largest = std::max(largest, largestMagnitude(velocity[c])); }
    return largest;
}

RealField disturbed(const RealField& base, double amplitude)
{
    RealField result = copyOf(base);
    std::minstd_rand random(1);
    for (int c = 0; c < result.components(); ++c)
    {
        for (double& value : result[c])
        {
            value += amplitude * (2 * static_cast<double>(random()) / static_cast<double>(std::minstd_rand::max()) - 1);
        }
    }
    return result;
}

double distance(const RealField& a, const RealField& b)
{
    double squares = 0;
    for (int c = 0; c < a.components(); ++c)
    {
        for (std::size_t i = 0; i < a.size(); ++i) { squares += (a[c][i] - b[c][i]) * (a[c][i] - b[c][i]); }
    }
    return std::sqrt(squares);
}

/// What noise does to a flow that marches.
/// \param base velocity that noise differs from, and starts on, where there is no calm flow
/// \param calm the same flow, to march without noise beside it; or null
/// \param step length of the next step; not finite: nothing limits it, and the march ends
NoiseHistory marchNoise(const TimeScheme& scheme, IncompressibleFlow& flow, IncompressibleFlow* calm,
                        const RealField& base, double start, int steps, const std::function<double()>& step)
{
    const double speed = largestSpeed(base);
    flow.start(disturbed(base, noiseLevel * (speed > 0 ? speed : 1)), true);
    if (calm != nullptr) { calm->start(base, true); }
    const auto amplitude = [&] { return distance(flow.velocity(), calm != nullptr ? calm->velocity() : base); };

    NoiseHistory history{.times = {0}, .amplitudes = {amplitude()}, .steps = {0}};
    const int between = std::max(1, steps / amplitudesTaken);
    double t = start;
    const auto take = [&]
    {
        const double reached = amplitude();
        history.finite = std::isfinite(reached);
        if (!history.finite) { return; }
        history.times.push_back(t - start);
        history.steps.push_back(history.made);
        history.amplitudes.push_back(reached);
    };
    while (history.made < steps)
    {
        const double dt = step();
        if (!std::isfinite(dt)) // nothing limits the step of a flow that has come to rest
        {
            history.finite = !std::isnan(dt);
            if (history.finite && history.steps.back() != history.made) { take(); }
            break;
        }
        if (history.made == 0) { history.dt = dt; }
        advance(scheme, flow, t, dt);
        if (calm != nullptr) { advance(scheme, *calm, t, dt); }
        t += dt;
        if (++history.made % between != 0) { continue; }
        take();
        if (!history.finite || history.amplitudes.back() > beyondDoubt * history.amplitudes.front()) { break; }
    }
    return history;
}

} // namespace

double growthOfProjection(const Lattice& lattice, const FlowSettings& settings, FlowBoundary& atRest)
{
    constexpr int steps = 300;
    constexpr double anyStep = 1;
    const Fluid inviscid;
    Timings timings;
    atRest.update(0);
    BoundedFlow flow(lattice, inviscid, settings, atRest, timings, PlanEffort::estimated);
    const RealField nothing(lattice.dimensions(), lattice.points());
    return growthOf(marchNoise(*settings.time, flow, nullptr, nothing, 0, steps, [=] { return anyStep; }));
}

namespace
{

/// Marches steps of a fraction of the limit, fewer where the noise has grown beyond doubt.
NoiseHistory runTrial(StabilityTrial& trial, double fraction, int steps, Timings& timings)
{
    Scene& scene = *trial.scene;
    const TimeScheme& scheme = *scene.settings.time;
    scene.boundary.update(trial.time);
    const auto flow = makeFlow(scene, timings, PlanEffort::estimated);
    const auto calm = trial.steady ? nullptr : makeFlow(scene, timings, PlanEffort::estimated);
    const auto step = [&]
    {
        if (trial.steady) { return fraction * trial.unit.value_or(trial.prediction.limit); }
        // Both flows may choose how they take their viscous term, and know their rates then.
        flow->rates();
        return fraction * largestStableStep(scheme, calm->rates());
    };
    return marchNoise(scheme, *flow, calm.get(), trial.base, trial.time, steps, step);
}

/// Steps after which the fastest mode, one of all those that noise is made of, stands out clearly; not fewer than asked
/// for, and as many as that where the modes are not expected to grow.
int stepsToSee(const StabilityTrial& trial, double fraction, int steps)
{
    constexpr double clearly = 2; // logarithm
    constexpr double lastThird = 1.5;
    constexpr double patience = 3000;
    if (!trial.steady || trial.unit) { return steps; }
    const double dt = fraction * trial.prediction.limit;
    if (expectation(trial.prediction, dt) != Verdict::unstable) { return steps; }
    const auto values = static_cast<double>(trial.base.size()) * trial.base.components();
    const double growth = predictedGrowth(trial.prediction, dt).value_or(1);
    const double needed = lastThird * (0.5 * std::log(values) + clearly) / growth;
    return std::max(steps, static_cast<int>(std::min(needed, patience)));
}

/// Growth of a step of the reference beyond what stretching can do to noise.
double growthBeyondStretching(const NoiseHistory& history, double rate)
{
    if (history.steps.size() < 2) { return 0; }
    const double grown = std::log(history.amplitudes.back() / history.amplitudes.front());
    return std::max(grown - rate * history.times.back(), std::min(grown, 0.0)) / history.steps.back();
}

} // namespace

TrialResult runFractions(StabilityTrial& trial, int steps, Timings& timings, const std::function<void(double)>& begins)
{
    constexpr double ofReference = 0.5;
    constexpr double large = 4; // logarithm of all its growth
    TrialResult result;
    std::optional<NoiseHistory> reference;
    bool hides = trial.modesGrow;
    if (!trial.steady)
    {
        begins(ofReference);
        reference = runTrial(trial, ofReference, 2 * steps, timings);
        const double grown = std::log(reference->amplitudes.back() / reference->amplitudes.front());
        const bool flowGrows = growthBeyondStretching(*reference, trial.stretching) <= growthThreshold && grown > large;
        hides = hides || flowGrows;
        if (trial.modesGrow) { result.note = "a term grows by itself: nothing can be said of all of them together"; }
        else if (flowGrows) { result.note = "noise grows in this flow by itself, and hides what steps add to it"; }
    }
    for (const double fraction : trial.fractions)
    {
        const bool isReference = reference && fraction == ofReference;
        if (!isReference) { begins(fraction); }
        const NoiseHistory history =
            isReference ? *reference : runTrial(trial, fraction, stepsToSee(trial, fraction, steps), timings);
        TrialRow row{.term = trial.term, .fraction = fraction};
        row.outcome = {.dt = history.dt, .steps = history.made, .finite = history.finite};
        row.outcome.growth = !reference    ? growthOf(history)
                             : isReference ? growthBeyondStretching(history, trial.stretching)
                                           : growthBeyond(*reference, history);
        row.predicted = predictedGrowth(trial.prediction, history.dt);
        row.expected = expectation(trial.prediction, history.dt);
        // The limit is that of each step's velocity, the one of the start is not it.
        if (reference) { row.expected = fraction <= 1 && !hides ? Verdict::stable : Verdict::either; }
        row.observed = observation(row.outcome);
        row.agrees = agree(row.expected, row.observed);
        result.rows.push_back(std::move(row));
    }
    return result;
}

} // namespace isph
