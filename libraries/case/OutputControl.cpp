#include "case/OutputControl.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace isph
{

namespace
{

constexpr std::array<Selection<WriteControl>::Variant, 7> table{{
    {"timeStep", "every writeInterval steps", WriteControl::timeStep},
    {"runTime", "at the step nearest to each multiple of writeInterval seconds", WriteControl::runTime},
    {"adjustableRunTime", "at each multiple of writeInterval seconds exactly: steps are fitted to it",
     WriteControl::adjustableRunTime},
    {"cpuTime", "every writeInterval seconds of CPU time", WriteControl::cpuTime},
    {"clockTime", "every writeInterval seconds of real time", WriteControl::clockTime},
    {"writeTime", "whenever the fields are written", WriteControl::writeTime},
    {"onEnd", "when the run ends", WriteControl::onEnd},
}};
static_assert(distinct(table));

} // namespace

const Selection<WriteControl>& writeControls()
{
    static constexpr Selection<WriteControl> selection("writeControl", std::span(table).first<5>());
    return selection;
}

const Selection<WriteControl>& functionWriteControls()
{
    static constexpr Selection<WriteControl> selection("writeControl", table);
    return selection;
}

long OutputControl::indexAt(const StepEvent& event) const
{
    const double elapsed = event.time - event.origin;
    switch (control_)
    {
    case WriteControl::timeStep:
        return static_cast<long>(static_cast<double>(event.index) / interval_);
    case WriteControl::runTime:
        return static_cast<long>((elapsed + 0.5 * event.dt) / interval_);
    case WriteControl::adjustableRunTime:
    {
        // The march ends a step at the multiple itself, up to the rounding of this division.
        auto index = static_cast<long>(elapsed / interval_);
        if (event.origin + static_cast<double>(index + 1) * interval_ <= event.time + 1e-9 * event.dt) { ++index; }
        return index;
    }
    case WriteControl::cpuTime:
        return static_cast<long>(event.cpuTime / interval_);
    case WriteControl::clockTime:
        return static_cast<long>(event.clockTime / interval_);
    case WriteControl::writeTime:
    case WriteControl::onEnd:
        break;
    }
    return 0;
}

bool OutputControl::due(const StepEvent& event)
{
    origin_ = event.origin;
    if (event.start)
    {
        lastIndex_ = indexAt(event);
        return control_ != WriteControl::onEnd || event.end;
    }
    if (control_ == WriteControl::writeTime) { return event.writes; }
    if (control_ == WriteControl::onEnd) { return event.end; }

    const long index = indexAt(event);
    if (index <= lastIndex_) { return false; }
    lastIndex_ = index;
    return true;
}

double OutputControl::nextTime() const
{
    if (control_ != WriteControl::adjustableRunTime) { return std::numeric_limits<double>::infinity(); }
    return origin_ + static_cast<double>(lastIndex_ + 1) * interval_;
}

} // namespace isph
