#include "functions/functionSelection.hpp"
#include "Flows.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

using namespace test;

class FunctionsTest : public testing::Test
{
protected:
    FunctionsTest()
    {
        fluid.nu = 0.01;
        fluid.rho = 2;
    }

    /// The functions of a controlDict whose second line begins with the text.
    Functions functionsOf(const std::string& text)
    {
        const Dictionary controlDict =
            Dictionary::parse("functions\n{" + text + "}", "system/controlDict", folder.path / "system");
        return Functions(controlDict.dictionary("functions"), {.theCase = theCase,
                                                               .lattice = lattice,
                                                               .fluid = fluid,
                                                               .startTime = startTime,
                                                               .pressureScale = 1,
                                                               .pressureUnit = "m2/s2",
                                                               .pressureFixed = false});
    }

    std::string errorOf(const std::string& text)
    {
        try
        {
            functionsOf(text);
        }
        catch (const Error& error)
        {
            EXPECT_EQ(error.fault(), Fault::input);
            return error.what();
        }
        return "";
    }

    /// Runs what is due after step number `index` of 0.1 s.
    void runStep(Functions& functions, long index)
    {
        const double time = 0.1 * static_cast<double>(index);
        functions.execute({.time = time, .dt = index > 0 ? 0.1 : 0, .index = index, .start = index == 0},
                          at(flow, timings, time, std::to_string(index)));
    }

    std::vector<double> timesOf(const std::string& file) { return readCsv(output(file))["time [s]"]; }
    std::filesystem::path output(const std::string& file) { return folder.path / "postProcessing" / file; }

    TemporaryFolder folder;
    Case makeCase()
    {
        std::filesystem::create_directories(folder.path / "system");
        return Case(folder.path);
    }
    Case theCase = makeCase();
    Lattice lattice = square(8);
    Fluid fluid;
    std::string startTime = "0";
    GivenFlow flow{lattice};
    Timings timings;
};

constexpr const char* errors = "errors { type errorNorms; writeInterval 2; exact { U uniform (1 0 0); } }";

TEST_F(FunctionsTest, RunWhenTheyAreDue)
{
    Functions functions = functionsOf(errors);
    for (long step = 0; step <= 5; ++step) { runStep(functions, step); }
    EXPECT_EQ(timesOf("errors/0/errors.csv"), (std::vector<double>{0, 0.2, 0.4}));
}

TEST_F(FunctionsTest, WriteUnderTheTimeTheyStartFrom)
{
    Functions first = functionsOf(errors);
    for (long step = 0; step <= 2; ++step) { runStep(first, step); }
    startTime = "0.2";
    Functions second = functionsOf(errors);
    second.execute({.time = 0.2, .dt = 0.1, .index = 2, .start = true}, at(flow, timings, 0.2));
    runStep(second, 3);
    runStep(second, 4);
    EXPECT_EQ(timesOf("errors/0/errors.csv"), (std::vector<double>{0, 0.2}));
    EXPECT_EQ(timesOf("errors/0.2/errors.csv"), (std::vector<double>{0.2, 0.4}));
}

TEST_F(FunctionsTest, LeaveNothingBehindUnlessTheyRun)
{
    functionsOf(errors);
    EXPECT_FALSE(std::filesystem::exists(folder.path / "postProcessing"));
}

TEST_F(FunctionsTest, KeepToTheirWindow)
{
    Functions functions = functionsOf("a { type flowStatistics; timeStart 0.2; timeEnd 0.4; }");
    for (long step = 0; step <= 6; ++step) { runStep(functions, step); }
    EXPECT_EQ(timesOf("a/0/flow.csv").size(), 3u);
}

TEST_F(FunctionsTest, AskForTheTimesTheyNeed)
{
    Functions functions =
        functionsOf("a { type flowStatistics; writeControl adjustableRunTime; writeInterval 0.3; }"
                    "b { type timing; writeControl adjustableRunTime; writeInterval 0.25; timeEnd 0.4; }"
                    "c { type fieldAverage; executeControl adjustableRunTime; executeInterval 0.45; }");
    runStep(functions, 0);
    EXPECT_DOUBLE_EQ(functions.nextTime(), 0.25);
    runStep(functions, 3);
    EXPECT_DOUBLE_EQ(functions.nextTime(), 0.45);
    EXPECT_EQ(Functions().nextTime(), std::numeric_limits<double>::infinity());
}

