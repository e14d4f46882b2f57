#include "flow/readFlowSettings.hpp"

#include "flow/describeScene.hpp"
#include "support/messageOf.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::StartsWith;

Axis axis(char name, int count, Axis::Ends ends, bool staggered = false)
{
    return {.name = name, .extent = 1, .count = count, .ends = ends, .staggered = staggered};
}

Lattice box(int n)
{
    return {{axis('x', n, Axis::Ends::periodic), axis('y', n, Axis::Ends::periodic), Axis{.name = 'z'}}, {}};
}

/// x periodic, y between walls.
Lattice channel(int points, bool staggered = false)
{
    return {{axis('x', 32, Axis::Ends::periodic), axis('y', points, Axis::Ends::bounded, staggered), Axis{.name = 'z'}},
            {}};
}

const std::string kernel = "kernel { type gaussian; }\n"; // line 1

FlowSettings read(const Lattice& lattice, const std::string& schemes, const std::string& solution = "",
                  const Fluid& fluid = {.nu = 0.01})
{
    return readFlowSettings(Dictionary::parse(schemes, "system/schemes"),
                            Dictionary::parse(solution, "system/solution"), lattice, fluid);
}

std::string refusal(const Lattice& lattice, const std::string& schemes, const std::string& solution = "")
{
    return messageOf([&] { read(lattice, schemes, solution); });
}

TEST(SchemesOfALattice, HaveTheDefaultsOfPeriodicBoxes)
{
    const FlowSettings settings = read(box(32), kernel);
    EXPECT_EQ(settings.kernel.kernel->order(), 10);
    EXPECT_EQ(settings.convection, ConvectionForm::divergence);
    EXPECT_EQ(settings.laplacian, LaplacianForm::morris);
    EXPECT_EQ(settings.dealiasing, Dealiasing::twoThirds);
    EXPECT_TRUE(settings.exactMeanFlow);
    EXPECT_EQ(viscousTreatment(settings), ViscousTreatment::integratingFactor);
    EXPECT_TRUE(std::ranges::none_of(settings.continuations, [](const auto& made) { return made != nullptr; }));
}

TEST(SchemesOfALattice, HaveOthersWhereAnAxisIsBounded)
{
    const FlowSettings settings = read(channel(65), kernel);
    EXPECT_EQ(settings.kernel.kernel->order(), 20);
    EXPECT_EQ(settings.convection, ConvectionForm::advective);
    EXPECT_EQ(settings.laplacian, LaplacianForm::secondDerivative);
    EXPECT_EQ(settings.dealiasing, Dealiasing::none);
    EXPECT_FALSE(settings.exactMeanFlow);
    EXPECT_EQ(viscousTreatment(settings), ViscousTreatment::automatic);
    EXPECT_EQ(settings.walls, WallTreatment::consistent);
    EXPECT_EQ(settings.continuation, "smoothGram, degree 4");
    EXPECT_EQ(settings.continuations[0], nullptr);
    ASSERT_NE(settings.continuations[1], nullptr);
    EXPECT_EQ(settings.continuations[1]->points(), 5);
    EXPECT_EQ(settings.continuations[1]->newPoints(), 31);
    EXPECT_FALSE(settings.extended || settings.crankNicolson || settings.directPressure);
}

TEST(SchemesOfALattice, AreMirroredWhereItIsStaggered)
{
    const FlowSettings settings = read(channel(64, true), kernel);
    EXPECT_EQ(settings.continuation, "mirror");
    EXPECT_EQ(settings.walls, WallTreatment::paper);
    EXPECT_THAT(
        refusal(channel(64, true), kernel + "walls consistent;"),
        StartsWith("system/schemes:2: walls: consistent needs points on the walls, but the lattice is staggered"));
    EXPECT_THAT(refusal(channel(64, true), kernel + "continuation { type smoothGram; }"),
                StartsWith("system/schemes:2: continuation.type: smoothGram needs points on the walls"));
}

