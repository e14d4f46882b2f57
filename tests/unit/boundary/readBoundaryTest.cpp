#include "boundary/readBoundary.hpp"

#include "boxes.hpp"
#include "core/Error.hpp"
#include "support/messageOf.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

using test::AxisKind;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr AxisKind walls = AxisKind::collocated;

const Lattice cavity = test::box({walls, walls, AxisKind::leftOut}, {5, 5, 1});
const Lattice channel = test::box({AxisKind::periodic, walls, AxisKind::leftOut}, {8, 5, 1});

/// As cavity, but of patches: flow may enter and leave.
const Lattice openBox = test::box({walls, walls, AxisKind::leftOut}, {5, 9, 1}, Patch::Type::patch);

/// Conditions of U and p; the patches stand in the lines from 3 on.
FlowBoundary read(const Lattice& lattice, const std::string& U, const std::string& p, BoundaryContext context = {})
{
    return readBoundary(Dictionary::parse("Umax 1.5;\nboundaryField {\n" + U + "}", "0/U"),
                        Dictionary::parse("\nboundaryField {\n" + p + "}", "0/p"), lattice, context);
}

std::string refusal(const Lattice& lattice, const std::string& U, const std::string& p)
{
    return messageOf([&] { read(lattice, U, p); });
}

const std::string zeroGradient = "\".*\" { type zeroGradient; }\n";

TEST(readBoundary, CavityWithAMovingLid)
{
    const FlowBoundary boundary =
        read(cavity, "\"(x|y)M.*\" { type noSlip; }\nyMax { type fixedValue; value uniform (1 0 0); }\n", zeroGradient);
    EXPECT_EQ(boundary.face(1, Side::high).patch, "yMax");
    EXPECT_EQ(boundary.face(0, Side::low).velocity, VelocityCondition::value);
    EXPECT_EQ(boundary.face(0, Side::low).U, nullptr);
    EXPECT_EQ(boundary.face(1, Side::low).pressure, PressureCondition::zeroGradient);
    EXPECT_THAT(boundary.velocity(1, Side::high, 0), Each(1)); // evaluated already
    EXPECT_THAT(boundary.velocity(0, Side::low, 0), ElementsAre(0, 0, 0, 0, 1));
}

TEST(readBoundary, ExpressionsKnowConstantsOfCaseAndDictionaryAndTime)
{
    BoundaryContext context;
    context.constants = {{"nu", 0.5}};
    context.time = 2;
    FlowBoundary boundary = read(
        channel,
        "x { type periodic; }\nyMin { type slip; }\n"
        "yMax { type fixedValue; width 4; value expression (\"Umax*nu*width*t + 0*x\" \"0\" \"0\"); }\n",
        "x { type periodic; }\nyMin { type zeroGradient; }\nyMax { type fixedGradient; gradient expression \"x\"; }\n",
        context);
    EXPECT_TRUE(boundary.dependsOnTime());
    EXPECT_THAT(boundary.velocity(1, Side::high, 0), Each(6));
    EXPECT_THAT(boundary.velocity(1, Side::low, 0), IsEmpty());
    EXPECT_THAT(boundary.velocity(1, Side::low, 1), Each(0));
    EXPECT_EQ(boundary.pressure(1, Side::high)[3], 0.375);
    boundary.update(3);
    EXPECT_THAT(boundary.velocity(1, Side::high, 0), Each(9));
}

TEST(readBoundary, PressureInPascalIsDividedByTheDensity)
{
    BoundaryContext context;
    context.pressureScale = 1000;
    const FlowBoundary boundary =
        read(openBox,
             "\"y.*\" { type symmetry; }\nxMin { type fixedValue; value uniform (1 0 0); }\nxMax { type outflow; }\n",
             "\"y.*|xMin\" { type zeroGradient; }\nxMax { type fixedValue; value uniform 500; }\n", context);
    EXPECT_THAT(boundary.pressure(0, Side::high), Each(0.5));
    EXPECT_TRUE(boundary.fixesPressure());
    EXPECT_EQ(boundary.face(0, Side::high).velocity, VelocityCondition::outflow);
    EXPECT_EQ(boundary.face(1, Side::low).velocity, VelocityCondition::slip);
}

TEST(readBoundary, PeriodicBoxes)
{
    const Lattice lattice = test::box({AxisKind::periodic, AxisKind::periodic, AxisKind::leftOut}, {4, 4, 1});
    const std::string periodic = "\".*\" { type periodic; }\n";
    EXPECT_FALSE(read(lattice, periodic, periodic).dependsOnTime());
    EXPECT_EQ(refusal(lattice, "x { type periodic; }\ny { type noSlip; }\n", periodic),
              "0/U:4: boundaryField.y.type: is noSlip but patch y is periodic\n"
              "    write type periodic; or change the patch in system/latticeDict");
}

