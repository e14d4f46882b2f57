#include "runSweep.hpp"

#include "case/AtomicFolder.hpp"
#include "core/Error.hpp"
#include "core/signals.hpp"
#include "fits.hpp"
#include "Job.hpp"
#include "prepareRun.hpp"
#include "quantities.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <deque>
#include <fcntl.h>
#include <fmt/format.h>
#include <limits>
#include <sys/file.h>
#include <unistd.h>

namespace isph
{

namespace fs = std::filesystem;

namespace
{

constexpr double refreshSeconds = 0.25;
constexpr double stopSeconds = 10; // that programs are given to write their state

struct Task
{
    std::size_t run;
    int repetition;
};

/// What is left to do: first every run once, then their repetitions in turn, so that a disturbance of the machine does
/// not hit all times of one run.
std::deque<Task> tasksOf(const Sweep& sweep, const std::vector<RunRecord>& records)
{
    std::deque<Task> tasks;
    for (int repetition = 0; repetition < sweep.repetitions; ++repetition)
    {
        for (std::size_t i = 0; i < sweep.runs.size(); ++i)
        {
            const RunRecord& record = records[i];
            const auto made = static_cast<int>(record.cpuTimes.size());
            const bool repeats = record.status == RunStatus::done || record.status == RunStatus::missing;
            if (made <= repetition && (repetition == 0 || repeats)) { tasks.push_back({i, repetition}); }
        }
    }
    return tasks;
}

std::string label(const Sweep& sweep, const Run& run)
{
    return fmt::format("{}, {} {}", sweep.lines[run.line].title, sweep.resolutionName(), run.values[sweep.resolution]);
}

/// A sweep that is running: its jobs, what they report, how they are stopped.
class Runner
{
public:
    Runner(const Sweep& sweep, const fs::path& caseDirectory, std::vector<RunRecord>& records, Log& log)
        : sweep_(sweep),
          caseDirectory_(caseDirectory),
          records_(records),
          log_(log),
          tasks_(tasksOf(sweep, records)),
          total_(tasks_.size()),
          baseFiles_(baseHash(sweep))
    {
        for (const Run& one : sweep.runs) { widest_ = std::max(widest_, label(sweep, one).size()); }
    }

    void run()
    {
        catchSignals();
        const auto there = std::ranges::count_if(records_, [](const RunRecord& record)
                                                 { return record.status != RunStatus::missing; });
        if (there > 0) { log_.line(fmt::format("{} of {} runs are there already", there, records_.size())); }
        double shown = -refreshSeconds;
        while (!tasks_.empty() || !jobs_.empty())
        {
            while (jobs_.size() < static_cast<std::size_t>(sweep_.jobs) && startNext()) {}
            usleep(2000);
            if (caughtSignal() != 0) { stop(); }
            collect();
            const double now = seconds();
            if (now - shown < refreshSeconds) { continue; }
            showProgress();
            shown = now;
        }
        log_.status("");
    }

private:
    struct Active
    {
        std::size_t run;
        std::unique_ptr<Job> job;
    };

    /// Takes the first task whose run is not being made: repetitions share a folder, and wait for what the run does.
    /// Whether there was one.
    bool startNext()
    {
        const auto idle = [this](const Task& task)
        { return std::ranges::none_of(jobs_, [&](const Active& active) { return active.run == task.run; }); };
        const auto next = std::ranges::find_if(tasks_, idle);
        if (next == tasks_.end()) { return false; }
        const Task task = *next;
        tasks_.erase(next);
        const Run& run = sweep_.runs[task.run];
        const RunStatus status = records_[task.run].status;
        if (task.repetition > 0 && status != RunStatus::done) // it diverged, say: no use in repeating that
        {
            ++finished_;
            return true;
        }
        if (task.repetition == 0) { removeLeftovers((caseDirectory_ / run.folder).parent_path()); }
        jobs_.push_back({task.run, std::make_unique<Job>(sweep_, run, caseDirectory_, task.repetition,
                                                         settingsHash(run, sweep_, baseFiles_))});
        return true;
    }

    void collect()
    {
        for (std::size_t i = 0; i < jobs_.size();)
        {
            if (!jobs_[i].job->ended())
            {
                ++i;
                continue;
            }
            const Active active{jobs_[i].run, std::move(jobs_[i].job)};
            jobs_.erase(jobs_.begin() + static_cast<std::ptrdiff_t>(i));
            records_[active.run] = active.job->record();
            ++finished_;
            report(active);
        }
    }

    void report(const Active& active)
    {
        const RunRecord& record = records_[active.run];
        const Run& run = sweep_.runs[active.run];
        std::string what;
        if (record.status != RunStatus::done) { what = record.message; }
        else
        {
            what = fmt::format("{:.3g} s", record.cpuTime());
            if (active.job->repetition() > 0) { what += fmt::format(" (repetition {})", active.job->repetition() + 1); }
            else
            {
                // Where the first run has no such number, none will have: that ends the sweep at once.
                const auto values = evaluateAll(run.quantities, caseDirectory_, caseDirectory_ / run.folder);
                for (std::size_t i = 0; i < sweep_.measures.size(); ++i)
                {
                    what += fmt::format("   {} {:.4g}", sweep_.measures[i], values[i]);
                }
            }
        }
        const double left = secondsLeft(sweep_, records_) / sweep_.jobs;
        const std::string more = tasks_.empty() && jobs_.empty() ? "" : fmt::format("   {} left", durationText(left));
        log_.line(fmt::format("[{:>{}}/{}] {:<{}} {}{}", finished_, std::to_string(total_).size(), total_,
                              label(sweep_, run), widest_, what, left < 0 ? "" : more));
    }

