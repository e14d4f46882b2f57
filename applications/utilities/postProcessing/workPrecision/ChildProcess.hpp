#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <sys/types.h>
#include <utility>
#include <vector>

namespace isph
{

/// A program that is running. It ends when this process does, however that ends; its processor time is known.
class ChildProcess
{
public:
    struct Command
    {
        std::vector<std::string> words; ///< path of the program, its arguments
        std::filesystem::path folder;   ///< that it works in
        std::filesystem::path log;      ///< for standard output and standard error, behind what is there
        std::vector<std::pair<std::string, std::string>> environment; ///< besides that of this process
        int inherited = -1; ///< a file that stays open in the program and those it starts (a lock); -1: none
    };

    /// \throws Error(input) if it cannot be started.
    explicit ChildProcess(const Command& command);

    /// Kills it, and what it started, if it is running.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Whether it has ended; does not wait.
    bool ended();

    /// Waits until it has ended.
    /// \throws StoppedBySignal if this process is asked to stop meanwhile
    void wait();

    /// Sends a signal to it and to what it started.
    void signal(int number) const;

    pid_t group() const { return pid_; }            ///< process group of it and what it started
    int exitCode() const { return exitCode_; }      ///< 128 + the signal that ended it
    double cpuTime() const { return cpuTime_; }     ///< of it and what it started [s]
    double wallTime() const;                        ///< so far [s]
    long peakMemory() const { return peakMemory_; } ///< of the largest process [bytes]

private:
    using Clock = std::chrono::steady_clock;

    pid_t pid_ = -1;
    bool ended_ = false;
    int exitCode_ = 0;
    double cpuTime_ = 0;
    double wallTime_ = 0;
    long peakMemory_ = 0;
    Clock::time_point start_ = Clock::now();
};

/// What a command of the shell prints to standard output; the suite's programs are on its PATH.
/// \throws Error(input) if it fails, with what it said; StoppedBySignal as ChildProcess::wait
std::string outputOf(const std::string& command, const std::filesystem::path& folder);

/// The folder of the programs: where this one is.
std::filesystem::path programFolder();

/// The path of a program: beside this one, else on the PATH; empty if there is none.
std::filesystem::path findProgram(const std::string& name);

/// PATH with the folder of the programs in front.
std::string searchPath();

} // namespace isph
