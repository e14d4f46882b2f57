#pragma once

#include "boundary/FlowBoundary.hpp"
#include "case/Case.hpp"
#include "case/TimeDirectories.hpp"
#include "flow/Fluid.hpp"
#include "flow/IncompressibleFlow.hpp"
#include "lattice/Lattice.hpp"

#include <string>

namespace isph
{

struct Scene;

/// What the dictionaries of U and p say besides their values: kept to be written with every time.
struct FlowFiles
{
    Dictionary U;
    Dictionary p;
    double pressureScale = 1;           ///< kinematic pressure times this is what p holds
    std::string pressureUnit = "m2/s2"; ///< or Pa, by the dimensions of p
};

/// Reads the dictionary of U, or of p, in a time folder and checks dimensions and boundary conditions.
/// \throws Error(input) with file and line.
Dictionary readVelocityFile(const Case& flowCase, const std::string& time, const Lattice& lattice);
Dictionary readPressureFile(const Case& flowCase, const std::string& time, const Lattice& lattice, const Fluid& fluid);

/// Reads the dictionaries of U and p in a time folder and checks dimensions and boundary conditions against the
/// lattice. \throws Error(input) with file and line: an unknown patch, a patch without condition, a type that does not
/// fit, ...
FlowFiles readFlowFiles(const Case& flowCase, const std::string& time, const Lattice& lattice, const Fluid& fluid);

/// The boundary conditions that the files of a time folder hold, with the data of that time.
/// \throws Error(input) with file and line where they make no well-posed problem (boundary/readBoundary.hpp).
FlowBoundary readFlowBoundary(const Case& flowCase, const std::string& time, const Lattice& lattice, const Fluid& fluid,
                              const FlowFiles& files);

/// Brings the flow into the state of a time folder: the marching state where the solver wrote one for this kind of
/// flow, else the velocity of the field U, projected if asked for; the boundary comes to that time, too. \param restart
/// whether the solver wrote the folder
StartReport readFlow(const Case& flowCase, const std::string& time, bool restart, Scene& scene,
                     IncompressibleFlow& flow);

} // namespace isph
