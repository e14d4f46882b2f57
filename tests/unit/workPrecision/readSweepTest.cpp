#include "readSweep.hpp"
#include "RunRecord.hpp"
#include "support/messageOf.hpp"
#include "support/TemporaryFolder.hpp"
#include "workPrecisionSchema.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <regex>

namespace isph
{

using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

Sweep sweepOf(const std::string& text, bool reduced = false)
{
    const TemporaryFolder folder;
    folder.write("box/system/workPrecisionDict", text);
    return readSweep(Case(folder / "box"), reduced);
}

std::string refusal(const std::string& text, bool reduced = false)
{
    return messageOf([&] { sweepOf(text, reduced); });
}

std::string setting(const Run& run, const char* file, const char* key)
{
    return run.settings.dictionary(file).findScoped(key)->tokens().front().text;
}

std::vector<std::string> foldersOf(const Sweep& sweep)
{
    std::vector<std::string> folders;
    for (const Run& run : sweep.runs) { folders.push_back(run.folder.string()); }
    return folders;
}

void expectMentioned(const std::vector<Key>& keys, const std::string& text)
{
    for (const Key& key : keys)
    {
        if (key.name != "*") { EXPECT_TRUE(std::regex_search(text, std::regex("\\b" + key.name + "\\b"))) << key.name; }
        for (const std::string& word : key.words)
        {
            EXPECT_TRUE(std::regex_search(text, std::regex("\\b" + word + "\\b"))) << key.name << ": " << word;
        }
        expectMentioned(key.keys, text);
    }
}

} // namespace

