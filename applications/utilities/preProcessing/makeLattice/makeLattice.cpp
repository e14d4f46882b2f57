// makeLattice: constant/lattice from system/latticeDict.
//
//     makeLattice -case cavity              checks the dictionary, writes constant/lattice, reports what it makes
//     makeLattice -case cavity -overwrite   replaces the lattice that is there

#include "case/Case.hpp"
#include "core/runApplication.hpp"
#include "core/writeTextFile.hpp"
#include "lattice/fastCounts.hpp"
#include "lattice/memoryEstimate.hpp"
#include "lattice/readLattice.hpp"

#include <fmt/format.h>
#include <string>

using namespace isph;

/// Between walls two transforms are made: of the intervals for the pressure, and of the points with the new ones that
/// make them periodic for derivatives.
static std::string transformText(const Axis& axis)
{
    if (!axis.periodic())
    {
        const long intervals = axis.staggered ? axis.count : axis.count - 1;
        const long length = continuedCount(axis.count);
        const std::string derivatives =
            fmt::format("derivatives {} points and {} new ones make {}, fast", axis.count, length - axis.count, length);
        if (isSmoothCount(intervals)) { return fmt::format("pressure {} intervals, fast; {}", intervals, derivatives); }
        return fmt::format("pressure {} intervals, slow: {} and {} are the nearest fast ones; {}", intervals,
                           smoothCountBelow(intervals), smoothCountAbove(intervals), derivatives);
    }
    if (isFastCount(axis.count)) { return fmt::format("length {}, fast", axis.count); }
    return fmt::format("length {}, slow: {} and {} are the nearest fast counts", axis.count, fastCountBelow(axis.count),
                       fastCountAbove(axis.count));
}

static void report(const Lattice& lattice, double memory, Log& log)
{
    log.line(fmt::format("Lattice of {} points in {} dimensions", lattice.points(), lattice.dimensions()));
    for (int direction = 0; direction < 3; ++direction)
    {
        const Axis& axis = lattice.axis(direction);
        if (!axis.active())
        {
            log.line(fmt::format("    {}  left out", axis.name));
            continue;
        }
        log.line(fmt::format("    {}  {} points from {} to {} m, spacing {} m, {}{}", axis.name, axis.count,
                             axis.origin, axis.origin + axis.extent, axis.spacing(), toString(axis),
                             axis.staggered ? ", half a spacing inside" : ""));
    }
    for (const Patch& patch : lattice.patches())
    {
        log.line(fmt::format("Patch {} ({}): {}", patch.name, toString(patch.type), fmt::join(patch.faces, " ")));
    }
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        log.line(
            fmt::format("Transform along {}: {}", lattice.activeAxis(d).name, transformText(lattice.activeAxis(d))));
    }
    log.line(
        fmt::format("Memory the solver will need: about {} of {}", memoryText(memory), memoryText(machineMemory())));
}

static void run(const CommandLine& line, Log& log)
{
    const Case theCase(line.caseDirectory());
    if (theCase.has("constant/lattice") && !line.has("overwrite"))
    {
        throw Error(Fault::input, {"constant/lattice", 0, ""}, "is there already",
                    "makeLattice -overwrite replaces it");
    }
    const Dictionary latticeDict = theCase.dictionary("system/latticeDict");
    const Lattice lattice = makeLattice(latticeDict);
    const double memory = solverMemory(lattice);
    requireMemory(memory, machineMemory(), latticeDict.origin());

    writeTextFile(theCase.path("constant/lattice"), latticeText(lattice));
    report(lattice, memory, log);
    log.line("Wrote constant/lattice");
}

int main(int argc, char** argv)
{
    const Application application{.name = "makeLattice",
                                  .summary = "writes constant/lattice from system/latticeDict",
                                  .examples = "makeLattice -case cavity\nmakeLattice -case cavity -overwrite",
                                  .options = {{"overwrite", "", "replace an existing constant/lattice"}}};
    return runApplication(application, argc, argv, run);
}
