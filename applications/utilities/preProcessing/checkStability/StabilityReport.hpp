#pragma once

#include "core/Json.hpp"
#include "core/Log.hpp"
#include "flow/stableNumbers.hpp"
#include "stability/makeTrials.hpp"
#include "stability/sceneSpectra.hpp"

#include <string>
#include <vector>

namespace isph
{

/// What a trial was, without the flow itself.
struct TrialSummary
{
    std::string term;
    std::string what;
    double limit = unlimited;                ///< [s]
    std::optional<double> limitOfModes = {}; ///< [s], where the modes are known
    double growthInTime = 0;                 ///< of the fastest mode, whatever the step [1/s]
    TrialResult result = {};                 ///< empty if nothing was tried

    /// Whether modes of this term may grow with steps that its limit allows, and whether they were seen to.
    bool modesMayGrow() const;
    bool modesGrow() const;
};

/// All that checkStability finds out.
struct StabilityReport
{
    std::string caseName;
    std::string scheme;
    const TimeScheme* time = nullptr;
    std::vector<OperatorSpectrum> spectra = {};
    StableNumbers numbers = {};
    std::vector<TrialSummary> trials = {};
    std::vector<std::string> leftOut = {};
    std::optional<double> growthAtRest = {}; ///< of a step between walls
    bool tried = true;

    /// Every trial did what was expected of it.
    bool agrees() const;

    /// The same of any term.
    bool modesMayGrow() const;
    bool modesGrow() const;
};

TrialSummary summaryOf(const StabilityTrial& trial, TrialResult result);

/// What is known before any trial.
void printPrediction(const StabilityReport& report, Log& log);
void printTrial(const TrialSummary& trial, Log& log);
void printVerdict(const StabilityReport& report, Log& log);

Json jsonOf(const StabilityReport& report);

} // namespace isph
