#pragma once

#include "boundary/FlowBoundary.hpp"
#include "flow/FlowSettings.hpp"
#include "flow/Fluid.hpp"
#include "lattice/Lattice.hpp"

#include <string>
#include <vector>

namespace isph
{

/// The eigenvalues of one operator of a scene, in a few numbers.
struct OperatorSpectrum
{
    std::string name;      ///< "d/dx", "Laplacian", "d2/dy2 of U.x"
    int derivative = 1;    ///< order: the unit of the numbers is (pi/dx)^order
    double radius = 0;     ///< largest magnitude
    double growth = 0;     ///< largest real part; negative where everything dies out
    double imaginary = 0;  ///< largest imaginary part
    std::size_t count = 0; ///< eigenvalues; 0: lines are too long, nothing was computed
    bool grows = false;    ///< beyond what rounding and time steps hide
    std::string words;     ///< what that means
};

/// Spectra of the operators that act in a scene: symbols of the modes that are kept in periodic boxes; axis by axis
/// where one is bounded, -d/dx for a flow in the direction of the axis (or of the outlet).
std::vector<OperatorSpectrum> sceneSpectra(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings,
                                           const FlowBoundary& boundary);

} // namespace isph
