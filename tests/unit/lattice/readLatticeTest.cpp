#include "lattice/readLattice.hpp"
#include "core/Error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

namespace isph
{
namespace
{

using testing::ElementsAre;

const std::string sides = "patches { sides { type periodic; faces (xMin xMax yMin yMax); } }\n";

Lattice made(const std::string& text) { return makeLattice(Dictionary::parse(text, "system/latticeDict")); }

/// The message that refuses a latticeDict.
std::string refusal(const std::string& text)
{
    try
    {
        made(text);
    }
    catch (const Error& error)
    {
        EXPECT_EQ(error.fault(), Fault::input);
        return error.what();
    }
    return "accepted";
}

std::string refusedBox(const std::string& box) { return refusal(box + "\n" + sides); }

std::string refusedPatches(const std::string& patches)
{
    return refusal("extent (1 1 0); count (8 8 1);\npatches\n{\n" + patches + "\n}\n");
}

std::array<int, 3> counts(const Lattice& lattice)
{
    return {lattice.axis(0).count, lattice.axis(1).count, lattice.axis(2).count};
}

const std::string channel = "patches { sides { type periodic; axis x; } walls { type wall; faces (yMin yMax); } }\n";

TEST(MakeLattice, TakesOnePointAlongAPeriodicAxis)
{
    const std::array<int, 3> thin{1, 9, 1};
    for (const char* points : {"count (1 9 1);", "intervals (1 8 0);", "spacing (1 0.125 1);"})
    {
        const Lattice lattice = made("extent (1 1 0); " + std::string(points) + "\n" + channel);
        EXPECT_EQ(counts(lattice), thin) << points;
        EXPECT_EQ(lattice.dimensions(), 2);
    }
}

TEST(MakeLattice, ReadsPeriodicBoxes)
{
    const Lattice lattice = made("origin (-0.5 -0.5 0); extent (1 1 0); count (160 120 1);\n" + sides);
    EXPECT_EQ(lattice.dimensions(), 2);
    EXPECT_TRUE(lattice.periodic());
    EXPECT_EQ(lattice.axis(0), (Axis{'x', -0.5, 1, 160, Axis::Ends::periodic, false}));
    EXPECT_EQ(lattice.axis(1), (Axis{'y', -0.5, 1, 120, Axis::Ends::periodic, false}));
    EXPECT_EQ(lattice.axis(2), (Axis{'z', 0, 0, 1, Axis::Ends::periodic, false}));
    EXPECT_THAT(lattice.patches(),
                ElementsAre(Patch{"sides", Patch::Type::periodic, {"xMin", "xMax", "yMin", "yMax"}}));
}

TEST(MakeLattice, ReadsBoundedAxes)
{
    const Lattice lattice = made("extent (2 1 0); count (8 9 1);\n"
                                 "patches { sides { type periodic; axis x; } floor { type wall; face yMin; }\n"
                                 "          lid { type patch; faces (yMax); } }");
    EXPECT_TRUE(lattice.axis(0).periodic());
    EXPECT_FALSE(lattice.axis(1).periodic());
    EXPECT_EQ(lattice.axis(1).spacing(), 0.125);
    EXPECT_THAT(lattice.patches(),
                ElementsAre(Patch{"sides", Patch::Type::periodic, {"xMin", "xMax"}},
                            Patch{"floor", Patch::Type::wall, {"yMin"}}, Patch{"lid", Patch::Type::patch, {"yMax"}}));
}

TEST(MakeLattice, StaggersBoundedAxesOnly)
{
    const Lattice lattice = made("extent (2 1 0); count (8 8 1); arrangement staggered;\n" + channel);
    EXPECT_FALSE(lattice.axis(0).staggered);
    EXPECT_TRUE(lattice.axis(1).staggered);
    EXPECT_EQ(lattice.axis(1).spacing(), 0.125);
    EXPECT_EQ(lattice.axis(1).coordinate(0), 0.0625);
}

TEST(MakeLattice, CountsPointsOfIntervals)
{
    EXPECT_THAT(counts(made("extent (2 1 0); intervals (8 8 0);\n" + channel)), ElementsAre(8, 9, 1));
    EXPECT_THAT(counts(made("extent (2 1 0); intervals (8 8 0); arrangement staggered;\n" + channel)),
                ElementsAre(8, 8, 1));
}

TEST(MakeLattice, CountsPointsOfSpacings)
{
    EXPECT_THAT(counts(made("extent (2 1 0); spacing 0.1;\n" + channel)), ElementsAre(20, 11, 1));
    EXPECT_THAT(counts(made("extent (2 1 0); spacing (0.25 0.1 1);\n" + channel)), ElementsAre(8, 11, 1));
    EXPECT_THAT(counts(made("extent (2 1 0); spacing 0.1; arrangement staggered;\n" + channel)),
                ElementsAre(20, 10, 1));
    // A third, to nine digits and a bit.
    EXPECT_THAT(counts(made("extent (1 1 0); spacing 0.3333333333;\n" + sides)), ElementsAre(3, 3, 1));
}

TEST(MakeLattice, LeavesOutAnyAxis)
{
    const Lattice lattice = made("extent (1 0 1); count (8 1 4);\n"
                                 "patches { a { type periodic; axis x; } b { type periodic; axis z; } }");
    EXPECT_EQ(lattice.dimensions(), 2);
    EXPECT_EQ(lattice.direction(1), 2);
}

TEST(MakeLattice, RefusesImpossibleBoxes)
{
    EXPECT_EQ(refusedBox("extent (1 -1 0); count (8 8 1);"),
              "system/latticeDict:1: extent: is -1 along axis y but must be 0 or more\n"
              "    write the size of the box in metres; 0 leaves an axis out");
    EXPECT_EQ(refusedBox("extent (1 0 0); count (8 1 1);"),
              "system/latticeDict:1: extent: is above 0 along fewer than two axes\n"
              "    incompressible flow along one line is a constant: give two or three axes an extent");
}

TEST(MakeLattice, RefusesImpossibleCounts)
{
    EXPECT_EQ(refusedBox("extent (1 1 0);\ncount (8 0 1);"),
              "system/latticeDict:2: count: is 0 along axis y but must be at least 1");
    EXPECT_EQ(refusedBox("extent (1 1 0);\ncount (-8 8 1);"),
              "system/latticeDict:2: count: is -8 along axis x but must be at least 1");
    EXPECT_EQ(refusedBox("extent (1 1 0);\ncount (8 8.5 1);"),
              "system/latticeDict:2: count: is 8.5 along axis y but must be a whole number");
    EXPECT_EQ(refusal("extent (1 1 0);\ncount (8 1 1);\n" + channel),
              "system/latticeDict:2: count: is 1 along axis y but must be at least 2");
    EXPECT_EQ(refusedBox("extent (1 1 0);\ncount (8 8 8);"),
              "system/latticeDict:2: count: is 8 along axis z, whose extent is 0\n"
              "    write 1 to leave the axis out, or give it an extent");
    EXPECT_EQ(refusedBox("extent (1 1 0);\ncount (3e9 8 1);"),
              "system/latticeDict:2: count: is 3000000000 along axis x but can be at most 2147483646");
    EXPECT_EQ(refusedBox("extent (1 1 0);\ncount (2e9 2e9 1);"),
              "system/latticeDict:2: count: makes 4e+18 points, more than any memory holds\n"
              "    take fewer points");
}

TEST(MakeLattice, RefusesImpossibleIntervals)
{
    EXPECT_EQ(refusedBox("extent (1 1 0);\nintervals (8 8 1);"),
              "system/latticeDict:2: intervals: is 1 along axis z, whose extent is 0\n"
              "    write 0 to leave the axis out, or give it an extent");
    EXPECT_EQ(refusedBox("extent (1 1 0);\nintervals (8 0 0);"),
              "system/latticeDict:2: intervals: is 0 along axis y but must be at least 1");
}

TEST(MakeLattice, RefusesImpossibleSpacings)
{
    EXPECT_EQ(refusedBox("extent (1 1 0);\nspacing 0.3;"),
              "system/latticeDict:2: spacing: 0.3 does not fit the extent 1 of axis x\n"
              "    write 0.3333333333333333 for 3 intervals or 0.25 for 4");
    EXPECT_EQ(refusedBox("extent (1 1 0);\nspacing 0.33333333;"),
              "system/latticeDict:2: spacing: 0.33333333 does not fit the extent 1 of axis x\n"
              "    write 0.3333333333333333 for 3 intervals or 0.25 for 4");
    EXPECT_EQ(refusedBox("extent (1 1 0);\nspacing -0.1;"),
              "system/latticeDict:2: spacing: is -0.1 along axis x but must be positive");
    EXPECT_EQ(refusal("extent (1 1 0);\nspacing 1;\narrangement staggered;\n" + channel),
              "system/latticeDict:2: spacing: 1 leaves axis y with one point\n"
              "    an axis that ends at walls needs two points or more");
    EXPECT_EQ(refusedBox("extent (1 1 0);\nspacing 1e-12;"),
              "system/latticeDict:2: spacing: is 1000000000000 along axis x but can be at most 2147483646");
}

TEST(MakeLattice, WantsOneOfCountIntervalsSpacing)
{
    EXPECT_EQ(refusedBox("extent (1 1 0);"), "system/latticeDict: has none of count, intervals and spacing\n"
                                             "    write one of them, e.g. count (160 160 1);");
    EXPECT_EQ(refusedBox("extent (1 1 0); count (8 8 1);\nspacing 0.125;"),
              "system/latticeDict:2: spacing: is given besides count\n    keep one of the two");
}

TEST(MakeLattice, WantsEveryFaceInOnePatch)
{
    EXPECT_EQ(refusedPatches("a { type periodic; axis x; }\nb { type wall; face yMin; }"),
              "system/latticeDict:3: patches: no patch has the face yMax\n"
              "    add it to one, e.g. sides { type periodic; axis y; }");
    EXPECT_EQ(refusedPatches("a { type periodic; axis x; }\nb { type wall; axis y; }\nc { type wall; face yMin; }"),
              "system/latticeDict:6: patches.c: has the face yMin, which patch b has already\n"
              "    name every face once");
    EXPECT_EQ(refusedPatches("a { type periodic; axis x; }\nb { type wall; faces (yMin yMin yMax); }"),
              "system/latticeDict:5: patches.b: names the face yMin twice\n"
              "    name every face once");
    EXPECT_EQ(refusedPatches("a { type periodic; axis x; }\nb { type wall; faces (yMin yMaxx); }"),
              "system/latticeDict:5: patches.b.faces: 'yMaxx' is not a known face\n"
              "    known are: yMax, xMin, xMax, yMin, zMin, zMax");
    EXPECT_EQ(refusedPatches("a { type periodic; axis x; }\nb { type wall; axis y; }\nc { type wall; face zMin; }"),
              "system/latticeDict:6: patches.c: has the face zMin, but axis z is left out (extent 0)\n"
              "    take the face out of the patch, or give the axis an extent");
}

TEST(MakeLattice, WantsPeriodicFacesInPairs)
{
    EXPECT_EQ(refusedPatches("a { type periodic; faces (xMin yMin yMax); }\nb { type wall; face xMax; }"),
              "system/latticeDict:4: patches.a: is periodic but has xMin without xMax\n"
              "    write axis x; or make it a wall or a patch");
    EXPECT_EQ(refusedPatches("a { type periodic; axis y; }\nb { type periodic; face xMin; }\n"
                             "c { type periodic; face xMax; }"),
              "system/latticeDict:5: patches.b: is periodic but has xMin without xMax\n"
              "    write axis x; or make it a wall or a patch\n"
              "system/latticeDict:6: patches.c: is periodic but has xMax without xMin\n"
              "    write axis x; or make it a wall or a patch");
}

TEST(MakeLattice, WantsTheFacesOfAPatchOnce)
{
    EXPECT_EQ(refusedPatches("a { type periodic; axis x; face yMin; }\nb { type wall; axis y; }"),
              "system/latticeDict:4: patches.a: has faces given in more than one way\n"
              "    write one of: face xMin; | faces (xMin xMax); | axis x;");
    EXPECT_EQ(refusedPatches("a { type periodic; }\nb { type wall; axis y; }"),
              "system/latticeDict:4: patches.a: has no faces\n"
              "    write one of: face xMin; | faces (xMin xMax); | axis x;");
    EXPECT_EQ(refusedPatches("\"a.*\" { type periodic; axis x; }\nb { type wall; axis y; }"),
              "system/latticeDict:4: patches.a.*: is a pattern, but a patch needs a name\n"
              "    leave out the quotes");
}

TEST(LatticeText, ReadsBackTheSameLattice)
{
    for (const std::string& text : std::vector<std::string>{
             "origin (-0.1 0.2 1e-7); extent (0.3 1.7 0); count (7 9 1);\n" + sides,
             "extent (2 0.7 0); intervals (8 8 0);\n" + channel,
             "extent (2 0.7 0); intervals (8 8 0); arrangement staggered;\n" + channel,
             "origin (1 2 3); extent (1e-3 3e5 0.1); spacing (0.0001 1e4 0.1e-1);\n"
             "patches { in { type patch; face xMin; } out { type patch; face xMax; } z { type periodic; axis z; }\n"
             "walls { type wall; axis y; } }"})
    {
        const Lattice lattice = made(text);
        const std::string written = latticeText(lattice);
        EXPECT_EQ(readLattice(Dictionary::parse(written, "constant/lattice")), lattice) << written;
    }
}

TEST(LatticeText, IsWhatOneReads)
{
    EXPECT_EQ(latticeText(made("origin (-0.5 0 0); extent (2 1 0); intervals (8 10 0);\n" + channel)),
              "FoamFile\n"
              "{\n"
              "    version     2.0;\n"
              "    format      ascii;\n"
              "    class       dictionary;\n"
              "    object      lattice;\n"
              "}\n"
              "\n"
              "// Written by makeLattice from system/latticeDict: change that instead.\n"
              "\n"
              "origin      (-0.5 0 0);\n"
              "extent      (2 1 0);\n"
              "count       (8 11 1);\n"
              "spacing     (0.25 0.1 0);\n"
              "axes        (periodic bounded leftOut);\n"
              "arrangement collocated;\n"
              "\n"
              "patches\n"
              "{\n"
              "    sides\n"
              "    {\n"
              "        type    periodic;\n"
              "        faces   (xMin xMax);\n"
              "    }\n"
              "    walls\n"
              "    {\n"
              "        type    wall;\n"
              "        faces   (yMin yMax);\n"
              "    }\n"
              "}\n");
}

std::string refusedEdit(const std::string& from, const std::string& to)
{
    std::string text = latticeText(made("extent (2 1 0); intervals (8 10 0);\n" + channel));
    text.replace(text.find(from), from.size(), to);
    try
    {
        readLattice(Dictionary::parse(text, "constant/lattice"));
    }
    catch (const Error& error)
    {
        return error.what();
    }
    return "accepted";
}

TEST(ReadLattice, RefusesWhatAnEditContradicts)
{
    EXPECT_EQ(refusedEdit("(8 11 1)", "(16 11 1)"),
              "constant/lattice:14: spacing: is 0.25 along axis x, but extent and count make it 0.125\n"
              "    change system/latticeDict instead and run makeLattice -overwrite");
    EXPECT_EQ(refusedEdit("periodic bounded", "bounded bounded"),
              "constant/lattice:15: axes: calls axis x bounded, but extent and patches make it periodic\n"
              "    change system/latticeDict instead and run makeLattice -overwrite");
    EXPECT_EQ(refusedEdit("periodic bounded leftOut", "periodic bounded"),
              "constant/lattice:15: axes: must be three words, one an axis");
    EXPECT_EQ(refusedEdit("(8 11 1)", "(8 0 1)"),
              "constant/lattice:13: count: is 0 along axis y but must be at least 2");
}

TEST(ReadLattice, NamesWhatIsMissing)
{
    try
    {
        readLattice(Dictionary::parse("FoamFile { object lattice; }\n", "constant/lattice"));
        FAIL() << "accepted";
    }
    catch (const Error& error)
    {
        std::vector<std::string> missing;
        for (const Complaint& complaint : error.complaints())
        {
            EXPECT_EQ(complaint.origin.file, "constant/lattice");
            missing.push_back(complaint.origin.entry);
        }
        EXPECT_THAT(missing, ElementsAre("origin", "extent", "count", "spacing", "axes", "arrangement", "patches"));
    }
}

} // namespace
} // namespace isph