TEST(SchemesOfALattice, KnowEveryWordOfBoundedAxes)
{
    EXPECT_TRUE(read(channel(65), kernel + "viscous CrankNicolson;").crankNicolson);
    EXPECT_EQ(viscousTreatment(read(channel(65), kernel + "viscous explicit;")), ViscousTreatment::explicitTerm);
    EXPECT_TRUE(read(channel(65), kernel, "p { solver direct; }").directPressure);
    EXPECT_TRUE(read(channel(65), kernel + "continuation { extended yes; }").extended);
    for (const auto& variant : wallTreatments().names())
    {
        EXPECT_EQ(wallTreatments().nameOf(read(channel(65), kernel + "walls " + variant + ";").walls), variant);
    }
}

TEST(SolutionOfALattice, KnowsIterativeSolvers)
{
    const std::string fine = "kernel { type gaussian; order 4; smoothingLength 2; }\n";
    EXPECT_FALSE(read(channel(65), fine).iteration);
    const FlowSettings settings = read(channel(65), fine, "p { solver BiCGStab; }");
    ASSERT_TRUE(settings.iteration);
    EXPECT_EQ(settings.iteration->solver, PressureSolver::biCGStab);
    EXPECT_EQ(settings.iteration->preconditioner, Preconditioning::jacobi);
    EXPECT_EQ(settings.iteration->krylov.tolerance, 1e-10);
    EXPECT_EQ(settings.iteration->krylov.maxIterations, 1000);
    EXPECT_EQ(settings.eigenvalues, Eigenvalues::morris);
    EXPECT_FALSE(settings.directPressure);
    const FlowSettings other =
        read(channel(65), fine, "p { solver CG; preconditioner none; tolerance 1e-6; maxIter 50; eigenvalues exact; }");
    EXPECT_EQ(other.iteration->solver, PressureSolver::cg);
    EXPECT_EQ(other.iteration->preconditioner, Preconditioning::none);
    EXPECT_EQ(other.iteration->krylov.tolerance, 1e-6);
    EXPECT_EQ(other.iteration->krylov.maxIterations, 50);
    EXPECT_EQ(other.eigenvalues, Eigenvalues::morris);
    EXPECT_EQ(read(channel(65), fine, "p { eigenvalues morris; }").eigenvalues, Eigenvalues::morris);
}

TEST(SolutionOfALattice, RefusesMatricesThatMakeNoSense)
{
    const auto refused = [](const std::string& schemes, const std::string& p)
    { return refusal(channel(65), schemes, "p { " + p + " }"); };
    const std::string fine = "kernel { type gaussian; order 4; smoothingLength 2; }";
    EXPECT_THAT(refused("kernel { type exact; }", "solver CG;"),
                StartsWith("system/solution:1: p.solver: CG sums over neighbours, and the exact derivative has none"));
    EXPECT_THAT(refused("kernel { type exact; }", "eigenvalues morris;"),
                StartsWith("system/solution:1: p.eigenvalues: morris sums over neighbours"));
    const std::string weak = "system/solution:1: p.solver: the Laplacian of this kernel's samples is too weak";
    const auto refusedOn = [](int points, const std::string& settings)
    { return refusal(channel(points), "kernel { type gaussian; " + settings + " }", "p { solver BiCGStab; }"); };
    EXPECT_THAT(refusedOn(33, "order 20; smoothingLength 1.5;"),
                AllOf(StartsWith(weak), HasSubstr("a larger smoothingLength (2), or a lower order")));
    EXPECT_THAT(refusedOn(33, "order 66; smoothingLength 2;"),
                AllOf(StartsWith(weak), HasSubstr("write a lower order in kernel")));
    EXPECT_THAT(refusedOn(129, "order 20; smoothingLength 1.5;"),
                AllOf(StartsWith(weak), HasSubstr("take the same spacing on every axis")));
    EXPECT_THAT(refused("kernel { type gaussian; smoothingLength 0.1; supportRadius 5; }", "solver CG;"),
                StartsWith("system/solution:1: p.solver: the support of the sampled kernel reaches no neighbour"));
    EXPECT_THAT(refused(fine, "solver gmres;"), StartsWith("system/solution:1: p.solver: 'gmres' is not a known"));
    EXPECT_THAT(refused(fine, "solver CG; preconditioner ilu;"), StartsWith("system/solution:1: p.preconditioner:"));
    EXPECT_THAT(refused(fine, "solver CG; tolerance 0;"), StartsWith("system/solution:1: p.tolerance:"));
    EXPECT_THAT(refused(fine, "solver CG; maxIter 0;"), StartsWith("system/solution:1: p.maxIter:"));
    EXPECT_THAT(refused(fine, "eigenvalues secondOrder;"), StartsWith("system/solution:1: p.eigenvalues: secondOrder"));
}

