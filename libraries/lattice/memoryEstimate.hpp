#pragma once

#include "core/Origin.hpp"
#include "lattice/Lattice.hpp"

#include <string>

namespace isph
{

/// What a solver keeps for every point and every mode at the time it needs most, which is when it writes: in numbers of
/// arrays.
///
/// A mode array has (n/2 + 1) complex coefficients along the first active axis. The defaults are those of the periodic
/// solver; the traceless products of the velocity (2 in two dimensions, 5 in three) stand for the convective term. The
/// file is put together in memory before it is written.
struct SolverStorage
{
    int dimensions = 2;
    int spectralVectors = 5; ///< velocity, the one before, its rate, inputs of the convective term; and in the file
    int realVectors = 1;     ///< the velocity at the points
    int products = 2;        ///< products of velocity components, at the points and as modes
    int spectralScalars = 3; ///< of the written pressure and of the divergence
    int realScalars = 7;     ///< pressure, its stress, divergence; in the file three components and the pressure
    int tables = 6;          ///< real factors per mode: symbol, viscous operator, its three factors, inverse Laplacian
};

/// The storage of the periodic solver in two or three dimensions.
SolverStorage periodicSolverStorage(int dimensions);

/// The storage of the solver of boxes with bounded axes.
SolverStorage boundedSolverStorage(int dimensions);

/// What a program needs before it has a single point [bytes].
inline constexpr double programMemory = 20e6;

/// Memory of such a solver [bytes], without its functions; a floating-point number, so that nothing overflows.
/// \param points of the lattice
/// \param modes complex coefficients of one component
double solverMemory(double points, double modes, const SolverStorage& storage);

/// Memory of a solver with this storage, or with that of the solver for such a lattice [bytes].
double solverMemory(const Lattice& lattice, const SolverStorage& storage);
double solverMemory(const Lattice& lattice);

/// Memory of this machine [bytes].
double machineMemory();

/// "1.5 GB": bytes in the largest decimal unit that leaves at least 1.
std::string memoryText(double bytes);

/// \throws Error(input) at origin, giving both sizes, if more is needed than there is: before anything is allocated.
void requireMemory(double needed, double available, const Origin& origin);

} // namespace isph
