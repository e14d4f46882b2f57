#include "stability/judgeTrial.hpp"

#include <algorithm>
#include <cmath>

namespace isph
{

std::optional<double> predictedGrowth(const Prediction& prediction, double dt)
{
    if (prediction.modes.empty()) { return std::nullopt; }
    return largestGrowth(*prediction.scheme, prediction.modes, dt) +
           (prediction.mayDamp ? 0 : std::max(prediction.growthAtRest, 0.0));
}

Verdict expectation(const Prediction& prediction, double dt)
{
    constexpr double hardly = 0.5 * growthThreshold;
    const double clearly = prediction.doubt * growthThreshold;
    const bool below = dt <= prediction.limit;
    const auto growth = predictedGrowth(prediction, dt);
    if (below)
    {
        if (prediction.mayDamp && prediction.growthAtRest > hardly) { return Verdict::either; }
        // The limit promises that steps add no growth, not that they take away what there is without them.
        const double always = dt * exactGrowth(prediction.modes) + std::max(prediction.growthAtRest, 0.0);
        if (always < hardly || (growth && *growth < hardly)) { return Verdict::stable; }
        return growth.value_or(always) > clearly ? Verdict::unstable : Verdict::either;
    }
    if (!growth || dt < prediction.sharpness * prediction.limit) { return Verdict::either; }
    return *growth < hardly ? Verdict::stable : *growth > clearly ? Verdict::unstable : Verdict::either;
}

Verdict observation(const Outcome& outcome)
{
    const bool stable = outcome.finite && outcome.growth <= growthThreshold;
    return stable ? Verdict::stable : Verdict::unstable;
}

bool agree(Verdict expected, Verdict observed) { return expected == Verdict::either || expected == observed; }

double growthOf(const NoiseHistory& history)
{
    constexpr double roundOff = 1e-7; // noise wanders about there
    if (history.amplitudes.size() < 2) { return 0; }
    const std::size_t last = history.amplitudes.size() - 1;
    const std::size_t from = last - std::max<std::size_t>(1, last / 3);
    if (history.amplitudes[last] <= roundOff * history.amplitudes[0]) { return -1; }
    return std::log(history.amplitudes[last] / history.amplitudes[from]) / (history.steps[last] - history.steps[from]);
}

double growthBeyond(const NoiseHistory& reference, const NoiseHistory& history)
{
    // Two runs of an unstable flow do not follow each other to the end.
    constexpr double slack = 1.5;
    if (history.amplitudes.size() < 2) { return 0; }
    std::size_t mine = history.times.size() - 1;
    while (mine > 1 && history.times[mine] > reference.times.back()) { --mine; }
    std::size_t other = reference.times.size() - 1;
    while (other > 0 && reference.times[other - 1] >= history.times[mine]) { --other; }
    const double grown = std::log(history.amplitudes[mine] / history.amplitudes[0]);
    const double byItself = std::log(reference.amplitudes[other] / reference.amplitudes[0]);
    return (grown - slack * std::max(byItself, 0.0)) / history.steps[mine];
}

} // namespace isph
