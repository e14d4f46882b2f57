#pragma once

#include "boundary/FlowBoundary.hpp"
#include "dictionary/Dictionary.hpp"
#include "lattice/Lattice.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace isph
{

/// Checks the boundaryField of U, or of p, by itself: every patch has a condition, with known words and keys, periodic
/// patches and no others a periodic one, functions where they are needed, no wall that lets fluid out.
/// \throws Error(input) with all slips at once.
void checkVelocityConditions(const Dictionary& U, const Lattice& lattice);
void checkPressureConditions(const Dictionary& p, const Lattice& lattice);

/// What the functions of boundary conditions need to know.
struct BoundaryContext
{
    std::vector<std::pair<std::string, double>> constants; ///< names in expressions besides the dictionary's: nu, rho
    std::filesystem::path folder;                          ///< where tables are looked for: the case
    double pressureScale = 1;                              ///< what p is divided by: 1, or rho where p is in Pa
    double time = 0;                                       ///< at which the run starts [s]
};

/// The boundary conditions in the dictionaries of U and p, with the data of the start time.
/// \throws Error(input) with file and line for all that the checks above find, and where the conditions make no
/// well-posed problem: velocity and pressure prescribed at one face, an outlet that holds no pressure, more flowing in
/// than out, faces that contradict each other where they meet, values that are not finite.
FlowBoundary readBoundary(const Dictionary& U, const Dictionary& p, const Lattice& lattice,
                          const BoundaryContext& context);

} // namespace isph
