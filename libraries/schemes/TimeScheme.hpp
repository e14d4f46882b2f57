#pragma once

#include "core/Selection.hpp"
#include "schemes/IncompressibleSystem.hpp"

#include <span>

namespace isph
{

/// A low-storage Runge-Kutta scheme with a projection in every substep (docs/theory/periodic.md, section 5).
struct TimeScheme
{
    std::span<const Substep> substeps;
    int order;
    double imaginaryLimit; ///< |dt lambda| on the imaginary axis (convection); 0: unstable there
    double realLimit;      ///< |dt lambda| on the negative real axis (viscosity)

    bool operator==(const TimeScheme& other) const { return substeps.data() == other.substeps.data(); }
};

const Selection<const TimeScheme*>& timeSchemes();

/// One step of dt from time t: each substep of the scheme in turn.
void advance(const TimeScheme& scheme, IncompressibleSystem& system, double t, double dt);

} // namespace isph
