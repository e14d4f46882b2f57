// What leaveOut prints, as far as it is the same on every machine.

#include "measures.hpp"

#include <gtest/gtest.h>
#include <map>
#include <string>

using namespace isph::test;

/// The steps written out by hand are those of the suite, or comparing their cost would mean nothing.
TEST(LeaveOut, thePlainStepsAreTheSame)
{
    for (const SceneOnTrial& scene : scenesOnTrial())
    {
        EXPECT_LE(differenceAfter(scene, scene.few, 5), 1e-12) << scene.name;
    }
}

TEST(LeaveOut, noMemoryForWhatIsNotUsed)
{
    for (const SceneOnTrial& scene : scenesOnTrial())
    {
        const HeldBytes bytes = heldBytes(scene, scene.points / 2);
        EXPECT_LE(bytes.suite, 1.03 * bytes.plain) << scene.name;
        EXPECT_GE(bytes.suite, 0.9 * bytes.plain) << scene.name << ": the plain step is none";
    }
}

TEST(LeaveOut, noInstructionsForWhatIsNotUsed)
{
    const std::filesystem::path program = std::filesystem::canonical("/proc/self/exe").parent_path() / "leaveOut";
    for (const SceneOnTrial& scene : scenesOnTrial())
    {
        const auto suite = instructionsOfStep(program, scene, scene.points / 2, "suite");
        const auto plain = instructionsOfStep(program, scene, scene.points / 2, "plain");
        if (!suite || !plain) { GTEST_SKIP() << "there is no valgrind"; }
        EXPECT_LE(*suite, 1.03 * *plain) << scene.name;
        EXPECT_GE(*suite, 0.9 * *plain) << scene.name << ": the plain step is none";
    }
}

/// Sets of line transforms between walls, transforms of a component elsewhere.
TEST(LeaveOut, transformsPerSubstep)
{
    const std::filesystem::path programs =
        std::filesystem::canonical("/proc/self/exe").parent_path().parent_path() / "bin";
    const std::map<std::string, double> expected{
        {"periodic2DInviscid", 4}, {"periodic2DViscous", 4}, {"channel", 23}, {"cavity", 24}, {"periodic3D", 8}};
    for (SceneOnTrial scene : scenesOnTrial())
    {
        scene.points = 2 * scene.few;
        const ProgramReport report = reportOf(programs, scene, Load::alone);
        EXPECT_DOUBLE_EQ(report.transformsPerSubstep, expected.at(scene.name)) << scene.name;
        EXPECT_LE(report.bytesPerPoint, 1.25 * estimatedBytesPerPoint(scene, Load::alone)) << scene.name;
        EXPECT_GE(report.bytesPerPoint, 0.75 * estimatedBytesPerPoint(scene, Load::alone)) << scene.name;
    }
}
