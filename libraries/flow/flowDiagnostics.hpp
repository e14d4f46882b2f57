#pragma once

#include "flow/IncompressibleFlow.hpp"
#include "operators/SpectralOperators.hpp"

namespace isph
{

/// Integral and extreme quantities of a flow at one time.
struct FlowStatistics
{
    double kineticEnergy; ///< integral of |U|^2/2 over the box
    double enstrophy;     ///< integral of |curl U|^2/2
    double palinstrophy;  ///< integral of |grad omega|^2/2
    double forcePower;    ///< integral of U . f; 0 without a body force
    double maxSpeed;      ///< [m/s]
    double maxVorticity;  ///< [1/s]
    double divL2;         ///< root mean square of the divergence [1/s]
    double divLinf;       ///< its largest magnitude
};

/// Computes statistics on a periodic lattice, with exact derivatives for vorticity and its gradient, and the scheme's
/// own for the divergence.
class FlowDiagnostics
{
public:
    explicit FlowDiagnostics(const Lattice& lattice);

    /// \param force body force at the points, or null
    FlowStatistics evaluate(IncompressibleFlow& flow, const RealField* force);

    /// Curl of a velocity: one component in two dimensions, three in three.
    const RealField& vorticity(const RealField& velocity);

private:
    Lattice lattice_;
    SpectralOperators operators_;
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
