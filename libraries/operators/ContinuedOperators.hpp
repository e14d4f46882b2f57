#pragma once

#include "continuation/ContinuedDerivative.hpp"
#include "continuation/continuedField.hpp"
#include "kernels/KernelSettings.hpp"
#include "operators/Operators.hpp"

#include <vector>

namespace isph
{

/// Operators of a kernel on a lattice with bounded axes: one axis at a time, its lines made periodic by a continuation.
/// Periodic axes cost what they cost without. The kernel is the one-dimensional one along each axis.
class ContinuedOperators : public Operators
{
public:
    /// \throws Error(input) without origin where an axis has too few points for its continuation or the kernel.
    ContinuedOperators(const Lattice& lattice, const Continuations& continuations, const KernelSettings& kernel,
                       PlanEffort effort = PlanEffort::estimated);

    void gradient(const RealField& f, int component, RealField& gradient) override;
    void divergence(const RealField& u, RealField& divergence) override;
    void laplacian(const RealField& f, RealField& laplacian) override;

    /// Derivatives along the d-th active axis.
    ContinuedDerivative& derivative(int d) { return derivatives_[static_cast<std::size_t>(d)]; }

private:
    std::vector<ContinuedDerivative> derivatives_; ///< along each active axis
    RealField scratch_;
};

} // namespace isph
