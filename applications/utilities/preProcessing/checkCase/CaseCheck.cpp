#include "CaseCheck.hpp"

#include "continuation/LineSymbol.hpp"
#include "flow/flowMemory.hpp"
#include "flow/projectionRatio.hpp"
#include "flow/sceneSymbols.hpp"
#include "lattice/fastCounts.hpp"
#include "lattice/memoryEstimate.hpp"
#include "operators/continuedBounds.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numbers>

namespace isph
{

namespace
{

using Warnings = std::vector<std::string>;

void warnOfLattice(const Lattice& lattice, Warnings& warnings)
{
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const Axis& axis = lattice.activeAxis(d);
        if (!axis.periodic())
        {
            const long intervals = axis.staggered ? axis.count : axis.count - 1;
            if (isFastCount(intervals)) { continue; }
            warnings.push_back(fmt::format("transforms of {} intervals along {} are slow: {} and {} are the nearest "
                                           "fast ones",
                                           intervals, axis.name, smoothCountBelow(intervals),
                                           smoothCountAbove(intervals)));
            continue;
        }
        if (isFastCount(axis.count)) { continue; }
        warnings.push_back(
            fmt::format("transforms of length {} along {} are slow: {} and {} are the nearest fast counts", axis.count,
                        axis.name, fastCountBelow(axis.count), fastCountAbove(axis.count)));
    }
}

void warnOfContinuation(const Lattice& lattice, const Continuations& continuations, Warnings& warnings)
{
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const auto& continuation = continuations[static_cast<std::size_t>(lattice.direction(d))];
        if (!continuation) { continue; }
        const Axis& axis = lattice.activeAxis(d);
        const int length = axis.count + continuation->newPoints();
        if (isFastCount(length)) { continue; }
        warnings.push_back(fmt::format("transforms of {} points along {}, {} of them new, are slow: an extension of {} "
                                       "points makes them fast",
                                       length, axis.name, continuation->newPoints(),
                                       fastCountAbove(length) - axis.count));
    }
}

void warnOfKernel(const KernelResolution& kernel, Warnings& warnings)
{
    if (kernel.defect < 1e-3) { return; }
    warnings.push_back(
        fmt::format("the samples of the kernel leave an error of {:.2g} in the derivative of the longest "
                    "waves, which more points do not lower: take a larger supportRadius or "
                    "smoothingLength, renormalise yes; or symbol closed;",
                    kernel.defect));
}

void warnOfOperators(const OperatorBounds& bounds, const Fluid& fluid, bool bounded, Warnings& warnings)
{
    // Round-off of a transformed kernel is far below this.
    if (bounds.leastLaplacian >= -1e-9 * bounds.laplacian) { return; }
    if (bounded)
    {
        warnings.push_back(fmt::format("the Laplacian of the continued lines is anti-diffusive for some modes at the "
                                       "walls: viscosity makes them grow, at up to {:.3g} 1/s: take continuation "
                                       "smoothGram, or polynomials through more points",
                                       -fluid.nu * bounds.leastLaplacian));
        return;
    }
    warnings.push_back(
        fmt::format("the sampled Laplacian is anti-diffusive for some waves: viscosity makes them grow, at "
                    "up to {:.3g} 1/s (damping reaches {:.3g} 1/s): take laplacian morris;",
                    -fluid.nu * bounds.leastLaplacian, fluid.nu * bounds.laplacian));
}

/// A mode at the walls that a derivative does not turn but magnifies, which the projection then feeds.
void warnOfWallModes(const Lattice& lattice, const FlowSettings& settings, const OperatorBounds& bounds,
                     Warnings& warnings)
{
    constexpr double growing = 0.45; // of the Nyquist wavenumber: 0.41 was seen to be stable, 0.58 not
    constexpr double beyondWaves = 1.3;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const auto& continuation = settings.continuations[static_cast<std::size_t>(lattice.direction(d))];
        if (!continuation) { continue; }
        const Axis& axis = lattice.activeAxis(d);
        const auto waves = lineSymbol(settings.kernel, axis.count + continuation->newPoints(), axis.spacing()).first;
        const double nyquist = std::numbers::pi / axis.spacing();
        const double ofWaves = *std::max_element(waves.begin(), waves.end()) / nyquist;
        const double atWalls = bounds.derivative[static_cast<std::size_t>(d)] / nyquist;
        if (atWalls < growing || atWalls < beyondWaves * ofWaves) { continue; }
        warnings.push_back(
            fmt::format("the kernel smooths too much for the continuation along {}: its derivative is "
                        "{:.2g} of the Nyquist wavenumber for a mode at the walls, {:.2g} for waves, and "
                        "the projection makes such modes grow: take a lower degree or type mirror in "
                        "continuation, or a kernel of higher order or smaller smoothingLength",
                        axis.name, atWalls, ofWaves));
    }
}

