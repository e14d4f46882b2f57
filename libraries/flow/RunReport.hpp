#pragma once

#include "case/Case.hpp"
#include "case/TimeControl.hpp"
#include "core/Json.hpp"
#include "core/Log.hpp"
#include "core/Timings.hpp"
#include "flow/describeScene.hpp"
#include "flow/PressureRecord.hpp"
#include "schemes/stabilityLimits.hpp"

#include <optional>
#include <string>

namespace isph
{

/// A norm of the error of a field, e.g. U, relL2.
struct ReportedError
{
    std::string field;
    std::string norm;
    double value;
};

/// What a run was and what it cost: the table at the end of the log, and postProcessing/report.json (contract, section
/// 6).
struct RunReport
{
    static constexpr int schema = 1;

    std::string caseName;
    Lattice lattice;
    SceneDescription scene;
    int threads = 1;
    int substepsPerStep = 1;
    StabilityMargin margin; ///< largest dt over its limit so far
    long transforms = 0;    ///< of one component, in steps

    std::vector<ReportedError> errors;
    std::optional<PressureRecord> pressure; ///< where it is iterated

    /// Takes note of a step.
    /// \param transformsSoFar of one component, in all steps
    void step(const StabilityMargin& ofStep, long transformsSoFar);

    /// Seconds in steps: all phases but set-up, functions and output, over points and substeps.
    double secondsPerPointAndSubstep(const Timings& timings, long steps) const;

    Json json(const TimeControl& control, const Timings& timings, Ending endedBecause) const;
    void print(Log& log, const TimeControl& control, const Timings& timings) const;
};

/// Writes postProcessing/report.json.
void writeReport(const Case& theCase, const Json& report);

} // namespace isph
