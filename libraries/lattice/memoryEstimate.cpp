#include "lattice/memoryEstimate.hpp"

#include "core/Error.hpp"

#include <array>
#include <fmt/format.h>
#include <unistd.h>

namespace isph
{

SolverStorage periodicSolverStorage(int dimensions)
{
    SolverStorage storage;
    storage.dimensions = dimensions;
    storage.products = dimensions * (dimensions + 1) / 2 - 1;
    return storage;
}

SolverStorage boundedSolverStorage(int dimensions)
{
    // Everything is at the points: the velocity, the one before, two rates; in the file the velocity twice, and p.
    SolverStorage storage;
    storage.dimensions = dimensions;
    storage.spectralVectors = 0;
    storage.realVectors = 5;
    storage.products = 0;
    storage.spectralScalars = 0;
    storage.realScalars = 10; // pressure, its correction and source, their modes, a gradient; U and p in the file
    storage.tables = 0;
    return storage;
}

double solverMemory(double points, double modes, const SolverStorage& storage)
{
    const int spectral = storage.spectralVectors * storage.dimensions + storage.products + storage.spectralScalars;
    const int real = storage.realVectors * storage.dimensions + storage.products + storage.realScalars;
    return programMemory + 8.0 * (points * real + modes * (2 * spectral + storage.tables));
}

double solverMemory(const Lattice& lattice, const SolverStorage& storage)
{
    double points = 1;
    double modes = 1;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const int n = lattice.activeAxis(d).count;
        points *= n;
        modes *= d == 0 ? n / 2 + 1 : n;
    }
    return solverMemory(points, modes, storage);
}

double solverMemory(const Lattice& lattice)
{
    const int dimensions = lattice.dimensions();
    return solverMemory(lattice,
                        lattice.periodic() ? periodicSolverStorage(dimensions) : boundedSolverStorage(dimensions));
}

double machineMemory()
{
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

std::string memoryText(double bytes)
{
    constexpr std::array<const char*, 7> units{"bytes", "kB", "MB", "GB", "TB", "PB", "EB"};
    std::size_t unit = 0;
    while (bytes >= 999.5 && unit + 1 < units.size())
    {
        bytes /= 1000;
        ++unit;
    }
    return fmt::format("{:.3g} {}", bytes, units[unit]);
}

void requireMemory(double needed, double available, const Origin& origin)
{
    if (needed <= available) { return; }
    throw Error(Fault::input, origin,
                fmt::format("memory refused before allocation: the solver needs {} but this machine has {}",
                            memoryText(needed), memoryText(available)),
                "take fewer points, or a machine with more memory");
}

} // namespace isph
