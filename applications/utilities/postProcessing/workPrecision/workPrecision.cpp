// workPrecision: error against run time. Runs a case with every combination of lists of dictionary entries, collects
// errors and costs, fits slopes, and draws the picture.
//
//     workPrecision -case taylorGreen2D            system/workPrecisionDict; goes on where it was stopped
//     workPrecision -case taylorGreen2D -list      what would be run; checks everything, runs nothing
//     workPrecision -case taylorGreen2D -reduced   with the shorter lists of `reduced`
//     workPrecision -case taylorGreen2D -plot      tables and pictures of what has been run
//     workPrecision -case taylorGreen2D -clean     removes all of it

#include "case/Case.hpp"
#include "ChildProcess.hpp"
#include "core/FileDescriptor.hpp"
#include "core/nearestWord.hpp"
#include "core/runApplication.hpp"
#include "prepareRun.hpp"
#include "provenance.hpp"
#include "readSweep.hpp"
#include "Results.hpp"
#include "runSweep.hpp"
#include "writePictures.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

using namespace isph;
namespace fs = std::filesystem;

static constexpr const char* dictionaryName = "system/workPrecisionDict";

/// Every program that the sweep will need must be there before the first one is started.
static void checkPrograms(const Sweep& sweep)
{
    std::vector<std::string> commands = sweep.commands;
    commands.insert(commands.end(), sweep.after.begin(), sweep.after.end());
    for (const std::string& command : commands)
    {
        const std::string name = wordsOf(command).front();
        const bool script = name.find('/') != std::string::npos;
        if (script ? fs::exists(sweep.baseCase / name) : !findProgram(name).empty()) { continue; }
        std::vector<std::string> beside;
        for (const fs::directory_entry& entry : fs::directory_iterator(programFolder()))
        {
            beside.push_back(entry.path().filename().string());
        }
        const auto nearest = nearestWord(name, beside);
        throw Error(Fault::input, {dictionaryName, 0, "commands"}, fmt::format("there is no program '{}'", name),
                    nearest ? fmt::format("did you mean '{}'?", *nearest)
                            : "programs are looked for beside workPrecision and on the PATH");
    }
}

static void checkSweep(const Sweep& sweep)
{
    checkPrograms(sweep);
    for (const Run& run : sweep.runs) { checkRun(run, sweep); }
}

static void printPlan(const Sweep& sweep, const std::vector<RunRecord>& records, Log& log)
{
    const auto counted = [](std::size_t count, const char* what)
    { return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s"); };
    log.line(counted(sweep.runs.size(), "run") + ", " + counted(sweep.lines.size(), "line"));
    for (std::size_t i = 0; i < sweep.runs.size(); ++i)
    {
        const RunRecord& record = records[i];
        std::string state = std::string(runStatuses().nameOf(record.status));
        if (record.status == RunStatus::missing) { state = "to be run"; }
        log.line(fmt::format("    {:<48} {}", sweep.runs[i].folder.string(), state));
    }
    const double left = secondsLeft(sweep, records);
    if (left == 0) { log.line("nothing left to run"); }
    else if (left > 0) { log.line(fmt::format("about {} to run", durationText(left / sweep.jobs))); }
}

static void report(const Results& results, const std::string& command, const fs::path& caseDirectory, Log& log)
{
    const fs::path folder = caseDirectory / "postProcessing" / "workPrecision";
    writeTables(results, folder);
    if (!command.empty()) { writeProvenance(results.sweep(), command, folder / "provenance.json"); }
    log.line();
    log.line(runsText(results));
    log.line("Fitted to the logarithms");
    log.line(slopesText(results));
    if (const std::string text = cheapestText(results); !text.empty())
    {
        log.line("Cheapest for each error, between the runs along straight lines");
        log.line(text);
    }
    const Drawing drawing = writePictures(results, folder);
    log.line(fmt::format("Wrote {}: workPrecision.csv, slopes.csv, cheapest.csv", folder.string()));
    if (!drawing.gnuplot) { log.line("    no pictures: gnuplot is not installed (Debian package gnuplot-nox)"); }
    for (const std::string& name : drawing.drawn) { log.line(fmt::format("    {0}.svg, {0}.png", name)); }
    for (const std::string& name : drawing.empty) { log.line(fmt::format("    no {}.svg: nothing to draw", name)); }
}

static void clean(const Case& theCase, Log& log)
{
    bool removed = false;
    std::optional<FileDescriptor> lock;
    if (theCase.has("workPrecision")) { lock.emplace(lockSweep(theCase.path("workPrecision"))); }
    for (const char* name : {"workPrecision", "postProcessing/workPrecision"})
    {
        std::error_code error;
        if (!theCase.has(name)) { continue; }
        fs::remove_all(theCase.path(name), error);
        if (error) { throwRefused(theCase.path(name), "could not be removed", error.value()); }
        log.line(fmt::format("Removed {}", name));
        removed = true;
    }
    if (!removed) { log.line("nothing to remove"); }
}

static void run(const CommandLine& line, Log& log)
{
    const Case theCase(line.caseDirectory());
    if (line.has("clean"))
    {
        clean(theCase, log);
        return;
    }
    Sweep sweep = readSweep(theCase, line.has("reduced"));
    sweep.jobs = line.wholeNumber("jobs", 1, sweep.jobs);
    checkSweep(sweep);
    std::vector<RunRecord> records = knownRecords(sweep, theCase.directory());
    if (line.has("list"))
    {
        printPlan(sweep, records, log);
        return;
    }
    if (!line.has("plot")) { runSweep(sweep, theCase.directory(), records, log); }

    const auto isDone = [](const RunRecord& record) { return record.status == RunStatus::done; };
    report(Results(sweep, records, theCase.directory()), line.has("plot") ? "" : line.text(), theCase.directory(), log);
    if (std::ranges::none_of(records, isDone))
    {
        throw Error(Fault::input, {dictionaryName, 0, ""}, "no run gave a result",
                    line.has("plot") ? "run workPrecision without -plot first"
                                     : fmt::format("the first: {}", records.front().message));
    }
}

int main(int argc, char** argv)
{
    const Application application{
        .name = "workPrecision",
        .summary = "error against run time: runs a case with lists of dictionary entries (system/workPrecisionDict)",
        .examples = "workPrecision -case taylorGreen2D\nworkPrecision -case taylorGreen2D -list\n"
                    "workPrecision -case taylorGreen2D -reduced -jobs 2\nworkPrecision -case taylorGreen2D -plot",
        .options = {{"list", "", "check everything and print the runs, make none"},
                    {"reduced", "", "with the dictionary `reduced` laid over the rest"},
                    {"jobs", "N", "runs at the same time"},
                    {"plot", "", "only make tables and pictures of the runs there are"},
                    {"clean", "", "remove the runs and their results"}}};
    return runApplication(application, argc, argv, run);
}
