#include "case/TimeDirectories.hpp"

#include "case/timeName.hpp"
#include "case/TimeState.hpp"
#include "core/Error.hpp"
#include "core/writeTextFile.hpp"
#include "support/TemporaryFolder.hpp"

#include <gmock/gmock.h>

using namespace isph;
using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

std::vector<std::string> namesOf(const std::vector<TimeDirectory>& times)
{
    std::vector<std::string> names;
    for (const TimeDirectory& time : times) { names.push_back(time.name); }
    return names;
}

std::vector<TimeDirectory> folders(const std::vector<std::string>& names)
{
    std::vector<TimeDirectory> times;
    for (const std::string& name : names) { times.push_back({*timeOfName(name), name}); }
    return times;
}

std::vector<std::string> selected(const std::vector<std::string>& arguments)
{
    const Application application{.name = "tool", .summary = "", .examples = "", .options = timeOptions};
    const auto times = folders({"0", "0.1", "0.333333", "0.5", "1", "1.5"});
    return namesOf(selectTimes(times, CommandLine(application, arguments)));
}

std::string refusal(const std::vector<std::string>& arguments)
{
    try
    {
        selected(arguments);
    }
    catch (const Error& error)
    {
        return error.what();
    }
    return "";
}

} // namespace

TEST(TimeDirectories, namesThatAreNumbers)
{
    EXPECT_EQ(timeOfName("0.25"), 0.25);
    EXPECT_EQ(timeOfName("1e-05"), 1e-5);
    EXPECT_EQ(timeOfName("1e+05"), 1e5);
    EXPECT_EQ(timeOfName("-2"), -2.0);
    for (const char* name :
         {"", "0.orig", "constant", "nan", "inf", "-inf", "0x10", "1e", ".", "-", "1 ", ".0.25.tmp-4711"})
    {
        EXPECT_EQ(timeOfName(name), std::nullopt) << name;
    }
}

TEST(TimeDirectories, sortedByValue)
{
    const TemporaryFolder folder;
    for (const char* name : {"10", "9", "1e-05", "0", "-1", "0.5", "constant", "system", ".0.25.tmp-12", "0.orig"})
    {
        folder.makeFolder(name);
    }
    folder.write("7", "a file, not a folder");
    EXPECT_THAT(namesOf(timeDirectories(folder.path())), ElementsAre("-1", "0", "1e-05", "0.5", "9", "10"));
    EXPECT_THROW(timeDirectories(folder / "missing"), Error);
}

TEST(TimeDirectories, findsWhatANameStandsFor)
{
    const auto times = folders({"0", "0.333333", "0.5"});
    EXPECT_EQ(findTime(times, 1.0 / 3)->name, "0.333333");
    EXPECT_EQ(findTime(times, 0.333333)->name, "0.333333");
    EXPECT_EQ(findTime(times, 0)->name, "0");
    EXPECT_EQ(findTime(times, 0.34), std::nullopt);
    EXPECT_EQ(findTime(times, 1e-9), std::nullopt);
    EXPECT_EQ(findTime({}, 0), std::nullopt);
}

TEST(TimeDirectories, selection)
{
    EXPECT_THAT(selected({}), ElementsAre("0", "0.1", "0.333333", "0.5", "1", "1.5"));
    EXPECT_THAT(selected({"-noZero"}), ElementsAre("0.1", "0.333333", "0.5", "1", "1.5"));
    EXPECT_THAT(selected({"-latestTime"}), ElementsAre("1.5"));
    EXPECT_THAT(selected({"-time", "0.1,0.5:1"}), ElementsAre("0.1", "0.5", "1"));
    EXPECT_THAT(selected({"-time", "0.1 1"}), ElementsAre("0.1", "1"));
    EXPECT_THAT(selected({"-time", ":0.5", "-noZero"}), ElementsAre("0.1", "0.333333", "0.5"));
    EXPECT_THAT(selected({"-time", "0.5:"}), ElementsAre("0.5", "1", "1.5"));
    EXPECT_THAT(selected({"-time", "0.33333333333:0.4"}), ElementsAre("0.333333"));
    EXPECT_THAT(selected({"-time", "0.1", "-latestTime"}), ElementsAre("0.1", "1.5"));
    EXPECT_THAT(selected({"-time", "1.5", "-latestTime"}), ElementsAre("1.5"));
    EXPECT_THAT(selected({"-time", "2:"}), ElementsAre());
    EXPECT_THAT(selected({"-time", "-1:0"}), ElementsAre("0"));
}

TEST(TimeDirectories, refusals)
{
    EXPECT_EQ(refusal({"-time", "7"}), "there is no time folder 7\n    the case has 0, 0.1, 0.333333, 0.5, 1, 1.5");
    EXPECT_EQ(refusal({"-time", "0", "-noZero"}),
              "there is no time folder 0\n    the case has 0.1, 0.333333, 0.5, 1, 1.5");
    EXPECT_THAT(refusal({"-time", "now"}), HasSubstr("'now' is not a number"));
    EXPECT_THAT(refusal({"-time", "1:0"}), HasSubstr("ends before it begins"));
    EXPECT_THAT(refusal({"-time", ", "}), HasSubstr("-time is empty"));
}

