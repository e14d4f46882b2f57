#pragma once

#include "core/Selection.hpp"

#include <limits>

namespace isph
{

/// What decides when something is written.
enum class WriteControl
{
    timeStep,          ///< every so many steps
    runTime,           ///< at the step nearest to each multiple of the interval
    adjustableRunTime, ///< exactly at each multiple: steps are fitted to it
    cpuTime,           ///< every so many seconds of CPU time
    clockTime,         ///< every so many seconds of real time
    writeTime,         ///< whenever the fields are written (functions only)
    onEnd,             ///< when the run ends (functions only)
};

/// The words of writeControl: of the run, and of functions.
const Selection<WriteControl>& writeControls();
const Selection<WriteControl>& functionWriteControls();

/// A step that was taken, or the start of a run: what an output control decides by.
struct StepEvent
{
    double time = 0;      ///< [s], after the step
    double origin = 0;    ///< [s], time that intervals count from: the start of the first run, also after restarts
    double dt = 0;        ///< [s], of the step
    long index = 0;       ///< steps since the origin
    double cpuTime = 0;   ///< [s], of this process
    double clockTime = 0; ///< [s], since this run started
    bool start = false;   ///< no step was taken yet
    bool writes = false;  ///< the fields are written now
    bool end = false;     ///< this is the last step
};

/// Decides whether something is due, with OpenFOAM's arithmetic.
class OutputControl
{
public:
    /// \param interval steps (timeStep, a whole number >= 1) or seconds (> 0); infinity: never
    OutputControl(WriteControl control, double interval) : control_(control), interval_(interval) {}

    /// Whether output is due at this event; to be asked once an event, first with the start of the run. At the start
    /// everything but onEnd is due.
    bool due(const StepEvent& event);

    /// Time [s] that a step has to end at: the next multiple of an adjustableRunTime; infinity for the others.
    double nextTime() const;

private:
    long indexAt(const StepEvent& event) const;

    WriteControl control_;
    double interval_;
    double origin_ = 0;
    long lastIndex_ = 0; ///< intervals that were counted so far
};

} // namespace isph