TEST_F(FunctionsTest, ReportTheirLastErrors)
{
    Functions functions = functionsOf(errors);
    EXPECT_TRUE(functions.errors().empty());
    runStep(functions, 0);
    const std::vector<ErrorNorm> found = functions.errors();
    ASSERT_EQ(found.size(), 4u);
    EXPECT_EQ(found[3].field, "U");
    EXPECT_EQ(found[3].norm, "relL2");
    EXPECT_DOUBLE_EQ(found[3].value, 1);
}

TEST_F(FunctionsTest, KnowConstantsInExactSolutions)
{
    Functions functions = functionsOf("speed 3; errors { type errorNorms; twice 2; exact { U expression ("
                                      "\"speed*twice + 0*x\" \"nu\" \"rho\"); } }");
    runStep(functions, 0);
    EXPECT_DOUBLE_EQ(functions.errors()[2].value, std::sqrt(36 + 1e-4 + 4));
}

TEST_F(FunctionsTest, GatherEveryStepAndWriteWithTheFields)
{
    Functions functions = functionsOf("means { type fieldAverage; fields (U); }");
    for (long step = 0; step <= 3; ++step) { runStep(functions, step); }
    EXPECT_FALSE(std::filesystem::exists(output("means")));
    functions.execute({.time = 0.4, .dt = 0.1, .index = 4, .writes = true}, at(flow, timings, 0.4, "0.4"));
    EXPECT_TRUE(std::filesystem::exists(output("means/0.4/fields.h5")));
}

TEST_F(FunctionsTest, OfStoredTimesLeaveAveragesAlone)
{
    Functions functions = functionsOf(std::string("means { type fieldAverage; }") + errors);
    functions.executeAll(at(flow, timings, 0, "0"));
    functions.executeAll(at(flow, timings, 1, "1"));
    EXPECT_FALSE(std::filesystem::exists(output("means")));
    EXPECT_EQ(timesOf("errors/0/errors.csv"), (std::vector<double>{0, 1}));
}

TEST_F(FunctionsTest, SampleTheLinesOfSampleDict)
{
    std::ofstream(folder.path / "system/sampleDict")
        << "lines { rise { start (0 0 0); end (0 1 0); nPoints 3; } } fields (p);";
    Functions functions = functionsOf("profiles { type sampleLines; }");
    runStep(functions, 0);
    EXPECT_EQ(linesOf(output("profiles/0/rise.csv"))[0], "distance [m],x [m],y [m],z [m],p [m2/s2]");
}

TEST_F(FunctionsTest, CountSecondsByPhase)
{
    Functions functions = functionsOf("costs { type timing; }");
    runStep(functions, 0);
    EXPECT_EQ(linesOf(output("costs/0/timing.csv"))[0],
              "time [s],step,setup [s],transforms [s],pointwise [s],boundary [s],continuation [s],poisson [s],"
              "functions [s],output [s],other [s],total [s]");
}

TEST_F(FunctionsTest, ThatAreDisabledAreNotLookedAt)
{
    EXPECT_TRUE(functionsOf("a { type forces; enabled no; }").empty());
}

TEST_F(FunctionsTest, ComplainOfEverySlip)
{
    EXPECT_EQ(
        errorOf("a { type errorNorm; }\n"
                "b { type probes; probeLocation ((0 0 0)); }\n"
                "c { type flowStatistics; writeIntervall 3; }\n"
                "d { type errorNorms; exact { u uniform (0 0 0); } }\n"
                "e { type errorNorms; exact {} }\n"
                "f { writeInterval 3; }\n"
                "g yes;"),
        "system/controlDict:2: functions.a.type: 'errorNorm' is not a known function type\n"
        "    known are: errorNorms, flowStatistics, sampleLines, probes, fieldAverage, timing, wallProfile, forces, "
        "patchFlux\n"
        "system/controlDict:3: functions.b.probeLocations: is missing\n"
        "    write probeLocations ( ... ); (points, e.g. ((0.25 0.5 0) (0.75 0.5 0)) [m])\n"
        "system/controlDict:3: functions.b.probeLocation: is not a known entry\n"
        "    did you mean 'probeLocations'?\n"
        "system/controlDict:4: functions.c.writeIntervall: is not a known entry\n"
        "    did you mean 'writeInterval'?\n"
        "system/controlDict:5: functions.d.exact.u: is not a known entry\n"
        "    did you mean 'U'?\n"
        "system/controlDict:6: functions.e.exact: names no field to compare with\n"
        "    write e.g. exact { U expression (\"sin(y)*exp(-nu*t)\" \"0\" \"0\"); }\n"
        "system/controlDict:7: functions.f.type: is missing\n"
        "    known are: errorNorms, flowStatistics, sampleLines, probes, fieldAverage, timing, wallProfile, forces, "
        "patchFlux\n"
        "system/controlDict:8: functions.g: is no function\n"
        "    write g { type errorNorms; ... }");
}

