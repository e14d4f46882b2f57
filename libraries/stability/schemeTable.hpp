#pragma once

#include <optional>
#include <string>
#include <vector>

namespace isph
{

/// What a kernel bears in a periodic square of 64^2 points, without dealiasing.
struct PeriodicLimits
{
    std::string kernel;
    std::optional<double> smoothingLength; ///< h/dx; none for the exact derivative
    double axis = 0;                       ///< RK3: largest |u| dt/dx of a flow along an axis
    double diagonal = 0;                   ///< and along a diagonal
    double viscous = 0;                    ///< RK3: largest nu dt/dx^2, Laplacian of Morris, Fox & Zhu
    double viscousFirstOrder = 0;          ///< the same of firstOrderProjection, which bears no flow by itself
};

/// The quintic spline, Gaussians of order 2 to 20 with smoothing lengths of 1.3, 1.5 and 2 spacings, and the exact
/// derivative.
std::vector<PeriodicLimits> periodicLimits();

/// What a kernel and a continuation bear between walls: a line of 64 intervals, RK3, the kernel's second derivative.
struct WallLimits
{
    std::string kernel;
    std::optional<double> smoothingLength;
    std::string continuation;
    double courant = 0;       ///< of a flow along an axis of a square box, as the suite prints it
    double viscous = 0;       ///< the same of nu dt/dx^2
    double flowGrowth = 0;    ///< fastest mode of a flow from an inlet to an outlet, in |u|/dx
    double viscousGrowth = 0; ///< fastest mode of the second derivative between walls, in nu/dx^2
    bool realModes = false;   ///< its eigenvalues are real: Crank-Nicolson can be had
    double atRest = 0; ///< factor that the projection multiplies modes at the walls by in a step (channel of 32 x 64)
};

std::vector<WallLimits> wallLimits();

} // namespace isph