TEST(SchemesOfALattice, RefuseWhatIsOfPeriodicBoxes)
{
    const auto refused = [](const std::string& line) { return refusal(channel(65), kernel + line); };
    EXPECT_THAT(refused("convection divergence;"),
                StartsWith("system/schemes:2: convection: divergence is of periodic"));
    EXPECT_THAT(refused("viscous integratingFactor;"),
                StartsWith("system/schemes:2: viscous: integratingFactor is of"));
    EXPECT_THAT(refused("meanFlow exact;"), StartsWith("system/schemes:2: meanFlow: exact is of periodic boxes"));
    EXPECT_THAT(refused("dealiasing twoThirds;"), StartsWith("system/schemes:2: dealiasing: acts in periodic boxes"));
    EXPECT_THAT(refused("operators directSum;"), StartsWith("system/schemes:2: operators: directSum knows periodic"));
    EXPECT_THAT(refused("viscous CrankNicolson; continuation { extended yes; }"),
                StartsWith("system/schemes:2: viscous: CrankNicolson works line by line"));
    EXPECT_THAT(refusal(channel(65), kernel, "p { eigenvalues secondOrder; }"),
                StartsWith("system/solution:1: p.eigenvalues: secondOrder is of periodic boxes"));
    EXPECT_THAT(refusal(channel(65), kernel, "coupling { type incremental; }"),
                HasSubstr("write walls incremental; in system/schemes"));
}

TEST(SchemesOfALattice, RefuseWhatIsOfBoundedAxes)
{
    EXPECT_THAT(refusal(box(32), kernel + "viscous CrankNicolson;"),
                StartsWith("system/schemes:2: viscous: CrankNicolson is of bounded axes"));
    EXPECT_THAT(refusal(box(32), kernel, "p { solver direct; }"),
                StartsWith("system/solution:1: p.solver: direct is of bounded axes"));
    EXPECT_THAT(refusal(box(32), kernel + "walls papers;"), HasSubstr("known are: paper, "));
}

TEST(SchemesOfALattice, RefuseContinuationsThatDoNotFit)
{
    EXPECT_THAT(refusal(channel(17), kernel + "continuation\n{\n    type polynomial;\n    points 18;\n}"),
                StartsWith("system/schemes:5: continuation.points: needs 18 points at each end, but axis y has 17"));
    EXPECT_THAT(refusal(channel(17), kernel + "continuation { type smoothGram;\n extension 65; }"),
                StartsWith("system/schemes:3: continuation.extension: is 65 new points on axis y"));
    EXPECT_THAT(refusal(channel(4), kernel + "continuation { degree 4; }"),
                StartsWith("system/schemes:2: continuation.degree: needs 5 points at each end, but axis y has 4"));
    // The default has no line of its own.
    EXPECT_THAT(refusal(channel(4), kernel), HasSubstr("continuation.degree: needs 5 points at each end"));
}

