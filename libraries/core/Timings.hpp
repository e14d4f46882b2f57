#pragma once

#include <array>
#include <chrono>
#include <string_view>

namespace isph
{

/// Where the time of a run goes (keys of "seconds" in report.json). What no scope claims is "other".
enum class Phase
{
    setup,
    transforms,
    pointwise,
    boundary,
    continuation,
    poisson,
    functions,
    output
};

inline constexpr std::array<std::string_view, 8> phaseNames{"setup",        "transforms", "pointwise", "boundary",
                                                            "continuation", "poisson",    "functions", "output"};

/// Wall-clock seconds by phase. A scope nested in another takes its time out of the outer one, so that phases add up.
class Timings
{
public:
    using Clock = std::chrono::steady_clock;

    class Scope
    {
    public:
        Scope(Timings& timings, Phase phase) : timings_(timings), outer_(timings.switchTo(static_cast<int>(phase))) {}
        ~Scope() { timings_.switchTo(outer_); }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

    private:
        Timings& timings_;
        int outer_;
    };

    /// Claims the time until the scope ends for a phase.
    [[nodiscard]] Scope scope(Phase phase) { return Scope(*this, phase); }

    double seconds(Phase phase) const { return seconds_[static_cast<std::size_t>(phase)]; }

    /// Everything since construction, and the part of it that no phase claimed.
    double total() const;
    double other() const;

private:
    /// Books the time since the last switch on the current phase; returns that phase (-1: none).
    int switchTo(int phase);

    std::array<double, phaseNames.size()> seconds_{};
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    int current_ = -1;
};

/// CPU seconds of this process (all threads) and its largest resident memory in bytes so far.
double cpuSeconds();
long peakMemory();

} // namespace isph
