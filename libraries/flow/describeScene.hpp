#pragma once

#include "flow/FlowSettings.hpp"
#include "flow/Fluid.hpp"
#include "lattice/Lattice.hpp"

#include <string>
#include <utility>
#include <vector>

namespace isph
{

/// What a scene computes and what it leaves out, in words: for the log, checkCase and report.json.
struct SceneDescription
{
    std::vector<std::string> active;
    std::vector<std::string> leftOut;

    /// Every choice with its resolved value: "kernel" -> "gaussian, order 10, h/dx 1.5, closed".
    std::vector<std::pair<std::string, std::string>> schemes;

    int transformsPerSubstep;       ///< of one component
    bool transformsOfLines = false; ///< each is of the lines along one axis only, where an axis is bounded
};

SceneDescription describeScene(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings);

} // namespace isph
