#pragma once

#include "case/Case.hpp"
#include "core/Log.hpp"
#include "core/Selection.hpp"
#include "dictionary/Schema.hpp"
#include "functions/FunctionObject.hpp"
#include "functions/ScheduledFunctions.hpp"

#include <functional>
#include <string>
#include <vector>

namespace isph
{

class FlowBoundary;

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

    const FlowBoundary* boundary = nullptr; ///< of the flow, where there is one, at the time it has come to

    /// -postProcess: a table that a run wrote is kept, the new one goes beside it as <name>_postProcess.csv.
    bool besideRun = false;
};

/// Keys that functions of every type have: type, enabled, timeStart, timeEnd, writeControl, writeInterval.
std::vector<Key> functionKeys();

/// One line for each type: what -listFunctions prints.
std::vector<ListedWord> functionTypes();

/// The functions of a controlDict with their output controls.
class Functions : public ScheduledFunctions<FlowAtTime>
{
public:
    Functions() = default;

    /// \param functions sub-dictionary `functions` of controlDict
    /// \throws Error(input) with every slip in it.
    Functions(const Dictionary& functions, const FunctionSurroundings& surroundings);

    using Norm = ErrorNorm;
};

/// What programs read of a sub-dictionary `functions`, whatever it is that their functions see: calls visit(name,
/// dictionary) for every function that is enabled.
/// \param types that its programs know
/// \throws Error(input) with every slip of the functions, those that visit throws included.
void forEachFunction(const Dictionary& functions, const std::vector<std::string>& types,
                     const std::function<void(const std::string&, const Dictionary&)>& visit);

/// The dictionary of a function, completed by the keys of its type and those of every function; the type may give a key
/// of the latter another default.
Dictionary completedFunction(const Dictionary& function, std::vector<Key> keysOfType);

/// When a function runs.
/// \param function completed
FunctionSchedule readFunctionSchedule(const Dictionary& function);

} // namespace isph
