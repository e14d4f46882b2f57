#include "measures.hpp"

#include "flow/flowMemory.hpp"
#include "lattice/memoryEstimate.hpp"
#include "PlainStep.hpp"
#include "SceneRun.hpp"
#include "support/processorSecondsOf.hpp"
#include "support/TemporaryFolder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <malloc.h>
#include <memory>
#include <stdexcept>
#include <string>

namespace isph::test
{

namespace
{

constexpr double dt = 2e-4; // of scenes.cpp
constexpr int forever = 1000000;

double heapBytes()
{
    const struct mallinfo2 heap = mallinfo2();
    return static_cast<double>(heap.uordblks) + static_cast<double>(heap.hblkhd);
}

std::unique_ptr<PlainStep> plainStep(const SceneOnTrial& scene, const Scene& read, const RealField& start,
                                     PlanEffort effort)
{
    return scene.boundedAxes == 0 ? plainPeriodic(read, start, effort) : plainBounded(read, start, effort);
}

/// What a command prints. \throws std::runtime_error where it fails
std::string outputOf(const std::string& command)
{
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((command + " 2>&1").c_str(), "r"), [](FILE*) { return 0; });
    std::string output;
    std::array<char, 4096> part{};
    while (std::fgets(part.data(), static_cast<int>(part.size()), pipe.get()) != nullptr) { output += part.data(); }
    if (pclose(pipe.get()) != 0) { throw std::runtime_error(command + ": " + output); }
    return output;
}

/// The number after a word of a text.
double numberAfter(const std::string& text, const std::string& word)
{
    const std::size_t place = text.find(word);
    if (place == std::string::npos) { throw std::runtime_error("there is no " + word + " in\n" + text); }
    return std::stod(text.substr(text.find_first_of("0123456789", place + word.size())));
}

struct PeakAndTransforms
{
    double bytes;
    double points;
    double transforms;
};

PeakAndTransforms runProgram(const std::filesystem::path& programs, const SceneOnTrial& scene, Load load, int points)
{
    const TemporaryFolder folder;
    writeScene(folder.path(), scene, load, points, 4);
    outputOf((programs / "isphFoam").string() + " -case " + folder.path().string());
    const std::string report = folder.textOf("postProcessing/report.json");
    const Scene read(Case(folder.path()), "0");
    return {numberAfter(report, "\"peakMemory\""), static_cast<double>(read.lattice.points()),
            numberAfter(report, "\"transformsPerSubstep\"")};
}

} // namespace

StepSeconds secondsOfSteps(const SceneOnTrial& scene, int rounds)
{
    const TemporaryFolder alone;
    const TemporaryFolder everything;
    writeScene(alone.path(), scene, Load::alone, scene.points, forever);
    writeScene(everything.path(), scene, Load::everything, scene.points, forever);
    SceneRun light(alone.path(), PlanEffort::measured);
    SceneRun heavy(everything.path(), PlanEffort::measured);
    const auto plain = plainStep(scene, light.scene(), light.flow().velocity(), PlanEffort::measured);

    constexpr double never = std::numeric_limits<double>::infinity();
    StepSeconds least{never, never, never};
    const auto time = [](double& best, auto step) { best = std::min(best, processorSecondsOf(step)); };
    for (int round = 0; round < rounds; ++round)
    {
        for (int i = 0; i < 4; ++i)
        {
            time(least.alone, [&] { light.step(); });
            time(least.plain, [&] { plain->step(dt); });
        }
        if (round % 4 == 0)
        {
            time(least.everything, [&] { heavy.step(); });
        }
    }
    return least;
}

ProgramReport reportOf(const std::filesystem::path& programs, const SceneOnTrial& scene, Load load)
{
    const PeakAndTransforms many =
        runProgram(programs, scene, load, 4 * scene.points / (scene.dimensions == 3 ? 2 : 1));
    const PeakAndTransforms few = runProgram(programs, scene, load, scene.few);
    return {many.transforms, (many.bytes - few.bytes) / (many.points - few.points)};
}

