#include "Job.hpp"

#include "case/AtomicFolder.hpp"
#include "core/Error.hpp"
#include "prepareRun.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>

namespace isph
{

namespace fs = std::filesystem;

namespace
{

constexpr double patience = 10;   // for what a killed sweep left running [s]
constexpr double lastWarning = 5; // between asking a program to stop and making it [s]
constexpr const char* cloneStep = "cloneCase";

/// A lock that the run's programs hold as well: as long as one of them lives, nobody else writes there. The file says
/// which process group they are; one that outlived a killed sweep is ended.
FileDescriptor lockOf(const fs::path& folder)
{
    makeFolder(folder.parent_path());
    FileDescriptor lock(folder.parent_path() / fmt::format(".{}.lock", folder.filename().string()), O_RDWR | O_CREAT);
    for (double waited = 0; flock(lock.number(), LOCK_EX | LOCK_NB) != 0; waited += 0.05)
    {
        if (errno != EWOULDBLOCK && errno != EINTR) { break; } // a file system without locks
        // No other sweep of this case is running, so whoever holds the lock was started by one that was killed.
        pid_t group = 0;
        if (waited == 0 && (std::ifstream(lock.file()) >> group) && group > 1) { kill(-group, SIGKILL); }
        if (waited > patience)
        {
            throw Error(Fault::input, {folder.string(), 0, ""},
                        "is still being written by a program that an earlier sweep started", "wait for it or stop it");
        }
        usleep(50000);
    }
    return lock;
}

/// Why a program failed: what it said behind its own name, else its last words.
std::string lastWords(const fs::path& log, const std::string& program)
{
    std::ifstream file(log);
    std::string last;
    std::string named;
    for (std::string line; std::getline(file, line);)
    {
        if (line.starts_with(program + ": ") && named.empty() && line.find(": warning: ") == std::string::npos)
        {
            named = line;
        }
        if (line.find_first_not_of(" \t") != std::string::npos && line != "End") { last = line; }
    }
    return named.empty() ? last : named;
}

/// The time that a solver without a report had reached, as its log has it: "0.25"; empty if it has none.
std::string lastTime(const fs::path& log)
{
    std::ifstream file(log);
    std::string last;
    for (std::string line; std::getline(file, line);)
    {
        if (line.starts_with("Time = ")) { last = line.substr(7, line.find(' ', 7) - 7); }
    }
    return last;
}

std::string nameOf(const std::string& step) { return fs::path(wordsOf(step).front()).filename().string(); }

} // namespace

Job::Job(const Sweep& sweep, const Run& run, const fs::path& caseDirectory, int repetition, std::string settings)
    : sweep_(sweep),
      run_(run),
      caseDirectory_(caseDirectory),
      folder_(caseDirectory / run.folder),
      repetition_(repetition),
      lock_(lockOf(folder_))
{
    if (repetition > 0)
    {
        record_ = readRecord(folder_).value_or(RunRecord{});
        folder_ += ".repetition";
    }
    record_.settings = std::move(settings);
    steps_ = sweep.commands;
    steps_.insert(steps_.begin(), cloneStep);
    if (repetition == 0) { steps_.insert(steps_.end(), sweep.after.begin(), sweep.after.end()); }
    startNext();
}

Job::~Job() = default;

bool Job::isSolver(std::size_t step) const { return step == sweep_.commands.size(); }

double Job::seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

void Job::startNext()
{
    ChildProcess::Command command;
    command.environment = {{"PATH", searchPath()}, {"OMP_NUM_THREADS", std::to_string(sweep_.threads)}};
    command.inherited = lock_.number();
    if (step_ == 0)
    {
        const fs::path clone = findProgram(cloneStep);
        const fs::path log = folder_.parent_path() / fmt::format("log.{}.cloneCase", folder_.filename().string());
        std::error_code ignored;
        fs::remove(log, ignored);
        command.words = {clone.string(), fs::absolute(sweep_.baseCase).string(), fs::absolute(folder_).string(),
                         "-overwrite"};
        command.folder = caseDirectory_;
        command.log = log;
    }
    else
    {
        if (step_ == 1) { applySettings(run_, folder_); }
        command.words = wordsOf(steps_[step_]);
        const std::string name = command.words[0];
        if (name.find('/') == std::string::npos) { command.words[0] = findProgram(name).string(); }
        command.words.insert(command.words.end(), {"-case", "."});
        command.folder = folder_;
        command.log = folder_ / fmt::format("log.{}", nameOf(steps_[step_]));
    }
    child_ = std::make_unique<ChildProcess>(command);
    const std::string group = fmt::format("{:<12}", child_->group());
    if (pwrite(lock_.number(), group.data(), group.size(), 0) < 0) { return; } // only a help for whoever comes next
}

bool Job::ended()
{
    if (ended_) { return true; }
    if (!child_->ended())
    {
        const double now = child_->wallTime();
        if (isSolver(step_) && now > sweep_.timeLimit)
        {
            // Asked once to write its state and end, then made to.
            if (!overdue_) { child_->signal(SIGTERM); }
            else if (now > sweep_.timeLimit + lastWarning) { child_->signal(SIGKILL); }
            overdue_ = true;
        }
        return false;
    }
    judge();
    return ended_;
}

void Job::judge()
{
    const int code = child_->exitCode();
    if (isSolver(step_))
    {
        const JsonValues report = reportLeft(folder_);
        record_.cpuTimes.push_back(report.number("cpuTime").value_or(child_->cpuTime()));
        record_.wallTimes.push_back(report.number("wallTime").value_or(child_->wallTime()));
        record_.peakMemory =
            static_cast<long>(report.number("peakMemory").value_or(static_cast<double>(child_->peakMemory())));
        if (overdue_)
        {
            record_.timeLimit = sweep_.timeLimit;
            finish(RunStatus::timeLimit, fmt::format("exceeded {:g} s", sweep_.timeLimit));
            return;
        }
        if (code == 3)
        {
            const auto reached = report.number("time");
            const std::string time = reached ? fmt::format("{:.6g}", *reached)
                                             : lastTime(folder_ / fmt::format("log.{}", nameOf(steps_[step_])));
            finish(RunStatus::diverged, time.empty() ? "diverged" : fmt::format("diverged at t = {}", time));
            return;
        }
    }
    if (code != 0)
    {
        const fs::path log = step_ == 0
                                 ? folder_.parent_path() / fmt::format("log.{}.cloneCase", folder_.filename().string())
                                 : folder_ / fmt::format("log.{}", nameOf(steps_[step_]));
        const std::string words = lastWords(log, nameOf(steps_[step_]));
        finish(RunStatus::failed,
               fmt::format("{} (exit code {})", words.empty() ? nameOf(steps_[step_]) : words, code));
        return;
    }
    if (++step_ < steps_.size()) { startNext(); }
    else { finish(RunStatus::done); }
}

void Job::finish(RunStatus status, std::string message)
{
    child_.reset();
    ended_ = true;
    record_.status = status;
    record_.message = std::move(message);
    const fs::path runFolder = caseDirectory_ / run_.folder;
    if (repetition_ == 0) { record_.jobTime = seconds(); }
    // A repetition that fails takes nothing from the run that did not; it will be tried again.
    if (repetition_ > 0 && status != RunStatus::done) { record_ = readRecord(runFolder).value_or(RunRecord{}); }
    else if (fs::is_directory(runFolder)) { writeRecord(runFolder, record_); }
    std::error_code ignored;
    if (repetition_ > 0) { fs::remove_all(folder_, ignored); }
    if (status != RunStatus::failed)
    {
        fs::remove(folder_.parent_path() / fmt::format("log.{}.cloneCase", folder_.filename().string()), ignored);
    }
}

void Job::signal(int number) const
{
    if (child_) { child_->signal(number); }
}

} // namespace isph
