#include "flow/flowDiagnostics.hpp"

#include "fields/reductions.hpp"
#include "kernels/ExactKernel.hpp"

#include <algorithm>
#include <cmath>

namespace isph
{

namespace
{

DerivativeSymbol exactDerivative(const Lattice& lattice)
{
    KernelSettings exact;
    exact.kernel = std::make_unique<ExactKernel>();
    return DerivativeSymbol(lattice, exact, nullptr);
}

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

double sumOfSquaresOfVectors(const RealField& field)
{
    double total = 0;
    for (int c = 0; c < field.components(); ++c) { total += sumOfSquares(field[c]); }
    return total;
}

} // namespace

FlowDiagnostics::FlowDiagnostics(const Lattice& lattice)
    : lattice_(lattice),
      operators_(lattice, exactDerivative(lattice), {}),
      vorticity_(lattice.dimensions() == 2 ? 1 : 3, lattice.points()),
      gradient_(lattice.dimensions(), lattice.points())
{
}

const RealField& FlowDiagnostics::vorticity(const RealField& velocity)
{
    operators_.curl(velocity, vorticity_);
    return vorticity_;
}

FlowStatistics FlowDiagnostics::evaluate(IncompressibleFlow& flow, const RealField* force)
{
    const double volume = lattice_.pointVolume();
    const RealField& velocity = flow.velocity();
    FlowStatistics statistics{};
    statistics.kineticEnergy = 0.5 * volume * sumOfSquaresOfVectors(velocity);
    statistics.maxSpeed = largestMagnitudeOfVectors(velocity);
    for (int d = 0; force != nullptr && d < lattice_.dimensions(); ++d)
    {
        statistics.forcePower += volume * sumOfProducts(velocity[d], (*force)[d]);
    }
    const RealField& omega = vorticity(velocity);
    statistics.enstrophy = 0.5 * volume * sumOfSquaresOfVectors(omega);
    statistics.maxVorticity = largestMagnitudeOfVectors(omega);
    for (int c = 0; c < omega.components(); ++c)
    {
        operators_.gradient(omega, c, gradient_);
        statistics.palinstrophy += 0.5 * volume * sumOfSquaresOfVectors(gradient_);
    }
    const DivergenceNorms divergence = divergenceNorms(flow);
    statistics.divL2 = divergence.L2;
    statistics.divLinf = divergence.Linf;
    return statistics;
}

DivergenceNorms divergenceNorms(IncompressibleFlow& flow)
{
    const RealField& divergence = flow.divergence();
    return {std::sqrt(sumOfSquares(divergence[0]) / static_cast<double>(divergence.size())),
            largestMagnitude(divergence[0])};
}

} // namespace isph
