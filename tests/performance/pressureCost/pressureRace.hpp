#pragma once

#include "fields/Field.hpp"
#include "kernels/KernelSettings.hpp"
#include "lattice/Lattice.hpp"
#include "operators/KernelSamples.hpp"
#include "poisson/FourierPoisson.hpp"
#include "poisson/IterativePoisson.hpp"
#include "support/processorSecondsOf.hpp"

#include <array>
#include <limits>
#include <string>

namespace isph::test
{

/// The kernels of Fourtakas, Rogers & Nasar 2021: quintic spline cut at 3h, gaussian of order 4 cut at 4h.
inline constexpr std::array<const char*, 2> racingKernels{"quinticSpline", "gaussian4"};

/// The pressure equation of one kernel in the unit box, with the Morris Laplacian, for solvers of either kind, and a
/// random source of mean zero.
class PressureRace
{
public:
    /// \param kernel of racingKernels \throws std::invalid_argument
    PressureRace(int points, const std::string& kernel, double smoothingLength);

    const Lattice& lattice() const { return lattice_; }
    const RealField& source() const { return source_; }
    std::size_t neighbours() const { return samples_.laplacian.size(); }

    /// The solver by transforms, with the eigenvalues of this Laplacian.
    FourierPoisson byTransforms(PlanEffort effort) const;

    /// \param solver biCGStab or cg, preconditioned by Jacobi, to 1e-10 within 1000 iterations
    IterativePoisson iterative(PressureSolver solver) const;

    MorrisSystem system() const { return {lattice_, samples_, {}}; }

    /// What matrix and vectors of an iterative solver take [bytes].
    double bytes() const;

private:
    Lattice lattice_;
    KernelSettings kernel_;
    KernelSamples samples_;
    RealField source_;
};

/// Largest difference of two fields without their means, of the largest value of the second.
double largestDifference(const RealField& a, const RealField& b);

} // namespace isph::test
