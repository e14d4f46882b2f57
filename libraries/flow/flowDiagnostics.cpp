#include "flow/flowDiagnostics.hpp"

#include "fields/reductions.hpp"

#include <algorithm>
#include <cmath>

namespace isph
{

namespace
{

double largestMagnitudeOfVectors(const RealField& field)
{
    double largest2 = 0;
    for (std::size_t i = 0; i < field.size(); ++i)
    {
        double magnitude2 = 0;
        for (int c = 0; c < field.components(); ++c) { magnitude2 += field[c][i] * field[c][i]; }
        if (!(magnitude2 <= largest2)) { largest2 = magnitude2; }
    }
    return std::sqrt(largest2);
}

/// Values on a face of every component of a field.
RealField valuesOnFace(const LatticeFace& face, const RealField& field)
{
    RealField values(field.components(), face.points());
    for (int c = 0; c < field.components(); ++c) { face.values(field[c], values[c]); }
    return values;
}

/// Component d of U x omega at point n; in a plane omega is normal to it.
double lambComponent(const RealField& U, const RealField& omega, double sign, int d, std::size_t n)
{
    if (U.components() == 2) { return (d == 0 ? sign : -sign) * U[1 - d][n] * omega[0][n]; }
    const int a = (d + 1) % 3;
    const int b = (d + 2) % 3;
    return U[a][n] * omega[b][n] - U[b][n] * omega[a][n];
}

} // namespace

FlowDiagnostics::FlowDiagnostics(const Lattice& lattice, double nu, const FlowBoundary* boundary)
    : lattice_(lattice),
      nu_(nu),
      boundary_(boundary),
      quadrature_(lattice),
      derivatives_(lattice),
      faces_(boundedFaces(lattice)),
      vorticity_(derivatives_.vorticityComponents(), lattice.points()),
      gradient_(1, lattice.points())
{
}

FlowStatistics FlowDiagnostics::evaluate(IncompressibleFlow& flow, const RealField* force, double t)
{
    const RealField& U = flow.velocity();
    FlowStatistics statistics{};
    statistics.kineticEnergy = 0.5 * integralOfSquares(U);
    statistics.maxSpeed = largestMagnitudeOfVectors(U);
    for (int d = 0; force != nullptr && d < lattice_.dimensions(); ++d)
    {
        statistics.forcePower += quadrature_.ofProducts(U[d], (*force)[d]);
    }
    derivatives_.vorticity(U, vorticity_);
    statistics.enstrophy = 0.5 * integralOfSquares(vorticity_);
    statistics.maxVorticity = largestMagnitudeOfVectors(vorticity_);
    for (int c = 0; c < vorticity_.components(); ++c)
    {
        for (int d = 0; d < lattice_.dimensions(); ++d)
        {
            derivatives_.derivative(d, vorticity_[c], gradient_[0]);
            statistics.palinstrophy += 0.5 * integralOfSquares(gradient_);
        }
    }
    statistics.boundaryPower = boundaryPower(flow, U, t);
    const DivergenceNorms divergence = divergenceNorms(flow);
    statistics.divL2 = divergence.L2;
    statistics.divLinf = divergence.Linf;
    return statistics;
}

double FlowDiagnostics::integralOfSquares(const RealField& field) const
{
    double total = 0;
    for (int c = 0; c < field.components(); ++c) { total += quadrature_.ofSquares(field[c]); }
    return total;
}

RealField FlowDiagnostics::velocityOn(const LatticeFace& face, const RealField& U) const
{
    RealField values = valuesOnFace(face, U);
    for (int d = 0; boundary_ != nullptr && d < values.components(); ++d)
    {
        const Side side = face.outward() > 0 ? Side::high : Side::low;
        std::ranges::copy(boundary_->ownVelocity(face.direction(), side, d), values[d].begin());
    }
    return values;
}

double FlowDiagnostics::boundaryPower(IncompressibleFlow& flow, const RealField& U, double t) const
{
    const double sign = lattice_.dimensions() == 2 ? normalSign(lattice_) : 1;
    double power = 0;
    for (const LatticeFace& face : faces_)
    {
        const RealField UOnFace = velocityOn(face, U);
        const double speed = largestMagnitudeOfVectors(UOnFace);
        if (speed == 0) { continue; }
        const RealField omega = valuesOnFace(face, vorticity_);
        int d = 0;
        while (lattice_.direction(d) != face.direction()) { ++d; }

        std::vector<double> p(face.points(), 0.0);
        const bool flowedThrough = largestMagnitude(UOnFace[d]) > 0;
        if (flowedThrough) { face.values(flow.pressure(t)[0], p); }
        for (std::size_t n = 0; n < face.points(); ++n)
        {
            double squares = 0;
            for (int c = 0; c < UOnFace.components(); ++c) { squares += UOnFace[c][n] * UOnFace[c][n]; }
            power += face.weights()[n] * face.outward() *
                     (nu_ * lambComponent(UOnFace, omega, sign, d, n) - (p[n] + 0.5 * squares) * UOnFace[d][n]);
        }
    }
    return power;
}

DivergenceNorms divergenceNorms(IncompressibleFlow& flow)
{
    const RealField& divergence = flow.divergence();
    return {std::sqrt(sumOfSquares(divergence[0]) / static_cast<double>(divergence.size())),
            largestMagnitude(divergence[0])};
}

} // namespace isph
