#pragma once

#include "scenes.hpp"

#include <filesystem>
#include <optional>

namespace isph::test
{

/// Seconds of processor time of one step, the least of many, taken in turn.
struct StepSeconds
{
    double alone;
    double everything;
    double plain;
};
StepSeconds secondsOfSteps(const SceneOnTrial& scene, int rounds);

/// What isphFoam reports of a run of a few steps.
struct ProgramReport
{
    double transformsPerSubstep;
    double bytesPerPoint; ///< its peak memory less that of the same scene on few points
};
/// \param programs folder of isphFoam \throws std::runtime_error where it fails
ProgramReport reportOf(const std::filesystem::path& programs, const SceneOnTrial& scene, Load load);

/// What checkCase says isphFoam will need, less what it needs without points [bytes a point].
double estimatedBytesPerPoint(const SceneOnTrial& scene, Load load);

/// Bytes held by the flow of a scene that asks for nothing, after a step, and by the plain step.
struct HeldBytes
{
    double suite;
    double plain;
};
HeldBytes heldBytes(const SceneOnTrial& scene, int points);

/// Steps with transforms planned by estimate: what countedInstructions runs. \param which suite or plain
void march(const SceneOnTrial& scene, int points, const std::string& which, int steps);

/// Instructions of a step as callgrind counts them, the same every time; nothing without valgrind.
/// \param self a program whose arguments -march NAME POINTS WHICH STEPS call march
std::optional<double> instructionsOfStep(const std::filesystem::path& self, const SceneOnTrial& scene, int points,
                                         const std::string& which);

/// Largest difference between the velocities of the suite's and the plain step after some steps, of the largest speed.
double differenceAfter(const SceneOnTrial& scene, int points, int steps);

} // namespace isph::test