TEST(TimeDirectories, nothingSelectedIsAnErrorForThoseWhoWorkOnTimes)
{
    const TemporaryFolder folder;
    folder.makeFolder("0");
    const Application application{.name = "tool", .summary = "", .examples = "", .options = timeOptions};
    EXPECT_THROW(selectedTimes(CommandLine(application, {"-case", folder.path().string(), "-noZero"})), Error);
    EXPECT_EQ(selectedTimes(CommandLine(application, {"-case", folder.path().string()})).size(), 1U);
}

TEST(timeName, formats)
{
    EXPECT_EQ(timeName(0.25, 0.01), "0.25");
    EXPECT_EQ(timeName(0.1 + 0.2, 0.1), "0.3");
    EXPECT_EQ(timeName(1e-5, 1e-5), "1e-05");
    EXPECT_EQ(timeName(1600, 1), "1600");
    EXPECT_EQ(timeName(0.25, 0.01, TimeFormat::fixed, 4), "0.2500");
    EXPECT_EQ(timeName(0.25, 0.01, TimeFormat::scientific, 2), "2.50e-01");
    EXPECT_EQ(timeName(5.55e-17, 0.1), "0") << "what is left of -0.3 + 3 * 0.1";
    EXPECT_EQ(timeName(-0.0, 0), "0");
}

TEST(timeName, moreDigitsWhereTwoWouldBeAlike)
{
    EXPECT_EQ(timeName(1000.001, 0.001), "1000.001");
    EXPECT_EQ(timeName(1000.001, 0.001, TimeFormat::fixed, 1), "1000.001");
    EXPECT_EQ(timeName(1.0 / 3, 1e-3, TimeFormat::general, 2), "0.3333");
    EXPECT_EQ(timeName(1.0 / 3, 0, TimeFormat::general, 2), "0.33");

    // Every step of a run has its own name, and the name finds the step.
    double previous = -1;
    for (int step = 1; step <= 3000; ++step)
    {
        const double time = 999.9 + step * 1.7e-4;
        const double named = *timeOfName(timeName(time, 1.7e-4));
        EXPECT_LE(std::abs(named - time), 1.7e-5);
        EXPECT_GT(named, previous);
        previous = named;
    }
}

TEST(timeName, aFolderOfAnotherTimeIsNotTaken)
{
    const TemporaryFolder folder;
    TimeState older;
    older.time = 0.3333331;
    older.deltaT = 0.01;
    writeTextFile(folder / "0.333333/uniform/time", timeStateText(older, "0.333333"));

    const auto name = [&](double time, double step)
    { return unusedTimeName(folder.path(), time, step, TimeFormat::general, 6); };
    EXPECT_EQ(name(0.3333331, 1e-4), "0.333333") << "the same time: written anew";
    EXPECT_EQ(name(0.33333325, 1e-8), "0.33333325");
    EXPECT_EQ(name(0.3333334, 1e-6), "0.3333334");
    EXPECT_EQ(name(0.5, 1e-3), "0.5");
    folder.makeFolder("0.5");
    EXPECT_EQ(name(0.5, 1e-3), "0.5") << "a folder without uniform/time is what its name says";
}

TEST(TimeState, readsBackAsTheSameBits)
{
    const TemporaryFolder folder;
    TimeState state;
    state.time = 1.0 / 3;
    state.carry = -1.234567890123e-17;
    state.origin = 0.1;
    state.index = 1234567;
    state.deltaT = 1e-3 / 7;
    state.nominal = 1e-3 / 6.5;
    state.cpuTime = 12.25;
    state.wallTime = 13.125;
    writeTextFile(folder / "0.3333/uniform/time", timeStateText(state, "0.3333", "plan    \"abc\";"));
    // The name is off by more than a tenth of the step: a folder that was renamed.
    EXPECT_EQ(readTimeState(folder.path(), "0.3333"), std::nullopt);

    const std::string name = timeName(state.time, state.deltaT);
    writeTextFile(folder / (name + "/uniform/time"), timeStateText(state, name));
    EXPECT_EQ(readTimeState(folder.path(), name), state);
    EXPECT_EQ(readTimeState(folder.path(), "0"), std::nullopt);
    EXPECT_THAT(folder.textOf("0.3333/uniform/time"), HasSubstr("plan    \"abc\";\n"));
}

TEST(TimeState, aDamagedFileIsAnError)
{
    const TemporaryFolder folder;
    folder.write("0.5/uniform/time", "value 0.5;\nindex 3;\n");
    try
    {
        readTimeState(folder.path(), "0.5");
        FAIL();
    }
    catch (const Error& error)
    {
        EXPECT_THAT(error.what(), HasSubstr("0.5/uniform/time"));
        EXPECT_THAT(error.what(), HasSubstr("deltaT"));
    }
}
