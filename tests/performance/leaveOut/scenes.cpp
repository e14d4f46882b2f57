#include "scenes.hpp"

#include "case/Case.hpp"
#include "core/writeTextFile.hpp"
#include "lattice/readLattice.hpp"

#include <fmt/format.h>

namespace isph::test
{

namespace
{

constexpr double deltaT = 2e-4;

std::string latticeDict(const SceneOnTrial& scene, int points)
{
    // Bounded axes come last.
    const auto periodic = static_cast<std::size_t>(scene.dimensions - scene.boundedAxes);
    std::string extent;
    std::string intervals;
    std::string patches;
    for (std::size_t d = 0; d < 3; ++d)
    {
        const char axis = "xyz"[d];
        const bool active = static_cast<int>(d) < scene.dimensions;
        extent += active ? "1 " : "0 ";
        intervals += fmt::format("{} ", active ? points : 0);
        if (!active) { continue; }
        if (d < periodic) { patches += fmt::format("{0}Sides {{ type periodic; axis {0}; }}\n", axis); }
        else
        {
            patches +=
                fmt::format("{0}Low {{ type wall; face {0}Min; }}\n{0}High {{ type wall; face {0}Max; }}\n", axis);
        }
    }
    return fmt::format("origin (0 0 0);\nextent ({});\nintervals ({});\npatches\n{{\n{}}}\n", extent, intervals,
                       patches);
}

/// The boundary conditions of U or p.
std::string boundaryField(const SceneOnTrial& scene, bool velocity)
{
    std::string text = "boundaryField\n{\n    \".*Sides\" { type periodic; }\n";
    if (scene.boundedAxes > 0)
    {
        text += velocity ? "    \".*(Low|High)\" { type noSlip; }\n" : "    \".*(Low|High)\" { type zeroGradient; }\n";
    }
    // The lid of the cavity.
    if (scene.boundedAxes == 2 && velocity) { text += "    yHigh { type fixedValue; value uniform (1 0 0); }\n"; }
    return text + "}\n";
}

/// A flow of several modes; between walls one that is at rest on them.
std::string velocity(const SceneOnTrial& scene, Load load)
{
    if (scene.boundedAxes == 2) { return "uniform (0 0 0)"; }
    if (scene.boundedAxes == 1) { return "expression (\"4*y*(1 - y) + 0.1*sin(pi*y)^2*sin(2*pi*x)\" \"0\" \"0\")"; }
    const char* mean = load == Load::everything ? "0.3 + " : "";
    if (scene.dimensions == 2)
    {
        return fmt::format("expression (\"{0}sin(2*pi*y) + 0.3*cos(6*pi*y)*sin(4*pi*x)\" \"{0}cos(2*pi*x)\" \"0\")",
                           mean);
    }
    return fmt::format("expression (\"{0}sin(2*pi*z) + cos(2*pi*y)\" \"{0}sin(2*pi*x) + 0.3*cos(4*pi*z)\" "
                       "\"{0}sin(2*pi*y) + cos(2*pi*x)\")",
                       mean);
}

std::string schemes(const SceneOnTrial& scene, Load load)
{
    const bool bounded = scene.boundedAxes > 0;
    if (bounded)
    {
        std::string text = "kernel { type gaussian; order 20; }\ntime RK3;\n";
        return load == Load::alone
                   ? text
                   : text + "walls incremental;\nfilter { type exponential; }\ncontinuation { extended yes; }\n";
    }
    std::string text = "kernel { type gaussian; order 10; }\ntime RK3;\n";
    return load == Load::alone ? text + "meanFlow none;\ndealiasing none;\n"
                               : text + "meanFlow exact;\ndealiasing twoThirds;\nfilter { type exponential; }\n";
}

std::string solution(const SceneOnTrial& scene, Load load)
{
    if (load == Load::alone) { return "p { solver fft; }\n"; }
    return scene.boundedAxes > 0 ? "p { solver fft; }\n" : "p { solver fft; }\ncoupling { type incremental; }\n";
}

std::string functions(Load load)
{
    if (load == Load::alone) { return ""; }
    return R"~(functions
{
    errors { type errorNorms; exact { U expression ("sin(y)" "0" "0"); p expression "0"; } }
    flow { type flowStatistics; }
    points { type probes; probeLocations ((0.3 0.4 0)); fields (U p); }
    means { type fieldAverage; fields (U p); prime2Mean yes; writeControl onEnd; }
    costs { type timing; }
}
)~";
}

} // namespace

const std::vector<SceneOnTrial>& scenesOnTrial()
{
    static const std::vector<SceneOnTrial> scenes{
        {.name = "periodic2DInviscid", .dimensions = 2, .viscous = false, .boundedAxes = 0, .points = 256, .few = 48},
        {.name = "periodic2DViscous", .dimensions = 2, .viscous = true, .boundedAxes = 0, .points = 256, .few = 48},
        {.name = "channel", .dimensions = 2, .viscous = true, .boundedAxes = 1, .points = 256, .few = 48},
        {.name = "cavity", .dimensions = 2, .viscous = true, .boundedAxes = 2, .points = 256, .few = 48},
        {.name = "periodic3D", .dimensions = 3, .viscous = true, .boundedAxes = 0, .points = 64, .few = 16},
    };
    return scenes;
}

void writeScene(const std::filesystem::path& folder, const SceneOnTrial& scene, Load load, int points, int steps)
{
    const auto write = [&folder](const char* name, const std::string& text)
    {
        std::filesystem::create_directories((folder / name).parent_path());
        writeTextFile(folder / name, text);
    };
    const bool everything = load == Load::everything;
    write("system/latticeDict", latticeDict(scene, points));
    std::string fluid = fmt::format("nu {};\n", scene.viscous || everything ? 1e-4 : 0);
    if (everything) { fluid += "bodyForce expression (\"sin(2*pi*y)*cos(t)\" \"0\" \"0\");\n"; }
    else if (scene.boundedAxes == 1) { fluid += "bodyForce uniform (0.1 0 0);\n"; } // what drives a channel
    write("constant/transportProperties", fluid);
    write("system/schemes", schemes(scene, load));
    write("system/solution", solution(scene, load));
    write("system/controlDict", fmt::format("startFrom startTime;\nstartTime 0;\nendTime {:.17g};\ndeltaT {};\n{}",
                                            steps * deltaT, deltaT, functions(load)));
    write("0/U", fmt::format("dimensions [0 1 -1 0 0 0 0];\ninternalField {};\n{}", velocity(scene, load),
                             boundaryField(scene, true)));
    write("0/p", "dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 0;\n" + boundaryField(scene, false));
    const Case written(folder);
    write("constant/lattice", latticeText(makeLattice(written.dictionary("system/latticeDict"))));
}

} // namespace isph::test
