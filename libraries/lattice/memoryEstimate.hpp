#pragma once

#include "core/Origin.hpp"
#include "lattice/Lattice.hpp"

#include <string>

namespace isph
{

/// What a solver keeps for every point and every mode, in numbers of arrays.
///
/// A mode array has (n/2 + 1) complex coefficients along the first active axis. The defaults are those of the periodic
/// solver; the traceless products of the velocity (2 in two dimensions, 5 in three) stand for the convective term.
struct SolverStorage
{
    int dimensions = 2;
    int spectralVectors = 3; ///< the velocity that is marched, the previous rate, a working copy
    int realVectors = 1;     ///< the velocity at the points
    int products = 2;        ///< products of velocity components, at the points and as modes
    int spectralScalars = 1; ///< the pressure
    int realScalars = 1;
    int tables = 3; ///< real factors per mode: symbol, viscous operator, inverse Laplacian
};

/// The storage of the periodic solver in two or three dimensions.
SolverStorage periodicSolverStorage(int dimensions);

/// Memory of such a solver [bytes]; a floating-point number, so that nothing overflows.
/// \param points of the lattice
/// \param modes complex coefficients of one component
double solverMemory(double points, double modes, const SolverStorage& storage);

/// Memory the solver will need for this lattice [bytes].
double solverMemory(const Lattice& lattice);

/// Memory of this machine [bytes].
double machineMemory();

/// "1.5 GB": bytes in the largest decimal unit that leaves at least 1.
std::string memoryText(double bytes);

/// \throws Error(input) at origin, giving both sizes, if more is needed than there is: before anything is allocated.
void requireMemory(double needed, double available, const Origin& origin);

} // namespace isph
