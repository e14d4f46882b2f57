#include "case/readTimeControl.hpp"

#include "core/Error.hpp"
#include "core/writeTextFile.hpp"
#include "support/TemporaryFolder.hpp"

#include <gmock/gmock.h>

using namespace isph;
using testing::HasSubstr;

namespace
{

Dictionary completed(const std::string& text)
{
    return controlDictSchema().complete(Dictionary::parse(text, "system/controlDict"));
}

TimeSettings settingsOf(const std::string& text) { return readTimeSettings(completed(text)); }

std::string refusal(const auto& work)
{
    try
    {
        work();
    }
    catch (const Error& error)
    {
        EXPECT_EQ(error.fault(), Fault::input);
        return error.what();
    }
    return "";
}

std::string refusalOf(const std::string& text)
{
    return refusal([&] { settingsOf(text); });
}

/// A case with a controlDict and time folders.
struct TimeCase
{
    explicit TimeCase(const std::string& controlDict, const std::vector<std::string>& times = {"0"})
    {
        folder.write("system/controlDict", controlDict);
        for (const std::string& time : times) { folder.makeFolder(time); }
    }
    Case open() const { return Case(folder.path()); }

    TemporaryFolder folder;
};

} // namespace

TEST(readTimeControl, defaults)
{
    const TimeSettings settings = settingsOf("endTime 2;");
    EXPECT_EQ(settings.endTime, 2.0);
    EXPECT_EQ(settings.startFrom, StartFrom::latestTime);
    EXPECT_EQ(settings.stopAt, StopAt::endTime);
    EXPECT_EQ(settings.deltaT, std::nullopt);
    EXPECT_FALSE(settings.adjustTimeStep);
    EXPECT_EQ(settings.maxCo, std::nullopt);
    EXPECT_EQ(settings.maxDeltaT, unlimited);
    EXPECT_EQ(settings.maxViscousNumber, unlimited);
    EXPECT_EQ(settings.safetyFactor, 0.8);
    EXPECT_EQ(settings.writeControl, WriteControl::timeStep);
    EXPECT_EQ(settings.writeInterval, unlimited);
    EXPECT_EQ(settings.purgeWrite, 0);
    EXPECT_EQ(settings.timeFormat, TimeFormat::general);
    EXPECT_EQ(settings.timePrecision, 6);
    EXPECT_FALSE(settings.runTimeModifiable);
    EXPECT_EQ(settings.steadyTolerance, std::nullopt);
    EXPECT_EQ(settings.divergedCo, 100.0);
}

TEST(readTimeControl, everyEntry)
{
    const TimeSettings settings = settingsOf(R"(
        application isphFoam; startFrom startTime; startTime 0.5; stopAt nextWrite; endTime 2; deltaT 1e-3;
        adjustTimeStep yes; maxCo 0.4; maxDeltaT 0.1; maxViscousNumber 0.25; safetyFactor 0.5;
        writeControl adjustableRunTime; writeInterval 0.25; purgeWrite 3; timeFormat fixed; timePrecision 3;
        runTimeModifiable true; steadyTolerance 1e-8; divergedCo 50; writeFormat ascii; writePrecision 12;
        writeCompression off; functions { errors { type errorNorms; anything 1; } })");
    EXPECT_EQ(settings.startFrom, StartFrom::startTime);
    EXPECT_EQ(settings.startTime, 0.5);
    EXPECT_EQ(settings.stopAt, StopAt::nextWrite);
    EXPECT_EQ(settings.deltaT, 1e-3);
    EXPECT_TRUE(settings.adjustTimeStep);
    EXPECT_EQ(settings.maxCo, 0.4);
    EXPECT_EQ(settings.maxDeltaT, 0.1);
    EXPECT_EQ(settings.maxViscousNumber, 0.25);
    EXPECT_EQ(settings.safetyFactor, 0.5);
    EXPECT_EQ(settings.writeControl, WriteControl::adjustableRunTime);
    EXPECT_EQ(settings.writeInterval, 0.25);
    EXPECT_EQ(settings.purgeWrite, 3);
    EXPECT_EQ(settings.timeFormat, TimeFormat::fixed);
    EXPECT_EQ(settings.timePrecision, 3);
    EXPECT_TRUE(settings.runTimeModifiable);
    EXPECT_EQ(settings.steadyTolerance, 1e-8);
    EXPECT_EQ(settings.divergedCo, 50.0);
}

