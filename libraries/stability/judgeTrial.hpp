#pragma once

#include "schemes/amplification.hpp"

#include <limits>
#include <optional>
#include <vector>

namespace isph
{

/// What a trial can be expected to do, or did.
enum class Verdict
{
    stable,
    unstable,
    either ///< beyond a limit that is only sufficient, or too near to it to say
};

/// Growth of a step (logarithm of the factor) below which noise counts as not growing.
inline constexpr double growthThreshold = 0.003;

/// What is known of a term before any trial.
struct Prediction
{
    const TimeScheme* scheme = nullptr;
    double limit = std::numeric_limits<double>::infinity(); ///< the largest stable step that the suite prints [s]
    std::vector<ModeRate> modes;                            ///< of the linear flow; empty: not known

    /// What a step makes grow where nothing acts but the projection, as the logarithm of the factor.
    double growthAtRest = 0;

    /// Growth at rest is there, but the term may damp it: below the limit anything goes.
    bool mayDamp = false;

    /// Growth of a step by the modes that counts as beyond doubt, in thresholds: more where they are only nearly right.
    double doubt = 2;

    /// From this multiple of the limit on modes that grow must be seen to; below it, above the limit, anything goes.
    /// Infinity: the limit is only sufficient.
    double sharpness = 1;
};

/// Growth of a step by the modes and the projection; nothing where the modes are not known.
std::optional<double> predictedGrowth(const Prediction& prediction, double dt);

/// Below the limit a trial has to be stable, unless modes grow in exact time; above it the modes decide.
Verdict expectation(const Prediction& prediction, double dt);

/// How large noise was while a flow marched.
struct NoiseHistory
{
    std::vector<double> times;      ///< [s], from the start on
    std::vector<double> amplitudes; ///< positive
    std::vector<int> steps;         ///< made until then
    int made = 0;                   ///< steps in all, the last ones of which may not be finite
    double dt = 0;                  ///< the first step [s]
    bool finite = true;             ///< to the end
};

/// Growth of a step (logarithm): over the last third of a history, so that what dies out at first does not count. Noise
/// that has died down to round-off does not grow: -1.
double growthOf(const NoiseHistory& history);

/// Growth of a step beyond what the flow does to noise by itself, which a reference with small steps shows: over the
/// time that both have in common.
double growthBeyond(const NoiseHistory& reference, const NoiseHistory& history);

/// What a trial showed.
struct Outcome
{
    double dt = 0;      ///< [s]
    double growth = 0;  ///< of a step
    int steps = 0;      ///< made
    bool finite = true; ///< to the end
};

/// \throws nothing; a growth that is not a number counts as unstable
Verdict observation(const Outcome& outcome);

/// Whether a trial did what was expected of it.
bool agree(Verdict expected, Verdict observed);

} // namespace isph