void warnOfSteps(const StepForecast& steps, const TimeControl& control, Warnings& warnings)
{
    if (steps.step == 0)
    {
        warnings.push_back(
            fmt::format("the run starts at its endTime, {} s: there is nothing to do", control.settings().endTime));
        return;
    }
    if (steps.step <= steps.largestStable) { return; }
    warnings.push_back(fmt::format("{} {:.4g} s is {:.3g} times the largest stable step of the start, {:.4g} s (the {} "
                                   "term rules): the run may diverge; write deltaT auto; or at most {:.4g}",
                                   control.settings().deltaT ? "deltaT" : "the step of deltaT auto,", steps.step,
                                   steps.step / steps.largestStable, steps.largestStable, steps.ruling,
                                   0.8 * steps.largestStable));
}

/// A preset is of system/schemes; the step of its paper is for system/controlDict to keep.
void warnOfPreset(const Dictionary& schemes, const StepForecast& steps, Warnings& warnings)
{
    constexpr double ofPaper2021 = 0.1;
    const double courant = steps.step * steps.rates.courant;
    const bool asked = schemes.has("preset") && schemes.word("preset").text == "paper2021";
    if (!asked || courant <= 1.001 * ofPaper2021) { return; }
    warnings.push_back(fmt::format("the paper of preset paper2021 ran at Courant number {}, the first step has {:.3g}: "
                                   "write deltaT auto; and maxCo {}; in system/controlDict",
                                   ofPaper2021, courant, ofPaper2021));
}

} // namespace

CaseCheck checkCase(const std::filesystem::path& directory)
{
    CaseCheck check;
    check.reading = readWholeCase(directory);
    CaseReading& reading = check.reading;
    Warnings& warnings = reading.warnings;
    check.choices = schemeChoices(reading);
    if (!reading.lattice) { return check; }
    const Lattice& lattice = *reading.lattice;
    warnOfLattice(lattice, warnings);
    check.memory = solverMemory(lattice);
    if (!reading.settings) { return check; }

    const FlowSettings& settings = *reading.settings;
    const Fluid& fluid = *reading.fluid;
    check.scene = reading.scalar ? reading.transport : describeScene(lattice, fluid, settings);
    check.memory = reading.scalar ? reading.memory : flowMemory(lattice, fluid, settings);
    warnOfContinuation(lattice, settings.continuations, warnings);
    if (auto caution = mirrorCaution(lattice, settings); !reading.scalar && !caution.empty())
    {
        warnings.push_back(std::move(caution));
    }
    try
    {
        const bool viscous = fluid.nu > 0;
        check.kernel =
            kernelResolution(lattice, settings.kernel, viscous ? std::optional(settings.laplacian) : std::nullopt);
        warnOfKernel(*check.kernel, warnings);
        if (!reading.control || !reading.velocity) { return check; }
        const OperatorBounds bounds =
            reading.scalar ? continuedBounds(lattice, settings.continuations, settings.kernel, settings.laplacian)
                           : boundsOf(lattice, fluid, settings);
        check.steps = forecastSteps(lattice, fluid, settings, bounds, *reading.control, *reading.velocity);
        warnOfOperators(check.steps->bounds, fluid, !lattice.periodic(), warnings);
        warnOfWallModes(lattice, settings, check.steps->bounds, warnings);
        warnOfSteps(*check.steps, *reading.control, warnings);
        warnOfPreset(*reading.schemes, *check.steps, warnings);
    }
    catch (const Error& error)
    {
        reading.slips.insert(reading.slips.end(), error.complaints().begin(), error.complaints().end());
    }
    return check;
}

} // namespace isph
