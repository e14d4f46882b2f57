#pragma once

#include "case/OutputControl.hpp"
#include "case/timeName.hpp"
#include "case/TimeState.hpp"

#include <chrono>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace isph
{

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

enum class StartFrom
{
    startTime,
    firstTime,
    latestTime
};
enum class StopAt
{
    endTime,
    writeNow,
    noWriteNow,
    nextWrite
};

/// The entries of controlDict (contract, section 4) as plain values.
struct TimeSettings
{
    StartFrom startFrom = StartFrom::latestTime;
    double startTime = 0; ///< [s]
    StopAt stopAt = StopAt::endTime;
    double endTime = 0;                  ///< [s]
    std::optional<double> deltaT;        ///< [s]; none: auto, the largest stable step times safetyFactor
    bool adjustTimeStep = false;         ///< keep to the limits below, starting from deltaT
    std::optional<double> maxCo;         ///< none: 1 where the step is adjusted, no limit where it is auto
    double maxDeltaT = unlimited;        ///< [s]
    double maxViscousNumber = unlimited; ///< largest nu dt/dx^2 (adjusted and auto steps)
    double safetyFactor = 0.8;
    WriteControl writeControl = WriteControl::timeStep;
    double writeInterval = unlimited; ///< steps or seconds
    int purgeWrite = 0;               ///< time folders of this run to keep; 0: all
    TimeFormat timeFormat = TimeFormat::general;
    int timePrecision = 6;
    bool runTimeModifiable = false;
    std::optional<double> steadyTolerance; ///< [m/s2]; none: run on
    double divergedCo = 100;               ///< a Courant number so many times the stable one counts as diverged
};

/// What limits the next step.
struct StepLimits
{
    double largestStable = unlimited; ///< [s], of the time scheme with all its explicit terms
    double convectiveRate = 0;        ///< Courant number per second of step [1/s]
    double viscousRate = 0;           ///< viscous number per second of step [1/s]; 0 where that term is not explicit
    double meetTime = unlimited;      ///< [s], a time that a step has to end at (OutputControl::nextTime of functions)
};

/// Why a run ended, as report.json says it.
enum class Ending
{
    endTime,
    stopAt,
    steady,
    signal,
    diverged
};
std::string_view toString(Ending ending);

/// The march in time: how long each step is, when fields are written, when the run ends.
///
///     while (control.running())
///     {
///         const double dt = control.timeStep(limits);
///         ... advance the flow by dt ...
///         control.advance();
///         watch.refresh(control, log);               // runTimeModifiable
///         control.noteAcceleration(largestChange);   // only for steadyTolerance
///         ... functions: if (output.due(control.event())) ...
///         if (control.writesNow()) { ... }
///     }
///
/// Times are summed with compensation, so that N fixed steps end at start + N deltaT to the last bit; the last step is
/// cut to end at endTime exactly. All that the march depends on is in state(): a run that goes on from there takes the
/// same steps in the same bits.
class TimeControl
{
public:
    /// \param start where the run starts: of a fresh run only its time (and origin) is set
    TimeControl(const TimeSettings& settings, const TimeState& start);

    const TimeSettings& settings() const { return settings_; }

    /// New settings from the next step on, as runTimeModifiable asks for.
    void change(const TimeSettings& settings);

    /// Whether there is a step to take.
    bool running();

    /// Length of the next step [s]. The same whenever it is asked again with the same limits.
    /// \throws Error(diverged) if the limits leave no step that would ever reach the end.
    double timeStep(const StepLimits& limits);

    /// The step of the last timeStep() was taken: moves time and index, decides on output and on the end.
    void advance();

    /// Ends the run: steady if steadyTolerance is set and the largest |dU/dt| [m/s2] is below it.
    void noteAcceleration(double largest);

    /// Ends the run after this step.
    void end(Ending ending);

    double time() const { return state_.time; }
    long index() const { return state_.index; }
    double lastStep() const { return state_.deltaT; } ///< [s]; 0 before the first
    double startTime() const { return startTime_; }   ///< of this run [s]

    /// Steps taken by this run.
    long steps() const { return state_.index - startIndex_; }

    /// The name of the present time, e.g. for the log ("Time = 0.25").
    std::string timeName() const;

    /// The present step, for the output controls of functions.
    StepEvent event() const;

    /// Whether the fields are to be written now: output is due, or the run ends (but for noWriteNow).
    bool writesNow() const;

    /// Why the run has ended; nothing while it goes on.
    std::optional<Ending> ending() const { return ending_; }

    /// What uniform/time is to hold now.
    TimeState state() const;

private:
    double nominalStep(const StepLimits& limits) const;
    double until(double time) const; ///< seconds left to a time, carry included
    double slack(double step) const; ///< what counts as round-off beside a step [s]
    bool atEnd() const;

    TimeSettings settings_;
    TimeState state_;
    OutputControl output_;
    double startTime_;
    long startIndex_;
    double nextStep_ = 0;
    double nextNominal_ = 0;
    std::optional<double> arrival_; ///< the time that the next step ends at exactly
    bool outputDue_ = false;
    std::optional<Ending> ending_;
    std::chrono::steady_clock::time_point startClock_ = std::chrono::steady_clock::now();
};

} // namespace isph