TEST(readTimeControl, refusals)
{
    EXPECT_THAT(refusalOf("deltaT 1;"), HasSubstr("endTime"));
    EXPECT_THAT(refusalOf("endTime 1;\nwriteIntervall 3;"), HasSubstr("system/controlDict:2: writeIntervall"));
    EXPECT_THAT(refusalOf("endTime 1;\nwriteIntervall 3;"), HasSubstr("writeInterval"));
    EXPECT_THAT(refusalOf("endTime 1;\ndeltaT -0.1;"), HasSubstr("system/controlDict:2: deltaT"));
    EXPECT_THAT(refusalOf("endTime 1; deltaT 0;"), HasSubstr("deltaT"));
    EXPECT_THAT(refusalOf("endTime 1; deltaT automatic;"), HasSubstr("auto"));
    EXPECT_THAT(refusalOf("endTime 1; writeControl runtime;"), HasSubstr("runTime"));
    EXPECT_THAT(refusalOf("endTime 1; writeControl onEnd;"), HasSubstr("onEnd"));
    EXPECT_THAT(refusalOf("endTime 1;\nwriteInterval 0.5;"),
                HasSubstr("system/controlDict:2: writeInterval: counts steps and must be a whole number"));
    EXPECT_THAT(refusalOf("endTime 1; writeControl runTime; writeInterval 0;"), HasSubstr("writeInterval"));
    EXPECT_THAT(refusalOf("endTime 1; timePrecision 0;"), HasSubstr("timePrecision"));
    EXPECT_THAT(refusalOf("endTime 1; purgeWrite -1;"), HasSubstr("purgeWrite"));
    EXPECT_THAT(refusalOf("endTime 1; stopAt now;"), HasSubstr("writeNow"));
}

TEST(readTimeControl, startFolders)
{
    const std::vector<std::string> times{"0", "0.25", "0.333333", "1"};
    const auto startOf = [&](const std::string& entries)
    {
        const TimeCase made("endTime 2; " + entries, times);
        return readTimeControl(made.open()).time();
    };
    EXPECT_EQ(startOf(""), 1.0);
    EXPECT_EQ(startOf("startFrom firstTime;"), 0.0);
    EXPECT_EQ(startOf("startFrom startTime;"), 0.0);
    EXPECT_EQ(startOf("startFrom startTime; startTime 0.25;"), 0.25);
    EXPECT_EQ(startOf("startFrom startTime; startTime 0.3333333333;"), 0.333333);
    EXPECT_THAT(refusal([&] { startOf("startFrom startTime; startTime 0.3;"); }),
                HasSubstr("there is no time folder for 0.3\n    the case has 0, 0.25, 0.333333, 1"));

    const TimeCase empty("endTime 1;", {});
    EXPECT_THAT(refusal([&] { readTimeControl(empty.open()); }), HasSubstr("no time folder to start from"));
}

TEST(readTimeControl, theEndLiesBehindTheStart)
{
    const TimeCase made("startFrom latestTime;\nendTime 0.5;", {"0", "1"});
    EXPECT_EQ(refusal([&] { readTimeControl(made.open()); }),
              "system/controlDict:2: endTime: is 0.5 but the run starts from 1\n"
              "    set endTime beyond the start, or choose an earlier one with startFrom");

    const TimeCase finished("endTime 1;", {"0", "1"});
    EXPECT_FALSE(readTimeControl(finished.open()).running());
}

TEST(readTimeControl, restartsTakeTheExactTime)
{
    const TimeCase made("endTime 1;", {"0"});
    TimeState state;
    state.time = 1.0 / 3;
    state.carry = 1e-18;
    state.deltaT = 1e-3;
    state.index = 333;
    writeTextFile(made.folder / "0.3333/uniform/time", timeStateText(state, "0.3333"));

    const Case flowCase = made.open();
    const StartFolder start = findStart(flowCase, settingsOf("endTime 1;"));
    EXPECT_TRUE(start.restart);
    EXPECT_EQ(start.folder.name, "0.3333");
    EXPECT_EQ(start.state, state);
    EXPECT_EQ(readTimeControl(flowCase).index(), 333);

    // A folder that was copied to start a new run from is not a restart.
    std::filesystem::remove_all(made.folder / "0");
    std::filesystem::rename(made.folder / "0.3333", made.folder / "0");
    const StartFolder fresh = findStart(flowCase, settingsOf("endTime 1;"));
    EXPECT_FALSE(fresh.restart);
    EXPECT_EQ(fresh.state, TimeState{});
}