TEST(Presets, AreTheSetUpsOfTheirPapers)
{
    for (const char* name : {"paper2021", "paper2026"})
    {
        const FlowSettings settings = read(channel(65), std::string("preset ") + name + ";");
        EXPECT_EQ(settings.kernel.kernel->order(), 4);
        EXPECT_EQ(settings.kernel.smoothingLength, 2);
        EXPECT_EQ(settings.kernel.supportRadius, 4);
        EXPECT_EQ(settings.kernel.symbol, KernelSettings::Symbol::sampled);
        EXPECT_EQ(settings.convection, ConvectionForm::advective);
        EXPECT_EQ(settings.time->order, 3);
        EXPECT_EQ(viscousTreatment(settings), ViscousTreatment::explicitTerm);
        EXPECT_EQ(settings.dealiasing, Dealiasing::none);
        EXPECT_EQ(settings.eigenvalues, Eigenvalues::exact);
        EXPECT_EQ(settings.walls, WallTreatment::paper);
        EXPECT_FALSE(settings.incremental);
        // Both are of periodic boxes, too.
        EXPECT_NO_THROW(read(box(65), std::string("preset ") + name + ";"));
    }
    EXPECT_EQ(read(channel(64, true), "preset paper2021;").continuation, "mirror");
    const FlowSettings paper2026 = read(channel(65), "preset paper2026;");
    EXPECT_EQ(paper2026.continuation, "polynomial, degree 5");
    EXPECT_EQ(paper2026.continuations[1]->newPoints(), 16);
    EXPECT_EQ(paper2026.continuations[1]->points(), 16);
    // Entries that follow override.
    const FlowSettings changed = read(channel(65), "preset paper2026; continuation { degree 6; } walls consistent;");
    EXPECT_EQ(changed.continuation, "polynomial, degree 6");
    EXPECT_EQ(changed.walls, WallTreatment::consistent);
}

TEST(Presets, AreNamedAsTheSourceOfTheirEntries)
{
    const Dictionary schemes = completedSchemes(Dictionary::parse("preset paper2026;", "system/schemes"), channel(65));
    EXPECT_EQ(schemes.find("walls")->origin().file, "preset paper2026");
    EXPECT_FALSE(schemes.find("walls")->isDefault);
    EXPECT_THAT(refusal(channel(65), "preset paper2025;"), HasSubstr("known are: "));
}

TEST(SceneDescription, OfAChannelSaysWhatItsAxesDo)
{
    const Fluid fluid{.nu = 0.01};
    const SceneDescription scene = describeScene(channel(65), fluid, read(channel(65), kernel));
    EXPECT_THAT(scene.active,
                Contains("continuation along y: smoothGram, degree 4, 5 points at each end, 31 new points "
                         "make a period of 96, fast"));
    EXPECT_THAT(scene.active, Contains("walls: consistent"));
    EXPECT_THAT(scene.leftOut, Contains("continuation along x (periodic)"));
    EXPECT_TRUE(scene.transformsOfLines);
}

TEST(SceneDescription, CountsLineTransforms)
{
    const auto count = [](const std::string& schemes, double nu, const std::string& solution = "")
    {
        const Fluid fluid{.nu = nu};
        const Lattice lattice = channel(65);
        return describeScene(lattice, fluid, read(lattice, kernel + schemes, solution, fluid)).transformsPerSubstep;
    };
    // Momentum 4 (1 + 2), divergence 4, pressure 4, its gradient 4, less the one that comes with the pressure.
    EXPECT_EQ(count("", 0.01), 23);
    EXPECT_EQ(count("", 0), 19);
    EXPECT_EQ(count("viscous CrankNicolson;", 0.01), 19);
    EXPECT_EQ(count("convection none;", 0), 11);
    EXPECT_EQ(count("", 0.01, "p { solver direct; }"), 20);
}

} // namespace
} // namespace isph
