#pragma once

#include "flow/Scene.hpp"
#include "stability/judgeTrial.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace isph
{

/// A flow that is disturbed by noise, to see whether the noise grows.
struct StabilityTrial
{
    std::string term; ///< "convective", "viscous", "implicit viscous", "own start"
    std::string what; ///< "uniform flow of 1 m/s along x, the walls move with it"
    std::unique_ptr<Scene> scene;
    RealField base;        ///< velocity at the start [m/s]
    bool steady = true;    ///< the base does not change: noise is what differs from it, else from a flow without noise
    Prediction prediction; ///< of the linear flow, and the limit
    std::optional<double> unit; ///< fractions are of this step instead of the limit [s]
    bool modesGrow = false; ///< a term by itself grows with steps below its limit: a flow of all terms may do anything
    double stretching = 0;  ///< how fast disturbances of the base can grow at most [1/s]
    double time = 0;        ///< at the start [s]
    std::vector<double> fractions; ///< of the limit
};

/// Growth of a step (logarithm) by the projection alone, in a bounded box with faces at rest.
/// \param settings with convection none; to outlive the call
double growthOfProjection(const Lattice& lattice, const FlowSettings& settings, FlowBoundary& atRest);

/// One row of a report.
struct TrialRow
{
    std::string term;
    double fraction = 0;
    Outcome outcome = {};
    std::optional<double> predicted = std::nullopt; ///< growth of a step
    Verdict expected = Verdict::either;
    Verdict observed = Verdict::either;
    bool agrees = false;
};

/// A trial at each of its fractions.
struct TrialResult
{
    std::vector<TrialRow> rows;
    std::string note; ///< what a reader should know of them; mostly empty
};

/// Trials whose modes are expected to grow take as many steps more as that needs to show among all the others.
///
/// Where the flow is not steady, its own growth is taken off: what half the limit shows, which must not be more than
/// stretching can do. Growth that is large hides what a scheme adds to it; then anything may be seen.
/// \param begins told each fraction before it is tried, for progress
TrialResult runFractions(
    StabilityTrial& trial, int steps, Timings& timings, const std::function<void(double)>& begins = [](double) {});

} // namespace isph
