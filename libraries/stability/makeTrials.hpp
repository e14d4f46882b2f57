#pragma once

#include "case/Case.hpp"
#include "stability/StabilityTrial.hpp"

#include <optional>
#include <string>
#include <vector>

namespace isph
{

/// The trials that judge the schemes of a case, and why others are left out.
struct TrialPlan
{
    std::vector<StabilityTrial> trials;
    std::vector<std::string> leftOut;

    /// What a step makes grow between walls where nothing acts but the projection (logarithm of the factor): there it
    /// is no projector of matrices but one of functions, and kernels that smooth much can make it magnify modes at the
    /// walls.
    std::optional<double> growthAtRest;
};

/// Makes a trial for each term whose step is limited, one for a viscous term that is not, and one that marches the
/// case's own start with every term (docs/theory/stability.md).
/// \param time name of the folder that a run starts from
/// \param fractions of the limits, ascending
/// \throws Error(input) for whatever is wrong with the case
TrialPlan makeTrials(const Case& flowCase, const std::string& time, const std::vector<double>& fractions);

} // namespace isph
