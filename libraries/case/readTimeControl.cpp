#include "case/readTimeControl.hpp"

#include "case/TimeDirectories.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace isph
{

namespace
{

constexpr std::array<Selection<StartFrom>::Variant, 3> startTable{{
    {"startTime", "the time folder that startTime names", StartFrom::startTime},
    {"firstTime", "the earliest time folder", StartFrom::firstTime},
    {"latestTime", "the latest time folder", StartFrom::latestTime},
}};

constexpr std::array<Selection<StopAt>::Variant, 4> stopTable{{
    {"endTime", "run to endTime", StopAt::endTime},
    {"writeNow", "end after the present step and write", StopAt::writeNow},
    {"noWriteNow", "end after the present step without writing", StopAt::noWriteNow},
    {"nextWrite", "end when the fields are written next", StopAt::nextWrite},
}};

constexpr Selection<StartFrom> startWords("startFrom", startTable);
constexpr Selection<StopAt> stopWords("stopAt", stopTable);

/// A number, or nothing where the word `none` is written.
std::optional<double> numberUnless(const Dictionary& dictionary, std::string_view key, std::string_view none)
{
    if (dictionary.find(key)->tokens().front().text == none) { return std::nullopt; }
    return dictionary.number(key);
}

double writeIntervalOf(const Dictionary& dictionary, WriteControl control)
{
    const auto interval = numberUnless(dictionary, "writeInterval", "endTime");
    if (interval && control == WriteControl::timeStep && (*interval < 1 || *interval != std::trunc(*interval)))
    {
        throw dictionary.error("writeInterval", "counts steps and must be a whole number",
                               "write e.g. 100, or choose writeControl runTime; for seconds");
    }
    return interval.value_or(unlimited);
}

std::string namesOf(const std::vector<TimeDirectory>& times)
{
    std::string names;
    for (const TimeDirectory& time : times) { names.append(names.empty() ? "" : ", ").append(time.name); }
    return names;
}

} // namespace

Schema controlDictSchema()
{
    using enum Key::Type;
    const auto positive = [](std::string name, std::string unit, std::optional<std::string> fallback,
                             std::string meaning, std::vector<std::string> words = {})
    {
        Key key{.name = std::move(name), .type = number, .unit = std::move(unit), .fallback = std::move(fallback)};
        key.meaning = std::move(meaning);
        key.words = std::move(words);
        key.positive = true;
        return key;
    };

    std::vector<Key> keys{
        {.name = "application", .type = Key::Type::word, .fallback = "isphFoam", .meaning = "the solver, for scripts"},
        {.name = "startFrom",
         .type = Key::Type::word,
         .fallback = "latestTime",
         .meaning = "the folder to start from",
         .words = startWords.names()},
        {.name = "startTime", .type = number, .unit = "s", .fallback = "0", .meaning = "used by startFrom startTime"},
        {.name = "stopAt",
         .type = Key::Type::word,
         .fallback = "endTime",
         .meaning = "when to stop",
         .words = stopWords.names()},
        {.name = "endTime", .type = number, .unit = "s", .meaning = "time at the end, met exactly", .required = true},
        positive("deltaT", "s", "auto", "time step; auto: safetyFactor times the largest stable one", {"auto"}),
        {.name = "adjustTimeStep",
         .type = flag,
         .fallback = "no",
         .meaning = "change the step with the flow, within maxCo, maxViscousNumber and maxDeltaT"},
        positive("maxCo", "", "1", "largest Courant number where the step is adjusted (of auto steps if written)"),
        positive("maxDeltaT", "s", "none", "largest step where it is adjusted or auto", {"none"}),
        positive("maxViscousNumber", "", "none", "largest nu*deltaT/dx^2 where the step is adjusted or auto", {"none"}),
        positive("safetyFactor", "", "0.8", "part of the largest stable step that deltaT auto takes"),
        {.name = "writeControl",
         .type = Key::Type::word,
         .fallback = "timeStep",
         .meaning = "what writeInterval counts",
         .words = writeControls().names()},
        positive("writeInterval", "steps or s", "endTime", "between written times; endTime: the last only",
                 {"endTime"}),
        {.name = "purgeWrite",
         .type = integer,
         .fallback = "0",
         .meaning = "written times to keep; 0: all",
         .minimum = 0},
        {.name = "timeFormat",
         .type = Key::Type::word,
         .fallback = "general",
         .meaning = "how time folders are named",
         .words = timeFormats().names()},
        {.name = "timePrecision",
         .type = integer,
         .fallback = "6",
         .meaning = "digits of these names; more where two would be alike",
         .minimum = 1,
         .maximum = 17},
        {.name = "runTimeModifiable", .type = flag, .fallback = "no", .meaning = "re-read this file when it changes"},
        positive("steadyTolerance", "m/s2", "off", "end when the largest |dU/dt| falls below it", {"off"}),
        positive("divergedCo", "", "100", "Courant number over the stable one that counts as diverged"),
        {.name = "functions", .type = any, .meaning = "what is computed while running, a sub-dictionary each"},
    };
    // OpenFOAM's cases have these; fields are written as HDF5, exactly, whatever they say.
    for (const char* unused : {"writeFormat", "writePrecision", "writeCompression"})
    {
        keys.push_back({.name = unused, .type = any, .meaning = "accepted and not used: fields are written exactly"});
    }
    return Schema("controlDict", std::move(keys));
}

std::vector<Key> outputControlKeys()
{
    return {{.name = "writeControl",
             .type = Key::Type::word,
             .fallback = "timeStep",
             .meaning = "what writeInterval counts",
             .words = functionWriteControls().names()},
            {.name = "writeInterval",
             .type = Key::Type::number,
             .unit = "steps or s",
             .fallback = "1",
             .meaning = "between two executions",
             .positive = true}};
}

OutputControl readOutputControl(const Dictionary& function)
{
    const WriteControl control = functionWriteControls()[function.word("writeControl")];
    return {control, writeIntervalOf(function, control)};
}

TimeSettings readTimeSettings(const Dictionary& controlDict)
{
    TimeSettings settings;
    settings.startFrom = startWords[controlDict.word("startFrom")];
    settings.startTime = controlDict.number("startTime");
    settings.stopAt = stopWords[controlDict.word("stopAt")];
    settings.endTime = controlDict.number("endTime");
    settings.deltaT = numberUnless(controlDict, "deltaT", "auto");
    settings.adjustTimeStep = controlDict.flag("adjustTimeStep");
    if (const Entry* maxCo = controlDict.find("maxCo"); maxCo != nullptr && !maxCo->isDefault)
    {
        settings.maxCo = controlDict.number("maxCo");
    }
    settings.maxDeltaT = numberUnless(controlDict, "maxDeltaT", "none").value_or(unlimited);
    settings.maxViscousNumber = numberUnless(controlDict, "maxViscousNumber", "none").value_or(unlimited);
    settings.safetyFactor = controlDict.number("safetyFactor");
    settings.writeControl = writeControls()[controlDict.word("writeControl")];
    settings.writeInterval = writeIntervalOf(controlDict, settings.writeControl);
    settings.purgeWrite = controlDict.integer("purgeWrite");
    settings.timeFormat = timeFormats()[controlDict.word("timeFormat")];
    settings.timePrecision = controlDict.integer("timePrecision");
    settings.runTimeModifiable = controlDict.flag("runTimeModifiable");
    settings.steadyTolerance = numberUnless(controlDict, "steadyTolerance", "off");
    settings.divergedCo = controlDict.number("divergedCo");
    return settings;
}

StartFolder findStart(const Case& flowCase, const TimeSettings& settings)
{
    const std::vector<TimeDirectory> times = timeDirectories(flowCase.directory());
    if (times.empty())
    {
        throw Error(Fault::input, "the case has no time folder to start from",
                    "write the initial fields into 0/, e.g. 0/U and 0/p");
    }

    TimeDirectory folder = settings.startFrom == StartFrom::firstTime ? times.front() : times.back();
    if (settings.startFrom == StartFrom::startTime)
    {
        const auto found = findTime(times, settings.startTime);
        if (!found)
        {
            throw Error(Fault::input, {"system/controlDict", 0, "startTime"},
                        fmt::format("there is no time folder for {}", settings.startTime),
                        fmt::format("the case has {}", namesOf(times)));
        }
        folder = *found;
    }

    const auto written = readTimeState(flowCase.directory(), folder.name);
    TimeState fresh;
    fresh.time = fresh.origin = folder.value;
    return {folder, written.value_or(fresh), written.has_value()};
}

TimeControl readTimeControl(const Case& flowCase)
{
    const Dictionary controlDict = controlDictSchema().complete(flowCase.dictionary("system/controlDict"));
    const TimeSettings settings = readTimeSettings(controlDict);
    const StartFolder start = findStart(flowCase, settings);
    if (settings.endTime < start.state.time - 1e-9 * start.state.deltaT)
    {
        throw controlDict.error("endTime",
                                fmt::format("is {} but the run starts from {}", settings.endTime, start.folder.name),
                                "set endTime beyond the start, or choose an earlier one with startFrom");
    }
    return {settings, start.state};
}

std::string timeNameOf(const Case& flowCase, const TimeControl& control)
{
    const TimeSettings& settings = control.settings();
    return unusedTimeName(flowCase.directory(), control.time(), control.lastStep(), settings.timeFormat,
                          settings.timePrecision);
}

ControlDictWatch::ControlDictWatch(const Case& flowCase) : case_(&flowCase)
{
    std::error_code ignored;
    read_ = std::filesystem::last_write_time(flowCase.path("system/controlDict"), ignored);
}

void ControlDictWatch::refresh(TimeControl& control, Log& log)
{
    if (!control.settings().runTimeModifiable) { return; }
    std::error_code ignored;
    const auto changed = std::filesystem::last_write_time(case_->path("system/controlDict"), ignored);
    if (ignored || changed == read_) { return; }
    read_ = changed;
    try
    {
        control.change(readTimeSettings(controlDictSchema().complete(case_->dictionary("system/controlDict"))));
        log.line("system/controlDict has changed and was read again");
    }
    catch (const Error& error)
    {
        log.warning(fmt::format("system/controlDict has changed but cannot be used, the run goes on as before\n{}",
                                error.what()));
    }
}

} // namespace isph