TEST(readBoundary, AllSlipsInWordsAndKeysAreToldAtOnce)
{
    EXPECT_EQ(refusal(cavity,
                      "xMin { type noslip; }\n"                        // 3
                      "xMax { type periodic; }\n"                      // 4
                      "yMin { type fixedValue; }\n"                    // 5
                      "yMax { type noSlip; valeu uniform (0 0 0); }\n" // 6
                      ,
                      "xMin { type fixedGradient; value uniform 0; }\n" // 3
                      "xMax { type zeroGradient; }\n"
                      "yMin { typ zeroGradient; }\n" // 5
                      ),
              "0/U:3: boundaryField.xMin.type: 'noslip' is not a known condition of the velocity\n"
              "    known are: noSlip, periodic, fixedValue, slip, symmetry, outflow\n"
              "0/U:4: boundaryField.xMax.type: is periodic but patch xMax is not\n"
              "    write another type or change the patch in system/latticeDict\n"
              "0/U:5: boundaryField.yMin.value: is missing, but type fixedValue needs it\n"
              "    write e.g. value uniform (1 0 0);\n"
              "0/U:6: boundaryField.yMax.valeu: is not a known entry\n"
              "    did you mean 'value'?\n"
              "0/p:3: boundaryField.xMin.gradient: is missing, but type fixedGradient needs it\n"
              "    write e.g. gradient uniform 0;\n"
              "0/p:5: boundaryField.yMin.type: is missing\n"
              "    write type <word>; (see -listPressureConditions)\n"
              "0/p:5: boundaryField.yMin.typ: is not a known entry\n"
              "    did you mean 'type'?\n"
              "0/p:2: boundaryField: patch yMax has no boundary condition\n"
              "    write yMax { type ...; }");
}

TEST(readBoundary, AWallLetsNothingOut)
{
    EXPECT_EQ(refusal(cavity, "\"y.*|xMin\" { type noSlip; }\nxMax { type outflow; }\n",
                      "\"y.*|xMin\" { type zeroGradient; }\nxMax { type fixedValue; value uniform 0; }\n"),
              "0/U:4: boundaryField.xMax.type: is outflow, but patch xMax is a wall\n"
              "    a wall lets nothing out: write type patch; for it in system/latticeDict");
}

TEST(readBoundary, VelocityAndPressureAreNotBothPrescribed)
{
    for (const char* word : {"noSlip", "slip", "symmetry", "fixedValue; value uniform (0 0 0)"})
    {
        const std::string said =
            refusal(openBox, "\"y.*|xMin\" { type noSlip; }\nxMax { type " + std::string(word) + "; }\n",
                    "\"y.*|xMin\" { type zeroGradient; }\nxMax { type fixedValue; value 0; }\n");
        EXPECT_THAT(said, HasSubstr("0/p:4: boundaryField.xMax.type: is fixedValue, but U of patch xMax is "));
        EXPECT_THAT(said, HasSubstr("velocity and pressure cannot both be prescribed\n"
                                    "    write type zeroGradient; or make the patch an outlet: U outflow"));
    }
}

TEST(readBoundary, AnOutletHoldsThePressure)
{
    for (const char* word : {"zeroGradient", "fixedGradient; gradient uniform 0"})
    {
        const std::string said =
            refusal(openBox, "\"y.*|xMin\" { type noSlip; }\nxMax { type outflow; }\n",
                    "\"y.*|xMin\" { type zeroGradient; }\nxMax { type " + std::string(word) + "; }\n");
        EXPECT_THAT(said, HasSubstr("0/p:4: boundaryField.xMax.type: is "));
        EXPECT_THAT(said, HasSubstr("but U of patch xMax is outflow: nothing holds the pressure"));
        EXPECT_THAT(said, HasSubstr("write type fixedValue; value uniform 0;"));
    }
}

