#pragma once

#include "case/OutputControl.hpp"
#include "core/Timings.hpp"
#include "flow/Fluid.hpp"
#include "flow/IncompressibleFlow.hpp"
#include "lattice/Lattice.hpp"

#include <string>

namespace isph
{

/// A flow at the end of a step (or at the start of a run), as functions see it.
struct FlowAtTime
{
    IncompressibleFlow& flow;
    double time;            ///< [s]
    const std::string& name; ///< of the time, e.g. "0.25"
    long step;              ///< index of the step
    double cpuTime;         ///< [s], of all runs so far
    double wallTime;        ///< [s]
    const Timings& timings; ///< of this run
};

/// Something that watches a run: error norms, statistics, probes, samples. Asks the flow for no more than it needs: what no
/// function asks for is never computed.
class FunctionObject
{
public:
    virtual ~FunctionObject() = default;

    /// Computes and writes. Called only when its output control says so.
    virtual void execute(const FlowAtTime& now) = 0;
};

} // namespace isph