TEST(readTimeControl, controlDictIsReadAgainWhenItChanges)
{
    const TimeCase made("endTime 1; deltaT 0.1; runTimeModifiable yes;");
    const Case flowCase = made.open();
    TimeControl control = readTimeControl(flowCase);
    ControlDictWatch watch(flowCase);
    Log log(Log::Report::none);
    auto date = std::filesystem::last_write_time(made.folder / "system/controlDict");
    const auto rewrite = [&](const std::string& text)
    {
        made.folder.write("system/controlDict", text);
        std::filesystem::last_write_time(made.folder / "system/controlDict", date += std::chrono::seconds(1));
        watch.refresh(control, log);
    };
    rewrite("endTime 0.5; deltaT 0.25; runTimeModifiable yes;");
    EXPECT_EQ(control.settings().endTime, 0.5);
    EXPECT_EQ(control.timeStep({}), 0.25);

    testing::internal::CaptureStderr();
    rewrite("endTime nonsense; runTimeModifiable yes;");
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("cannot be used, the run goes on as before"));
    EXPECT_EQ(control.settings().endTime, 0.5);

    rewrite("endTime 0.5; deltaT 0.25; runTimeModifiable no;");
    rewrite("endTime 7; deltaT 0.25; runTimeModifiable yes;");
    EXPECT_EQ(control.settings().endTime, 0.5) << "it no longer asks to be read again";
}

TEST(readOutputControl, ofFunctions)
{
    const Schema schema("function", outputControlKeys());
    const auto read = [&](const std::string& text)
    { return readOutputControl(schema.complete(Dictionary::parse(text, "system/controlDict"))); };

    StepEvent event;
    event.start = true;
    OutputControl everyStep = read("");
    EXPECT_TRUE(everyStep.due(event));
    event.start = false;
    event.index = 1;
    event.time = event.dt = 0.1;
    EXPECT_TRUE(everyStep.due(event));
    EXPECT_EQ(everyStep.nextTime(), unlimited);

    OutputControl timed = read("writeControl adjustableRunTime; writeInterval 0.25;");
    event.start = true;
    EXPECT_TRUE(timed.due(event));
    EXPECT_EQ(timed.nextTime(), 0.25);
    EXPECT_THAT(refusal([&] { read("writeControl sometimes;"); }), HasSubstr("writeControl"));
    EXPECT_THAT(refusal([&] { read("writeInterval 0.5;"); }), HasSubstr("whole number"));
}

TEST(OutputControl, everyControl)
{
    const auto dueAt = [](WriteControl control, double interval, const std::vector<StepEvent>& events)
    {
        OutputControl output(control, interval);
        std::vector<bool> due;
        for (const StepEvent& event : events) { due.push_back(output.due(event)); }
        return due;
    };
    std::vector<StepEvent> events(5);
    events[0].start = true;
    for (std::size_t i = 1; i < events.size(); ++i)
    {
        events[i].index = static_cast<long>(i);
        events[i].dt = 0.1;
        events[i].time = 0.1 * static_cast<double>(i);
        events[i].cpuTime = 2.0 * static_cast<double>(i);
        events[i].clockTime = 3.0 * static_cast<double>(i);
        events[i].writes = i == 3;
        events[i].end = i == 4;
    }
    using B = std::vector<bool>;
    EXPECT_EQ(dueAt(WriteControl::timeStep, 2, events), (B{true, false, true, false, true}));
    EXPECT_EQ(dueAt(WriteControl::runTime, 0.2, events), (B{true, false, true, false, true}));
    EXPECT_EQ(dueAt(WriteControl::runTime, 0.05, events), (B{true, true, true, true, true}));
    EXPECT_EQ(dueAt(WriteControl::adjustableRunTime, 0.3, events), (B{true, false, false, true, false}));
    EXPECT_EQ(dueAt(WriteControl::cpuTime, 5, events), (B{true, false, false, true, false}));
    EXPECT_EQ(dueAt(WriteControl::clockTime, 5, events), (B{true, false, true, false, true}));
    EXPECT_EQ(dueAt(WriteControl::writeTime, 1, events), (B{true, false, false, true, false}));
    EXPECT_EQ(dueAt(WriteControl::onEnd, 1, events), (B{false, false, false, false, true}));
    EXPECT_EQ(dueAt(WriteControl::timeStep, unlimited, events), (B{true, false, false, false, false}));
}

TEST(Case, directories)
{
    const TemporaryFolder folder;
    EXPECT_THAT(refusal([&] { Case(folder / "missing"); }), HasSubstr("there is no such case directory"));
    EXPECT_THAT(refusal([&] { Case(folder.path()); }), HasSubstr("neither system/ nor constant/"));

    folder.write("cavity/system/controlDict", "endTime 1;");
    const Case cavity(folder / "cavity");
    EXPECT_EQ(cavity.name(), "cavity");
    EXPECT_EQ(cavity.dictionary("system/controlDict").number("endTime"), 1.0);
    EXPECT_EQ(refusal([&] { cavity.dictionary("constant/lattice"); }),
              "constant/lattice: is missing\n    makeLattice writes it from system/latticeDict");
    EXPECT_EQ(refusal([&] { cavity.dictionary("system/schemes"); }),
              "system/schemes: is missing\n    write it; etc/annotated/schemes shows every entry");
}
