#pragma once

#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"

#include <array>

namespace isph
{

/// psi with U_a = dpsi/db, U_b = -dpsi/da [m2/s] of a velocity along the two active axes a, b of a plane.
///
/// In a periodic box psi is 0 on average but for the part of a mean flow, which is 0 at the first point. With bounded
/// axes it solves lap psi = dU_a/db - dU_b/da with psi on the boundary from the flow through it: 0 at the lower end of
/// the first bounded axis, and constant along every wall. Of order 4, on staggered axes 2. Where what flows in and out
/// does not balance, the difference is taken out where it flows.
struct StreamFunction
{
    RealField values;

    /// What one period along x, y and z adds: not 0 where there is a mean flow across that axis.
    std::array<double, 3> periodGain{};
};

/// \throws Error(input) without origin if an axis has too few points.
StreamFunction streamFunction(const RealField& U, const Lattice& lattice);

} // namespace isph