double estimatedBytesPerPoint(const SceneOnTrial& scene, Load load)
{
    const TemporaryFolder folder;
    writeScene(folder.path(), scene, load, 4 * scene.points / (scene.dimensions == 3 ? 2 : 1), 1);
    const Scene read(Case(folder.path()), "0");
    return (flowMemory(read.lattice, read.fluid, read.settings) - programMemory) /
           static_cast<double>(read.lattice.points());
}

HeldBytes heldBytes(const SceneOnTrial& scene, int points)
{
    const TemporaryFolder folder;
    writeScene(folder.path(), scene, Load::alone, points, forever);
    const Case theCase(folder.path());
    Scene read(theCase, "0");
    Timings timings;
    HeldBytes held{};
    RealField start;
    {
        // Twice: FFTW keeps what it learned when it planned first.
        for (int time = 0; time < 2; ++time)
        {
            const double before = heapBytes();
            const auto flow = makeFlow(read, timings, PlanEffort::estimated);
            readFlow(theCase, "0", false, read, *flow);
            flow->rates();
            advance(*read.settings.time, *flow, 0, dt);
            flow->rates();
            held.suite = heapBytes() - before;
            if (time == 0) { start = copyOf(flow->velocity()); }
        }
    }
    for (int time = 0; time < 2; ++time)
    {
        const double before = heapBytes();
        const auto plain = plainStep(scene, read, start, PlanEffort::estimated);
        plain->step(dt);
        held.plain = heapBytes() - before;
    }
    return held;
}

void march(const SceneOnTrial& scene, int points, const std::string& which, int steps)
{
    const TemporaryFolder folder;
    writeScene(folder.path(), scene, Load::alone, points, forever);
    SceneRun run(folder.path(), PlanEffort::estimated);
    if (which == "suite")
    {
        for (int n = 0; n < steps; ++n) { run.step(); }
        return;
    }
    const auto plain = plainStep(scene, run.scene(), run.flow().velocity(), PlanEffort::estimated);
    for (int n = 0; n < steps; ++n) { plain->step(dt); }
}

std::optional<double> instructionsOfStep(const std::filesystem::path& self, const SceneOnTrial& scene, int points,
                                         const std::string& which)
{
    if (std::system("valgrind --version > /dev/null 2>&1") != 0) { return std::nullopt; }
    const auto instructions = [&](int steps)
    {
        // The same time in each, so that numbers read and written have the same digits.
        const std::string output = outputOf(
            "OMP_NUM_THREADS=1 valgrind --tool=callgrind --callgrind-out-file=/dev/null '" + self.string() +
            "' -march " + scene.name + " " + std::to_string(points) + " " + which + " " + std::to_string(steps));
        return numberAfter(output, "Collected :");
    };
    constexpr int few = 2;
    constexpr int many = 4;
    return (instructions(many) - instructions(few)) / (many - few);
}

double differenceAfter(const SceneOnTrial& scene, int points, int steps)
{
    const TemporaryFolder folder;
    writeScene(folder.path(), scene, Load::alone, points, forever);
    SceneRun run(folder.path(), PlanEffort::estimated);
    const auto plain = plainStep(scene, run.scene(), run.flow().velocity(), PlanEffort::estimated);
    for (int n = 0; n < steps; ++n)
    {
        run.step();
        plain->step(dt);
    }
    const RealField& suite = run.flow().velocity();
    const RealField other = plain->velocity();
    double largest = 0;
    double difference = 0;
    for (int c = 0; c < suite.components(); ++c)
    {
        for (std::size_t i = 0; i < suite.size(); ++i)
        {
            largest = std::max(largest, std::abs(suite[c][i]));
            difference = std::max(difference, std::abs(suite[c][i] - other[c][i]));
        }
    }
    return difference / largest;
}

} // namespace isph::test
