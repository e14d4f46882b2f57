#pragma once

#include "case/OutputControl.hpp"
#include "core/Timings.hpp"
#include "flow/Fluid.hpp"
#include "flow/IncompressibleFlow.hpp"
#include "lattice/Lattice.hpp"

#include <string>
#include <vector>

namespace isph
{

/// A flow at the end of a step (or at the start of a run), as functions see it.
struct FlowAtTime
{
    IncompressibleFlow& flow;
    double time;            ///< [s]
    std::string name;       ///< of the time, e.g. "0.25"
    long step;              ///< index of the step
    double cpuTime;         ///< [s], of all runs so far
    double wallTime;        ///< [s]
    const Timings& timings; ///< of this run
    double dt = 0;          ///< length of the step that led here [s]; 0 at the start
};

/// A norm of an error, for report.json (errors.U.relL2).
struct ErrorNorm
{
    std::string field; ///< "U"
    std::string norm;  ///< "relL2"
    double value;
};

/// Something that watches a run: error norms, statistics, probes, samples. Asks for no more than it needs: what no
/// function asks for is never computed.
/// \tparam Now what it sees at the end of a step
template<class Now>
class FunctionOn
{
public:
    virtual ~FunctionOn() = default;

    /// Computes and writes. Called only when its output control says so.
    virtual void execute(const Now& now) = 0;

    /// Takes a sample, for functions that gather over time (their executeControl says when); before execute().
    virtual void accumulate(const Now&) {}

    /// The norms of the last execution, for functions that compute errors.
    virtual std::vector<ErrorNorm> errors() const { return {}; }
};

/// A function on a flow.
using FunctionObject = FunctionOn<FlowAtTime>;

} // namespace isph