    void showProgress()
    {
        if (jobs_.empty()) { return; }
        double left = secondsLeft(sweep_, records_);
        for (const Active& active : jobs_) { left -= active.job->seconds(); }
        const std::string text = left < 0 ? "" : fmt::format("   {} left", durationText(left / sweep_.jobs));
        log_.status(
            fmt::format("{} of {} done, now {}{}", finished_, total_, label(sweep_, jobs_.back().job->run()), text));
    }

    /// Ends what is running and leaves; runs that have ended are on disk.
    [[noreturn]] void stop()
    {
        log_.status("");
        const int signal = caughtSignal();
        for (const Active& active : jobs_) { active.job->signal(SIGTERM); }
        const double asked = seconds();
        for (bool running = true; running && seconds() - asked < stopSeconds;)
        {
            running = false;
            for (const Active& active : jobs_) { running = !active.job->stopped() || running; }
            usleep(5000);
        }
        jobs_.clear(); // kills what is left
        log_.line(fmt::format("{} of {} runs are done; the same command goes on with the others", finished_, total_));
        throw StoppedBySignal{signal};
    }

    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

    const Sweep& sweep_;
    const fs::path& caseDirectory_;
    std::vector<RunRecord>& records_;
    Log& log_;
    std::deque<Task> tasks_;
    std::size_t total_;
    std::size_t finished_ = 0;
    std::size_t widest_ = 0; ///< label
    std::string baseFiles_;
    std::vector<Active> jobs_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace

FileDescriptor lockSweep(const fs::path& folder)
{
    makeFolder(folder);
    FileDescriptor lock(folder / ".lock", O_RDWR | O_CREAT);
    if (flock(lock.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    {
        throw Error(Fault::input, {folder.string(), 0, ""}, "another sweep of this case is running",
                    "wait for it or stop it");
    }
    return lock;
}

std::vector<RunRecord> knownRecords(const Sweep& sweep, const fs::path& caseDirectory)
{
    const std::string baseFiles = baseHash(sweep);
    std::vector<RunRecord> records;
    for (const Run& run : sweep.runs)
    {
        const std::optional<RunRecord> found = readRecord(caseDirectory / run.folder);
        const bool counts = found && found->settings == settingsHash(run, sweep, baseFiles) &&
                            found->status != RunStatus::failed && !found->cpuTimes.empty() &&
                            !(found->status == RunStatus::timeLimit && sweep.timeLimit > found->timeLimit);
        records.push_back(counts ? *found : RunRecord{});
    }
    return records;
}

void runSweep(const Sweep& sweep, const fs::path& caseDirectory, std::vector<RunRecord>& records, Log& log)
{
    const FileDescriptor lock = lockSweep(caseDirectory / "workPrecision");
    Runner(sweep, caseDirectory, records, log).run();
}

double secondsLeft(const Sweep& sweep, const std::vector<RunRecord>& records)
{
    struct Known
    {
        std::vector<double> resolution; ///< in the order they were made
        std::vector<double> seconds;

        /// The power between the last two: what a start costs matters less and less.
        std::optional<double> power() const
        {
            const std::size_t n = seconds.size();
            if (n < 2) { return std::nullopt; }
            const auto fit = fitSlope({resolution[n - 2], resolution[n - 1]}, {seconds[n - 2], seconds[n - 1]});
            return fit ? std::optional(fit->slope) : std::nullopt;
        }
    };
    std::vector<Known> lines(sweep.lines.size());
    for (std::size_t i = 0; i < sweep.runs.size(); ++i)
    {
        if (records[i].jobTime <= 0) { continue; }
        lines[sweep.runs[i].line].resolution.push_back(sweep.runs[i].resolution);
        lines[sweep.runs[i].line].seconds.push_back(records[i].jobTime);
    }
    double growth = 0;
    double fitted = 0;
    for (const Known& line : lines)
    {
        const std::optional<double> power = line.power();
        growth += power.value_or(0);
        fitted += power ? 1 : 0;
    }
    if (fitted == 0 && sweep.parameters[sweep.resolution].values.size() > 1) { return -1; }
    growth = fitted > 0 ? growth / fitted : 0;

    // ln seconds = ln a + growth ln resolution, for lines of which nothing is known
    double logFactor = 0;
    double known = 0;
    for (const Known& line : lines)
    {
        if (line.seconds.empty()) { continue; }
        logFactor += std::log(line.seconds.back()) - growth * std::log(line.resolution.back());
        known += 1;
    }
    if (known == 0) { return -1; }
    double left = 0;
    for (const Task& task : tasksOf(sweep, records))
    {
        const Run& run = sweep.runs[task.run];
        const Known& line = lines[run.line];
        if (records[task.run].jobTime > 0) { left += records[task.run].jobTime; }
        else if (line.seconds.empty()) { left += std::exp(logFactor / known + growth * std::log(run.resolution)); }
        else
        {
            const double power = line.power().value_or(growth);
            left += line.seconds.back() * std::pow(run.resolution / line.resolution.back(), power);
        }
    }
    return left;
}

std::string durationText(double seconds)
{
    const auto total = static_cast<long>(std::ceil(std::max(0.0, seconds)));
    if (total >= 3600) { return fmt::format("{}:{:02}:{:02}", total / 3600, total % 3600 / 60, total % 60); }
    return fmt::format("{}:{:02}", total / 60, total % 60);
}

} // namespace isph
