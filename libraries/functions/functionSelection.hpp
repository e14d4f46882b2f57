#pragma once

#include "case/Case.hpp"
#include "core/Log.hpp"
#include "core/Selection.hpp"
#include "dictionary/Schema.hpp"
#include "functions/FunctionObject.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace isph
{

/// What functions are made from, besides their dictionaries. Everything must outlive them.
struct FunctionSurroundings
{
    const Case& theCase;
    const Lattice& lattice;
    const Fluid& fluid;
    std::string startTime;    ///< name of the time the run starts from: the folder they write under
    double pressureScale;     ///< what kinematic pressure is multiplied by for output: 1, or rho where 0/p is in Pa
    std::string pressureUnit; ///< "m2/s2" or "Pa"
    bool pressureFixed;       ///< somewhere on the boundary: then errors of p are taken as they are, else without means

    /// -postProcess: a table that a run wrote is kept, the new one goes beside it as <name>_postProcess.csv.
    bool besideRun = false;
};

/// Keys that functions of every type have: type, enabled, timeStart, timeEnd, writeControl, writeInterval.
std::vector<Key> functionKeys();

/// One line for each type: what -listFunctions prints.
std::vector<ListedWord> functionTypes();

/// The functions of a controlDict with their output controls.
class Functions
{
public:
    Functions() = default;

    /// \param functions sub-dictionary `functions` of controlDict
    /// \throws Error(input) with every slip in it.
    Functions(const Dictionary& functions, const FunctionSurroundings& surroundings);

    /// Runs those that are due at this event.
    void execute(const StepEvent& event, const FlowAtTime& now);

    /// Runs them, whatever their output control says (-postProcess): all but those that gather over a run, of which the
    /// times that were written hold too little.
    void executeAll(const FlowAtTime& now);

    /// Earliest time a step has to end at for one of them (adjustableRunTime); infinity if there is none.
    double nextTime() const;

    bool empty() const { return functions_.empty(); }

    /// Last norms of every errorNorms, for report.json.
    using Norm = ErrorNorm;
    std::vector<Norm> errors() const;

private:
    struct Function
    {
        std::string name;
        OutputControl control;
        std::optional<OutputControl> sampling; ///< executeControl, of functions that gather over time
        double timeStart;                      ///< [s], of the window the function runs in
        double timeEnd;                        ///< [s]
        std::unique_ptr<FunctionObject> object;

        double nextTime() const;
    };
    void add(const Entry& entry, const FunctionSurroundings& surroundings);

    std::vector<Function> functions_;
};

} // namespace isph
