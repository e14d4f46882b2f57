#pragma once

#include "ChildProcess.hpp"
#include "core/FileDescriptor.hpp"
#include "RunRecord.hpp"
#include "Sweep.hpp"

#include <memory>

namespace isph
{

/// One run being made: its clone, its commands one after the other, its record.
class Job
{
public:
    /// \param caseDirectory of the sweep
    /// \param repetition counted from 0; later ones are made beside the run's folder, for their times only
    /// \throws Error(input) if the clone cannot be made, or is still being written by a process of an earlier sweep.
    Job(const Sweep& sweep, const Run& run, const std::filesystem::path& caseDirectory, int repetition,
        std::string settings);
    ~Job();
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

    /// Goes on with the next command when one has ended. Whether all is done and recorded.
    bool ended();

    /// Sends a signal to what is running.
    void signal(int number) const;

    /// Whether the program that was running has ended, whatever would come next.
    bool stopped() const { return !child_ || child_->ended(); }

    const Run& run() const { return run_; }
    int repetition() const { return repetition_; }
    const RunRecord& record() const { return record_; } ///< once it has ended
    double seconds() const;                             ///< since it began

private:
    void startNext();
    void judge();
    void finish(RunStatus status, std::string message = "");
    bool isSolver(std::size_t step) const;

    const Sweep& sweep_;
    const Run& run_;
    std::filesystem::path caseDirectory_;
    std::filesystem::path folder_;
    int repetition_;
    FileDescriptor lock_; ///< held by the programs too, until the last of them has ended
    std::vector<std::string> steps_;
    std::size_t step_ = 0;
    std::unique_ptr<ChildProcess> child_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    bool overdue_ = false;
    bool ended_ = false;
    RunRecord record_;
};

} // namespace isph
