#pragma once

#include "flow/Fluid.hpp"
#include "spectral/FourierTransform.hpp"
#include "spectral/ModeRows.hpp"

namespace isph
{

/// The pressure of a velocity on a periodic lattice, p = -k_i k_j (u_i u_j)/k^2 - i k.f/k^2 with the exact wavenumbers
/// and zero mean (docs/theory/periodic.md, section 5): it holds no kernel, needs no guard, and is as accurate as the
/// velocity.
class OutputPressure
{
public:
    explicit OutputPressure(const Lattice& lattice);

    /// \param velocity its first components, a uniform mean may be left out; null: no convection
    /// \param force one component for each active axis, or null
    void evaluate(const RealField* velocity, const RealField* force, RealField& pressure);

private:
    ModeRows rows_;
    FourierTransform transform_;
    RealField real_;
    SpectralField modes_;
    SpectralField sum_;
};

} // namespace isph
