#include "pressureRace.hpp"

#include "fields/reductions.hpp"
#include "operators/DerivativeSymbol.hpp"
#include "support/fields.hpp"
#include "support/kernels.hpp"
#include "support/periodicBox.hpp"

#include <cmath>
#include <stdexcept>

namespace isph::test
{

namespace
{

KernelSettings racingKernel(const std::string& name, double smoothingLength)
{
    if (name == "quinticSpline") { return quinticSpline(smoothingLength); }
    if (name == "gaussian4") { return sampledGaussian(4, smoothingLength, 4); }
    throw std::invalid_argument("there is no kernel " + name);
}

} // namespace

PressureRace::PressureRace(int points, const std::string& kernel, double smoothingLength)
    : lattice_(unitSquare(points)),
      kernel_(racingKernel(kernel, smoothingLength)),
      samples_(lattice_, kernel_, LaplacianForm::morris),
      source_(noise(lattice_, 1, 1))
{
    const double mean = sum(source_[0]) / static_cast<double>(source_.size());
    for (double& value : source_[0]) { value -= mean; }
}

FourierPoisson PressureRace::byTransforms(PlanEffort effort) const
{
    const ModeRows rows(lattice_);
    return {lattice_, invertedEigenvalues(rows, laplacianSymbol(lattice_, kernel_, LaplacianForm::morris, &samples_)),
            effort};
}

IterativePoisson PressureRace::iterative(PressureSolver solver) const
{
    return {lattice_,
            samples_,
            {},
            {.solver = solver,
             .preconditioner = Preconditioning::jacobi,
             .krylov = {.tolerance = 1e-10, .maxIterations = 1000}}};
}

double PressureRace::bytes() const
{
    constexpr double vectors = 12;
    return morrisSystemBytes(lattice_, neighbours()) + 8 * vectors * static_cast<double>(lattice_.points());
}

double largestDifference(const RealField& a, const RealField& b)
{
    const auto size = static_cast<double>(a.size());
    const double meanA = sum(a[0]) / size;
    const double meanB = sum(b[0]) / size;
    double difference = 0;
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        difference = std::max(difference, std::abs(a[0][i] - meanA - (b[0][i] - meanB)));
        largest = std::max(largest, std::abs(b[0][i] - meanB));
    }
    return difference / largest;
}

} // namespace isph::test
