// leaveOut: what scenes cost that ask for nothing they can do without, beside the same scenes with everything switched
// on, and beside a step written out by hand for each of them.
//
//     OMP_NUM_THREADS=1 build/tests/leaveOut
//     OMP_NUM_THREADS=1 build/tests/leaveOut channel          # one scene
//
// Prints Markdown. Seconds are processor time of one step, the least of many taken in turn; memory is what isphFoam
// reports, writing included, of a large lattice less that of a small one; instructions are callgrind's (valgrind), of
// steps on a smaller lattice with transforms planned by estimate.

#include "measures.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fmt/format.h>
#include <memory>
#include <string>

using namespace isph::test;

namespace
{

/// The shared libraries that a program asks for itself, but those of the compiler and the C library.
std::string librariesOf(const std::filesystem::path& program)
{
    const std::string command =
        "readelf -d '" + program.string() +
        "' | sed -n 's/.*NEEDED.*\\[lib\\(.*\\)\\.so.*/\\1/p' | grep -Evx 'c|m|gcc_s|stdc\\+\\+|gomp' | sort";
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::string names;
    std::array<char, 256> part{};
    while (std::fgets(part.data(), static_cast<int>(part.size()), pipe.get()) != nullptr)
    {
        std::string name(part.data());
        name.pop_back();
        names += (names.empty() ? "" : ", ") + name;
    }
    return names;
}

std::string percent(double ratio) { return fmt::format("{:+.1f} %", 100 * (ratio - 1)); }

} // namespace

int main(int argc, char** argv)
{
    const std::filesystem::path self = std::filesystem::canonical("/proc/self/exe");
    const std::filesystem::path programs = self.parent_path().parent_path() / "bin";
    std::vector<SceneOnTrial> scenes = scenesOnTrial();
    if (argc == 6 && std::string(argv[1]) == "-march")
    {
        march(*std::ranges::find(scenes, argv[2], &SceneOnTrial::name), std::stoi(argv[3]), argv[4],
              std::stoi(argv[5]));
        return 0;
    }
    if (argc > 1)
    {
        std::erase_if(scenes, [&](const SceneOnTrial& scene) { return scene.name != argv[1]; });
        if (scenes.empty())
        {
            fmt::print(stderr, "leaveOut: there is no scene {}\n", argv[1]);
            return 2;
        }
    }

    fmt::print(
        "{}",
        R"~(Each scene is run twice: alone, with nothing that it can do without, and with everything switched on: a force that
changes in time, a filter, the old pressure in the predictor; in periodic boxes viscosity, a mean flow, dealiasing; between
walls transforms of the whole extended box; and five functions at every step. Seconds are processor time of a step, the
least of many taken in turn. Bytes are the peak memory of isphFoam, writing included, on a large lattice less that on a
small one; checkCase's estimate is without functions.

)~");
    fmt::print("isphFoam loads, beside the libraries of the compiler: {}.\n\n", librariesOf(programs / "isphFoam"));
    fmt::print("| scene | lattice | transforms per substep: alone; everything | ns per point and substep | bytes per "
               "point | checkCase says |\n| --- | --- | --- | --- | --- | --- |\n");
    constexpr int substeps = 3;
    std::vector<StepSeconds> seconds;
    for (const SceneOnTrial& scene : scenes)
    {
        const StepSeconds steps = seconds.emplace_back(secondsOfSteps(scene, 40));
        const ProgramReport alone = reportOf(programs, scene, Load::alone);
        const ProgramReport everything = reportOf(programs, scene, Load::everything);
        double points = 1;
        for (int d = 0; d < scene.dimensions; ++d) { points *= scene.points; }
        const auto nanoseconds = [&](double step) { return 1e9 * step / (points * substeps); };
        fmt::print("| {} | {}^{} | {:.3g}; {:.3g} | {:.1f}; {:.1f} | {:.0f}; {:.0f} | {:.0f}; {:.0f} |\n", scene.name,
                   scene.points, scene.dimensions, alone.transformsPerSubstep, everything.transformsPerSubstep,
                   nanoseconds(steps.alone), nanoseconds(steps.everything), alone.bytesPerPoint,
                   everything.bytesPerPoint, estimatedBytesPerPoint(scene, Load::alone),
                   estimatedBytesPerPoint(scene, Load::everything));
        std::fflush(stdout);
    }

    fmt::print("{}", R"~(
A step of the scene alone, over one written out by hand for this scene: no setting, no choice, one loop over the modes or
plain loops over the points, with the suite's transforms, derivatives along lines, pressure solver and rates that choose the
step. Both end in the same velocity. Instructions are those callgrind counts, on half as many points an axis.

| scene | processor time | instructions | bytes held |
| --- | --- | --- | --- |
)~");
    for (std::size_t i = 0; i < scenes.size(); ++i)
    {
        const SceneOnTrial& scene = scenes[i];
        const int points = scene.points / 2;
        const auto suite = instructionsOfStep(self, scene, points, "suite");
        const auto plain = instructionsOfStep(self, scene, points, "plain");
        const HeldBytes bytes = heldBytes(scene, scene.points);
        fmt::print("| {} | {} | {} | {} |\n", scene.name, percent(seconds[i].alone / seconds[i].plain),
                   suite && plain ? percent(*suite / *plain) : "no valgrind", percent(bytes.suite / bytes.plain));
        std::fflush(stdout);
    }
}
