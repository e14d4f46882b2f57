#pragma once

#include "boundary/FlowBoundary.hpp"
#include "caseFields/VelocityDerivatives.hpp"
#include "flow/IncompressibleFlow.hpp"
#include "lattice/LatticeFace.hpp"
#include "lattice/Quadrature.hpp"

#include <vector>

namespace isph
{

/// Integral and extreme quantities of a flow at one time.
struct FlowStatistics
{
    double kineticEnergy; ///< integral of |U|^2/2 over the box
    double enstrophy;     ///< integral of |curl U|^2/2
    double palinstrophy;  ///< integral of |grad omega|^2/2
    double forcePower;    ///< integral of U . f; 0 without a body force
    double boundaryPower; ///< what the boundary gives to the fluid, see FlowDiagnostics; 0 in periodic boxes
    double maxSpeed;      ///< [m/s]
    double maxVorticity;  ///< [1/s]
    double divL2;         ///< root mean square of the divergence [1/s]
    double divLinf;       ///< its largest magnitude
};

/// Computes statistics of a flow: integrals by Quadrature, exact derivatives for vorticity and its gradient
/// (VelocityDerivatives), and the scheme's own for the divergence.
///
/// The energy of an incompressible flow changes by
///     dE/dt = int U . f + B - 2 nu Z,   Z = int |omega|^2/2,
///     B = oint nu n . (U x omega) - (p + |U|^2/2) U . n,   n outwards,
/// where B is the boundary power. Along flat walls that move in their plane it is the power of the shear stress,
/// oint U . nu (grad U + grad U^T) n: what both differ by, the slope of U . n along the wall, vanishes there. At walls
/// at rest and along slip walls B is 0, and the enstrophy follows from the loss of energy alone.
class FlowDiagnostics
{
public:
    /// \param nu kinematic viscosity [m2/s]
    /// \param boundary which must outlive this, or null: then velocities at the boundary are those of the flow there,
    ///        and a corner counts for every face that it is on
    FlowDiagnostics(const Lattice& lattice, double nu, const FlowBoundary* boundary = nullptr);

    /// \param force body force at the points, or null
    /// \param t time [s], for the pressure at boundaries that are flowed through
    FlowStatistics evaluate(IncompressibleFlow& flow, const RealField* force, double t);

private:
    double integralOfSquares(const RealField& field) const;
    RealField velocityOn(const LatticeFace& face, const RealField& U) const;
    double boundaryPower(IncompressibleFlow& flow, const RealField& U, double t) const;

    Lattice lattice_;
    double nu_;
    const FlowBoundary* boundary_;
    Quadrature quadrature_;
    VelocityDerivatives derivatives_;
    std::vector<LatticeFace> faces_; ///< at bounded ends
    RealField vorticity_;
    RealField gradient_;
};

/// Root mean square and largest magnitude of the scheme's divergence.
struct DivergenceNorms
{
    double L2;
    double Linf;
};
DivergenceNorms divergenceNorms(IncompressibleFlow& flow);

} // namespace isph
