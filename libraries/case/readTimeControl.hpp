#pragma once

#include "case/Case.hpp"
#include "case/TimeControl.hpp"
#include "case/TimeDirectories.hpp"
#include "core/Log.hpp"
#include "dictionary/Schema.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace isph
{

/// The keys of system/controlDict.
Schema controlDictSchema();

/// writeControl and writeInterval as every function has them (default: every step), for the schemas of functions.
std::vector<Key> outputControlKeys();

/// Reads those two entries of a function.
/// \throws Error(input) at the entry.
OutputControl readOutputControl(const Dictionary& function);

/// Reads a controlDict that its schema has completed.
/// \throws Error(input) at the entry that is impossible.
TimeSettings readTimeSettings(const Dictionary& controlDict);

/// The folder that a run starts from.
struct StartFolder
{
    TimeDirectory folder;
    TimeState state; ///< from uniform/time, or a fresh one
    bool restart;    ///< whether the solver wrote the folder: uniform/time is there and fits
};

/// \throws Error(input) if there is no such folder.
StartFolder findStart(const Case& flowCase, const TimeSettings& settings);

/// Reads system/controlDict and the start folder.
/// \throws Error(input) also if endTime lies before the start.
TimeControl readTimeControl(const Case& flowCase);

/// Name of the folder for the present time: with more digits than asked for where another time has that name already.
std::string timeNameOf(const Case& flowCase, const TimeControl& control);

/// Re-reads system/controlDict when it changes during a run (runTimeModifiable). A controlDict that cannot be used is
/// warned of, and the run goes on with the one before.
class ControlDictWatch
{
public:
    explicit ControlDictWatch(const Case& flowCase);

    /// To be called after every advance(); costs a look at the file's date.
    void refresh(TimeControl& control, Log& log);

private:
    const Case* case_;
    std::filesystem::file_time_type read_;
};

} // namespace isph