TEST(ReadSweep, ReadsTheDictionaryOnceForEachRun)
{
    const Sweep sweep = sweepOf(R"(
N 40;
parameters { N (20 40); }
set { "system/controlDict" { deltaT #eval{ 0.1/$N }; } "system/latticeDict" { count ($N $N 1); } }
variants { four { set { "system/schemes" { kernel { order 4; } } } } six { title "order 6"; } }
error { report errors.U.relL2; })");
    EXPECT_THAT(foldersOf(sweep), ElementsAre("workPrecision/four/N20", "workPrecision/six/N20",
                                              "workPrecision/four/N40", "workPrecision/six/N40"));
    EXPECT_EQ(setting(sweep.runs[0], "system/controlDict", "deltaT"), "0.005");
    EXPECT_EQ(setting(sweep.runs[2], "system/controlDict", "deltaT"), "0.0025");
    EXPECT_EQ(setting(sweep.runs[0], "system/schemes", "kernel.order"), "4");
    EXPECT_FALSE(sweep.runs[1].settings.has("system/schemes"));
    EXPECT_EQ(sweep.lines[1].title, "order 6");
    EXPECT_EQ(sweep.runs[3].resolution, 40);
    EXPECT_THAT(sweep.commands, ElementsAre("makeLattice -overwrite", "isphFoam"));
    EXPECT_EQ(sweep.pictures.front().x, "cpuTime");
}

TEST(ReadSweep, PutsAParameterWithoutAnEntryInFront)
{
    const Sweep sweep = sweepOf("parameters { N (8 16); }\nset { \"system/a\" { b $N; } }\nerror { report steps; }");
    EXPECT_EQ(setting(sweep.runs[1], "system/a", "b"), "16");
}

TEST(ReadSweep, MultipliesLinesByTheOtherParameters)
{
    const Sweep sweep = sweepOf(R"(
parameters { order { values (4 6); entry system/schemes.kernel.order; } N (8 16); solver (fft CG); }
resolution N;
set { "system/latticeDict" { count ($N $N 1); } "system/solution" { p { solver $solver; } } }
error { report steps; })");
    ASSERT_EQ(sweep.runs.size(), 8U);
    EXPECT_EQ(sweep.lines[0].name, "order4-solverfft");
    EXPECT_EQ(sweep.lines[3].title, "order 6, solver CG");
    EXPECT_EQ(setting(sweep.runs[2], "system/schemes", "kernel.order"), "6");
}

TEST(ReadSweep, LetsAVariantHaveListsOfItsOwn)
{
    const Sweep sweep = sweepOf("parameters { N (8 16); }\nset { \"system/a\" { b $N; } }\n"
                                "variants { a { } b { parameters { N (8); } } }\nerror { report steps; }");
    EXPECT_THAT(foldersOf(sweep), ElementsAre("workPrecision/a/N8", "workPrecision/b/N8", "workPrecision/a/N16"));
}

TEST(ReadSweep, LaysReducedOverTheRest)
{
    const std::string text = "parameters { N (80 160); }\nset { \"system/a\" { b $N; } }\nrepetitions 3;\n"
                             "error { report steps; }\nreduced { parameters { N (8 16); } repetitions 1; }";
    const Sweep sweep = sweepOf(text, true);
    EXPECT_EQ(sweep.runs.back().resolution, 16);
    EXPECT_EQ(setting(sweep.runs[0], "system/a", "b"), "8");
    EXPECT_EQ(sweep.repetitions, 1);
    EXPECT_EQ(sweepOf(text).runs.back().resolution, 160);
}

TEST(ReadSweep, TakesSeveralErrorsAndPictures)
{
    const Sweep sweep = sweepOf(R"(
parameters { N (8 16); }
set { "system/a" { b $N; } }
error { velocity { report errors.U.relL2; } drag { function forces; column drag; } }
collect { solve { report seconds.poisson; per steps; } }
plot { cost { x N; y solve; logY no; } velocity { y velocity; } })");
    EXPECT_THAT(sweep.measures, ElementsAre("velocity", "drag"));
    EXPECT_THAT(sweep.collected, ElementsAre("solve"));
    ASSERT_EQ(sweep.pictures.size(), 2U);
    EXPECT_FALSE(sweep.pictures[0].logY);
    EXPECT_EQ(sweep.pictures[1].xLabel, "processor time [s]");
    EXPECT_EQ(sweep.runs[0].quantities[2].per, "steps");
}

TEST(ReadSweep, NeedsNoErrorForAPictureOfCosts)
{
    const Sweep sweep = sweepOf("parameters { N { values (8 16); entry system/a.b; } }\nplot { x N; y cpuTime; }");
    EXPECT_TRUE(sweep.measures.empty());
    EXPECT_EQ(sweep.pictures.front().yLabel, "processor time [s]");
    EXPECT_THAT(refusal("parameters { N (8 16); }"), HasSubstr("error: is missing"));
}

TEST(ReadSweep, KnowsAListsSizeByItsLargestNumber)
{
    const Sweep sweep = sweepOf("parameters { count { values ((8 4 1) (1 16 1)); entry system/latticeDict.count; } }\n"
                                "error { report steps; }");
    EXPECT_EQ(sweep.runs[0].resolution, 8);
    EXPECT_EQ(sweep.runs[1].resolution, 16);
    EXPECT_EQ(sweep.runs[0].folder, "workPrecision/box/count_8_4_1");
    EXPECT_EQ(setting(sweep.runs[1], "system/latticeDict", "count"), "(");
}

TEST(ReadSweep, RefusesListsThatChangeNothing)
{
    const std::string tail = "\nerror { report steps; }\n";
    EXPECT_EQ(
        refusal("parameters\n{\n    N { values (8 16); entry system/a.b; }\n    order (4 6);\n}\nresolution N;" + tail),
        "system/workPrecisionDict:4: parameters.order: changes nothing in any run\n    say which entry it sets, "
        "order { values (...); entry FILE.ENTRY; }, or write $order in set");
    EXPECT_THAT(refusal("parameters { N (8 16); }\nset { \"system/a\" { b $N; } }\n"
                        "variants { a { set { \"system/a\" { b 1; } } } }" +
                        tail),
                "no error"); // it is used, if in vain
}

TEST(ReadSweep, TakesResultsFromElsewhere)
{
    const auto read = [](const std::string& external)
    {
        const TemporaryFolder folder;
        folder.write("box/validation/a.csv", "cpuTime [s],error,other\n1,0.1,3\n2,0.01,4\n");
        folder.write("box/b.csv", "\xef\xbb\xbf\"cpuTime [s]\",\"error\"\r\n1,\"0.5\"\r\n");
        folder.write("box/c.csv", "cpuTime,error\n1,small\n");
        folder.write("box/system/workPrecisionDict", "parameters { N { values (8 16); entry system/a.b; } }\n"
                                                     "error { report steps; }\nexternal { a { " +
                                                         external + " } }\n");
        return readSweep(Case(folder / "box"), false).externals.front();
    };
    const External plain = read("file validation/a.csv;");
    EXPECT_EQ(plain.title, "a");
    EXPECT_THAT(plain.columns.at("cpuTime"), ElementsAre(1, 2));
    EXPECT_THAT(plain.columns.at("error"), ElementsAre(0.1, 0.01));
    EXPECT_FALSE(plain.columns.contains("other"));
    EXPECT_THAT(read("file b.csv;").columns.at("error"), ElementsAre(0.5)); // as spreadsheets write it
    EXPECT_THAT(messageOf([&] { read("file c.csv;"); }), HasSubstr("external.a.file: c.csv has no number for error"));
    EXPECT_THAT(read("file validation/a.csv; columns { cpuTime cpuTime; error other; }").columns.at("error"),
                ElementsAre(3, 4));
    EXPECT_THAT(messageOf([&] { read("file validation/a.csv; columns { steps other; }"); }),
                HasSubstr("external.a.columns: gives no picture both its columns, e.g. cpuTime and error"));
    EXPECT_THAT(messageOf([&] { read("file d.csv;"); }), HasSubstr("external.a.file: there is no d.csv"));
}

TEST(ReadSweep, RefusesWithLineAndAdvice)
{
    const std::string tail = "\nerror { report steps; }\n";
    EXPECT_EQ(refusal("error { report steps; }"),
              "system/workPrecisionDict: parameters: is missing\n    write parameters { N (20 40 80); }");
    EXPECT_THAT(refusal("parameters\n{\n    N ();\n}" + tail),
                HasSubstr("system/workPrecisionDict:3: parameters.N: is an empty list"));
    EXPECT_THAT(refusal("parameters { N 20; }" + tail), HasSubstr("parameters.N: is 20 but must be a list of values"));
    EXPECT_THAT(refusal("parameters { N (20 20); }" + tail), HasSubstr("has 20 twice"));
    EXPECT_THAT(refusal("parameters { N (fft); }" + tail), HasSubstr("the resolution must be positive numbers"));
    EXPECT_THAT(refusal("parameters { N (20); }\nresolution n;" + tail),
                HasSubstr("system/workPrecisionDict:2: resolution: 'n' is not a known parameter\n    known are: N"));
    EXPECT_THAT(refusal("parameters { N (20); M (1 2); }" + tail), HasSubstr("there are several parameters"));
    EXPECT_THAT(refusal("parameters { N (20); }\nvariants { a { } b { }\n a { } }" + tail),
                HasSubstr("system/workPrecisionDict:3: variants.a: is there twice"));
    EXPECT_THAT(refusal("parameters { N (20); }\nvariant { a { } }" + tail),
                HasSubstr(":2: variant: is not a known entry\n    did you mean 'variants'?"));
    EXPECT_THAT(refusal("parameters { N (20); }\nerror { reprot steps; }"), HasSubstr("did you mean 'report'?"));
    EXPECT_THAT(refusal("parameters { N (20); }\nerror { }"), HasSubstr("does not say where the number comes from"));
    EXPECT_THAT(refusal("parameters { N (20); }\nerror { report a; command b; }"),
                HasSubstr("has both report and command"));
    EXPECT_THAT(refusal("parameters { N (20); }\nerror { steps { report steps; } }"),
                HasSubstr("the table has a column steps already"));
    EXPECT_THAT(refusal("parameters { steps (20); }\nset { \"system/a\" { b $steps; } }" + tail),
                HasSubstr("parameters.steps: the table has a column steps already"));
    EXPECT_THAT(refusal("parameters { error (20); }" + tail),
                HasSubstr(":1: parameters.error: is the name of an entry of this dictionary"));
    EXPECT_THAT(foldersOf(sweepOf("parameters { N (20); }\nvariants { \"..\" { } \".\" { } }" + tail)),
                ElementsAre("workPrecision/_../N20", "workPrecision/_./N20"));
    EXPECT_THAT(refusal("parameters { N (20); }\nplot { y eror; }" + tail),
                HasSubstr("'eror' is no column of the table\n    known are: error, "));
    EXPECT_THAT(refusal("parameters { N (20); }\nexternal { other { file \"none.csv\"; columns { } } }" + tail),
                HasSubstr("there is no none.csv"));
    EXPECT_THAT(refusal("parameters { N (20); }" + tail, true), HasSubstr("reduced: is missing"));
    EXPECT_THAT(refusal("parameters { N (20); }\nset { \"system/a\" { b $M; } }" + tail), HasSubstr(":2: uses $M"));
    EXPECT_THAT(refusal("parameters { N { values (20); entry count; } }" + tail), HasSubstr("is no FILE.ENTRY"));
    EXPECT_THAT(refusal("parameters { N (20); }\nvariants { a { parameters { M (1); } } }" + tail),
                HasSubstr("M: is not a parameter of the sweep"));
    EXPECT_THAT(refusal("parameters { N (20); }\nerror { line a; column U.x; reference \"a.csv\"; }"),
                HasSubstr("reference: is 'a.csv' but must be \"FILE:COLUMN:COLUMN\""));
    EXPECT_THAT(refusal("parameters { N (20); }\nerror { largestOf (b); }\ncollect { a { report steps; } }"),
                HasSubstr("'b' is not a known quantity\n    known are: a"));
}

TEST(AnnotatedWorkPrecisionDict, HasEveryKeyAndCanBeRead)
{
    const std::filesystem::path file = std::filesystem::path(ANNOTATED) / "workPrecisionDict";
    const TemporaryFolder folder;
    folder.makeFolder("box/system");
    std::filesystem::copy_file(file, folder / "box/system/workPrecisionDict");
    const std::string text = folder.textOf("box/system/workPrecisionDict");
    expectMentioned(workPrecisionSchema().keys(), text);
    expectMentioned(quantitySchema().keys(), text);
    expectMentioned(pictureSchema().keys(), text);
    EXPECT_EQ(readSweep(Case(folder / "box"), false).runs.size(), 12U);
    EXPECT_EQ(readSweep(Case(folder / "box"), true).lines.front().fit.to, 20);
}

TEST(RunRecordFile, ReadsBackWhatWasWritten)
{
    const TemporaryFolder folder;
    EXPECT_FALSE(readRecord(folder.path()));
    writeRecord(folder.path(), {.status = RunStatus::diverged,
                                .settings = "abc",
                                .cpuTimes = {0.1, 0.07},
                                .wallTimes = {0.2, 0.3},
                                .peakMemory = 12345678,
                                .timeLimit = 0,
                                .jobTime = 1.5,
                                .message = "said \"no\"\nand left"});
    const auto record = readRecord(folder.path());
    ASSERT_TRUE(record);
    EXPECT_EQ(record->status, RunStatus::diverged);
    EXPECT_EQ(record->cpuTime(), 0.07);
    EXPECT_EQ(record->wallTime(), 0.2);
    EXPECT_EQ(record->peakMemory, 12345678);
    EXPECT_EQ(record->message, "said 'no' and left");
}

TEST(RunRecordFile, IsNoneIfItIsBroken)
{
    const TemporaryFolder folder;
    folder.write("workPrecision.record", "status done; settings");
    EXPECT_FALSE(readRecord(folder.path()));
}

TEST(Hash, TellsTextsApart)
{
    EXPECT_EQ(hashOf(""), "cbf29ce484222325"); // the offset basis of FNV-1a
    EXPECT_EQ(hashOf("a"), "af63dc4c8601ec8c");
    EXPECT_NE(hashOf("ab"), hashOf("ba"));
}

} // namespace isph