TEST(readBoundary, WhatEntersMustLeave)
{
    const auto through = [](const std::string& inlet, const std::string& outlet)
    {
        return refusal(openBox,
                       "\"y.*\" { type noSlip; }\nxMin { type fixedValue; value " + inlet +
                           "; }\nxMax { type fixedValue; value " + outlet + "; }\n",
                       zeroGradient);
    };
    EXPECT_EQ(through("uniform (1 0 0)", "uniform (0.5 0 0)"),
              "0/U:2: boundaryField: prescribes 1 m2/s of inflow but 0.5 m2/s of outflow, and no patch is an outlet\n"
              "    what enters an incompressible flow must leave: make a patch an outlet (U outflow, p fixedValue), or "
              "let both agree");
    EXPECT_THAT(through("uniform (1 0 0)", "uniform (1.00001 0 0)"), HasSubstr("1.00001 m2/s of outflow"));
    EXPECT_THAT(through("uniform (0 0 0)", "uniform (0 0 0)"), "no error");
    EXPECT_THAT(through("uniform (0 0 0)", "uniform (1 0 0)"), HasSubstr("0 m2/s of inflow but 1 m2/s"));
    // Equal as integrals, though not as sums over the points.
    EXPECT_THAT(through("expression (\"6*y*(1-y)\" \"0\" \"0\")", "uniform (1 0 0)"), "no error");
    // Equal as sums over the points, though not as integrals: a jet that begins and ends between points.
    EXPECT_THAT(through("expression (\"y > 0.3 && y < 0.7 ? 1 : 0\" \"0\" \"0\")",
                        "expression (\"y > 0.3 && y < 0.7 ? 1 : 0\" \"0\" \"0\")"),
                "no error");
}

TEST(readBoundary, FacesMustNotContradictEachOther)
{
    const auto corner = [](const std::string& lid, const std::string& side)
    {
        return refusal(cavity,
                       "\".Min\" { type noSlip; }\nxMax { type " + side +
                           "; }\nyMax { type fixedValue; value uniform " + lid + "; }\n",
                       zeroGradient);
    };
    EXPECT_EQ(
        corner("(1 0 0)", "fixedValue; value uniform (0 2 0)"),
        "0/U:4: boundaryField.xMax.value: contradicts patch yMax at their common point (1 1 0): (0 2 0) here, (1 0 "
        "0) m/s there\n"
        "    where faces meet, their velocities must agree or all but one vanish");
    EXPECT_EQ(corner("(1 0 0)", "noSlip"), "no error");
    EXPECT_EQ(corner("(1 0 0)", "slip"), "no error"); // the lid drives fluid into the corner of a mirror
    EXPECT_EQ(corner("(1 0 0)", "fixedValue; value expression (\"0\" \"sin(pi*y)\" \"0\")"), "no error");
}

TEST(readBoundary, ComponentsAlongAnAxisLeftOutVanish)
{
    EXPECT_EQ(refusal(cavity, "\".Min|xMax\" { type noSlip; }\nyMax { type fixedValue; value uniform (1 0 2); }\n",
                      zeroGradient),
              "0/U:4: boundaryField.yMax.value: has a component along z, an axis that the lattice leaves out\n"
              "    write 0 there, or give axis z an extent in system/latticeDict");
}

TEST(readBoundary, ValuesAreFinite)
{
    const std::string said = refusal(
        cavity,
        "\".Min|xMax\" { type noSlip; }\nyMax { type fixedValue; value expression (\"1/(x - 0.5)\" \"0\" \"0\"); }\n",
        zeroGradient);
    EXPECT_THAT(said, HasSubstr("0/U:4: boundaryField.yMax.value: \"1/(x - 0.5)\" is infinite at (0.5 1 0), t = 0"));
}

TEST(readBoundary, FunctionsThatCannotBeRead)
{
    EXPECT_THAT(
        refusal(cavity, "\".Min|xMax\" { type noSlip; }\nyMax { type fixedValue; value uniform 1; }\n", zeroGradient),
        HasSubstr("0/U:4: boundaryField.yMax.value: is uniform 1 but needs three numbers"));
    EXPECT_THAT(
        refusal(cavity,
                "\".Min|xMax\" { type noSlip; }\nyMax { type fixedValue; value expression (\"w\" \"0\" \"0\"); }\n",
                zeroGradient),
        HasSubstr("0/U:4: boundaryField.yMax.value"));
}

TEST(checkConditions, LookAtOneFieldAlone)
{
    const Dictionary U = Dictionary::parse("boundaryField { \".*\" { type noslip; } }", "0/U");
    EXPECT_EQ(messageOf([&] { checkVelocityConditions(U, cavity); }), // once for all four patches
              "0/U:1: boundaryField..*.type: 'noslip' is not a known condition of the velocity\n"
              "    known are: noSlip, periodic, fixedValue, slip, symmetry, outflow");
    const Dictionary p = Dictionary::parse("boundaryField { \".*\" { type fixedValue; } }", "0/p");
    EXPECT_THAT(messageOf([&] { checkPressureConditions(p, cavity); }), HasSubstr("is missing, but type fixedValue"));
    EXPECT_THAT(messageOf([&] { checkPressureConditions(Dictionary::parse("a 1;", "0/p"), cavity); }),
                HasSubstr("boundaryField"));
}

} // namespace
} // namespace isph
