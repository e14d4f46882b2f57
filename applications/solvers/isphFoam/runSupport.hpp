#pragma once

#include "case/readTimeControl.hpp"
#include "core/CommandLine.hpp"
#include "core/Log.hpp"
#include "flow/RunReport.hpp"
#include "flow/Scene.hpp"
#include "functions/functionSelection.hpp"

#include <string>
#include <vector>

namespace isph
{

/// The functions of controlDict, none with -noFunctionObjects.
/// \param startTime name of the time folder they begin at
Functions readFunctions(const CommandLine& line, const Case& flowCase, const Scene& scene,
                        const std::string& startTime);

/// What the start did to the velocity, as lines of the log.
std::vector<std::string> linesOn(const StartReport& started);

/// The norms of the divergence, as a line of the log.
std::string divergenceLine(IncompressibleFlow& flow);

/// Takes note of what iterations for the pressure took, and warns of those of the last step that did not converge.
void notePressure(const IncompressibleFlow& flow, RunReport& report, Log& log);

/// A flow as its functions see it.
FlowAtTime flowAtTime(IncompressibleFlow& flow, const TimeControl& control, const Timings& timings);

RunReport openReport(const Case& flowCase, const Scene& scene, int threads);

/// A restart ends in the same bits only with the transform plans of the run before: says so when they differ.
void warnOfOtherPlans(const Case& flowCase, const StartFolder& start, const IncompressibleFlow& flow, Log& log);

/// Largest |dU/dt| over points, for steadyTolerance; holds a velocity only where that is asked for.
class SteadyCheck
{
public:
    SteadyCheck(const std::optional<double>& tolerance, IncompressibleFlow& flow);

    bool asked() const { return previous_.components() > 0; }

    /// [m/s2], of the step of dt that was just taken.
    double acceleration(IncompressibleFlow& flow, double dt);

private:
    RealField previous_;
};

} // namespace isph