TEST_F(FunctionsTest, RefuseProbesThatAreNoneOrLieOutside)
{
    const std::string advice = "\n    write e.g. probeLocations ((0.25 0.5 0) (0.75 0.5 0));";
    const std::string origin = "system/controlDict:2: functions.a.probeLocations: ";
    for (const char* locations : {"()", "(0 0 0)", "((0 0))", "((0 0 0) (1 x 0))", "((0 0 0) 1 2 3 4 5)"})
    {
        EXPECT_EQ(errorOf(std::string("a { type probes; probeLocations ") + locations + "; }"),
                  origin + "is no list of points" + advice);
    }
    lattice = Lattice({Axis{'x', 0, 1, 8}, Axis{'y', 0, 1, 9, Axis::Ends::bounded}, Axis{'z'}}, {});
    EXPECT_EQ(errorOf("a { type probes; probeLocations ((0 0.5 0) (7 2 0)); }"),
              origin + "point 1 has y = 2, outside of the box\n    y reaches from 0 to 1");
}

TEST_F(FunctionsTest, RefuseFieldsThatAFlowDoesNotHave)
{
    EXPECT_EQ(errorOf("a { type probes; probeLocations ((0 0 0)); fields (U T); }"),
              "system/controlDict:2: functions.a.fields: 'T' is not a known field\n"
              "    known are: U, p, vorticity, divergence, Q");
    EXPECT_EQ(errorOf("a { type fieldAverage; fields (); }"),
              "system/controlDict:2: functions.a.fields: names no field\n    write e.g. fields (U p);");
}

TEST_F(FunctionsTest, OnWallsNeedWalls)
{
    for (const char* type : {"wallProfile", "forces", "patchFlux"})
    {
        EXPECT_EQ(errorOf(std::string("a { type ") + type + "; patches (floor); }"),
                  "system/controlDict:2: functions.a.type: looks at walls, but the box has no wall patch\n"
                  "    take the function out, or set enabled no;");
    }
}

TEST_F(FunctionsTest, OnWallsNameTheirPatches)
{
    lattice = Lattice({Axis{'x', 0, 1, 8}, Axis{'y', 0, 1, 9, Axis::Ends::bounded}, Axis{'z'}},
                      {{"sides", Patch::Type::periodic, {"xMin", "xMax"}},
                       {"floor", Patch::Type::wall, {"yMin"}},
                       {"lid", Patch::Type::wall, {"yMax"}}});
    EXPECT_EQ(errorOf("a { type forces; }"),
              "system/controlDict:2: functions.a.patches: is missing\n    write e.g. patches (floor);");
    EXPECT_EQ(errorOf("a { type forces; patch lid; patches (floor); }"),
              "system/controlDict:2: functions.a.patches: is there besides patch\n    write e.g. patches (floor);");
    EXPECT_EQ(errorOf("a { type wallProfile; patches (floor sides); }"),
              "system/controlDict:2: functions.a.patches: 'sides' is not a known patch\n    known are: floor, lid");
    EXPECT_EQ(errorOf("a { type wallProfile; patches (); }"),
              "system/controlDict:2: functions.a.patches: names no patch\n    write e.g. patches (floor);");

    flow = GivenFlow(lattice);
    Functions functions = functionsOf("pull { type forces; patches (floor lid); }"
                                      "profile { type wallProfile; patch floor; writeControl timeStep; }");
    runStep(functions, 0);
    EXPECT_EQ(linesOf(output("pull/0/forces.csv"))[0].substr(0, 36), "time [s],step,pressureForce.x [N/m],");
    EXPECT_TRUE(std::filesystem::exists(output("profile/0/floor.csv")));
}

TEST_F(FunctionsTest, AreListed)
{
    std::vector<std::string> names;
    for (const ListedWord& word : functionTypes()) { names.push_back(word.name); }
    EXPECT_THAT(names, testing::ElementsAre("errorNorms", "flowStatistics", "sampleLines", "probes", "fieldAverage",
                                            "timing", "wallProfile", "forces", "patchFlux"));
}

} // namespace
} // namespace isph
