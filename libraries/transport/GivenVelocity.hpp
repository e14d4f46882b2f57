#pragma once

#include "fields/Field.hpp"

namespace isph
{

/// A velocity that is known at the points of a lattice, at any time.
class GivenVelocity
{
public:
    virtual ~GivenVelocity() = default;

    /// Fills the components along the active axes [m/s] at time t.
    virtual void evaluate(double t, RealField& U) const = 0;

    virtual bool dependsOnTime() const = 0;
};

} // namespace isph
