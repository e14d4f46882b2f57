#pragma once

#include "poisson/eigenvalues.hpp"

namespace isph
{

/// Solves lap phi = source on a periodic lattice by transforms; the mean of phi is zero, and so is what the null modes
/// of the operator would carry.
class FourierPoisson
{
public:
    /// \param inverse table of invertedEigenvalues
    FourierPoisson(const Lattice& lattice, AlignedVector<double> inverse, PlanEffort effort = PlanEffort::estimated);

    void solve(const RealField& source, RealField& phi);

private:
    AlignedVector<double> inverse_;
    FourierTransform transform_;
    SpectralField modes_;
};

} // namespace isph
