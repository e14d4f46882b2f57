#include "flow/flowMemory.hpp"

#include "flow/Convection.hpp"
#include "flow/IteratedPressure.hpp"
#include "lattice/memoryEstimate.hpp"
#include "neighbours/LatticeStencil.hpp"

#include <algorithm>
#include <cmath>

namespace isph
{

namespace
{

/// Values and coordinates.
bool needsForceField(const Fluid& fluid) { return fluid.bodyForce && !fluid.bodyForce->uniform(); }

SolverStorage spectralStorage(int dimensions, const Fluid& fluid, const FlowSettings& settings)
{
    SolverStorage storage = periodicSolverStorage(dimensions);
    const auto convection =
        makeConvection(settings.convection, dimensions, settings.eigenvalues == Eigenvalues::consistent);
    const int inputs = convection ? convection->inputs() : 0;
    storage.products = convection ? convection->products() : 0;
    storage.spectralScalars += inputs - dimensions;                // a vector of inputs is in the defaults
    storage.realScalars += std::max(inputs - storage.products, 0); // inputs and products share their place
    if (needsForceField(fluid))
    {
        ++storage.spectralVectors;
        ++storage.realVectors;
        storage.realScalars += 3;
    }
    if (settings.incremental) { storage.spectralScalars += 3; } // now, before the step, in the file
    if (settings.iteration)
    {
        ++storage.spectralScalars;
        storage.realScalars += 2; // source and solution
    }

    const bool sampled = settings.kernel.symbol == KernelSettings::Symbol::sampled;
    const int symbols = sampled ? dimensions : settings.kernel.exact() ? 0 : 1;
    const auto substeps = static_cast<int>(settings.time->substeps.size());
    const int viscous = fluid.nu == 0 ? 0 : settings.integratingFactor ? 1 + substeps : 1;
    storage.tables = symbols + viscous + 1;
    return storage;
}

SolverStorage physicalStorage(int dimensions, const Fluid& fluid, const FlowSettings& settings)
{
    // Velocity, the one before, two rates, a gradient, perhaps Laplacian and force; the velocity once more in the file.
    SolverStorage storage;
    storage.dimensions = dimensions;
    storage.spectralVectors = 0;
    storage.realVectors = 6 + (fluid.nu > 0 ? 1 : 0) + (fluid.bodyForce ? 1 : 0);
    storage.products = 1;
    storage.spectralScalars = 3; // of the pressure equation and of the written pressure; a product's share is above
    storage.realScalars = 9 + (settings.incremental ? 3 : 0);
    storage.tables = dimensions + 1;
    return storage;
}

SolverStorage boundedStorage(int dimensions, const Fluid& fluid, const FlowSettings& settings)
{
    SolverStorage storage = boundedSolverStorage(dimensions);
    ++storage.realScalars; // the pressure's slope along a periodic axis
    if (needsForceField(fluid))
    {
        ++storage.realVectors;
        storage.realScalars += 3;
    }
    const bool oldPressure = settings.walls == WallTreatment::incremental ||
                             settings.walls == WallTreatment::rotational || settings.walls == WallTreatment::slip;
    if (oldPressure) { storage.realScalars += 3; } // now, before the step, in the file
    if (settings.crankNicolson || settings.automaticViscous) { storage.realScalars += 2; }
    return storage;
}

/// Dense matrices of the eigenbases along each axis, and back [bytes].
double eigenbases(const Lattice& lattice)
{
    double entries = 0;
    for (int d = 0; d < lattice.dimensions(); ++d) { entries += 2 * std::pow(lattice.activeAxis(d).count, 2); }
    return 8 * entries;
}

/// The extended box: a field continued axis by axis, its modes and theirs times a symbol, a derivative [bytes].
double extendedBoxes(const Lattice& lattice, const FlowSettings& settings)
{
    double points = 1;
    double arrays = 3;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const auto& continuation = settings.continuations[static_cast<std::size_t>(lattice.direction(d))];
        points *= lattice.activeAxis(d).count + (continuation ? continuation->newPoints() : 0);
        if (continuation) { ++arrays; }
    }
    return 8 * arrays * points;
}

/// The matrix of the pressure and what iterates on it, or the table by modes that stands for it [bytes].
double morrisMemory(const Lattice& lattice, const FlowSettings& settings)
{
    const KernelSettings& kernel = settings.kernel;
    const bool table = settings.eigenvalues == Eigenvalues::morris && !lattice.periodic() && !settings.directPressure;
    if (!settings.iteration && !table) { return 0; }
    const std::size_t neighbours = latticeStencil(lattice, kernel.smoothingLength, kernel.supportRadius).size();
    if (settings.iteration) { return iterationMemory(lattice, neighbours, settings.iteration->solver, *settings.time); }
    return 24 * static_cast<double>(lattice.points()) + mirrorDataBytes(lattice, neighbours);
}

} // namespace

double flowMemory(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings)
{
    const int dimensions = lattice.dimensions();
    if (!lattice.periodic())
    {
        const bool dense = settings.crankNicolson || settings.automaticViscous || settings.directPressure;
        return solverMemory(lattice, boundedStorage(dimensions, fluid, settings)) + (dense ? eigenbases(lattice) : 0) +
               (settings.extended ? extendedBoxes(lattice, settings) : 0) + morrisMemory(lattice, settings);
    }
    return solverMemory(lattice, settings.directSum ? physicalStorage(dimensions, fluid, settings)
                                                    : spectralStorage(dimensions, fluid, settings)) +
           morrisMemory(lattice, settings);
}

} // namespace isph
