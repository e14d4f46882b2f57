#pragma once

#include "fields/Field.hpp"

#include <array>
#include <memory>
#include <optional>

namespace isph
{

/// A force per unit mass on the fluid, at the points of the lattice.
class BodyForce
{
public:
    virtual ~BodyForce() = default;

    /// Fills the components along the active axes [m/s2] at time t.
    virtual void evaluate(double t, RealField& force) const = 0;

    virtual bool dependsOnTime() const = 0;

    /// Its components along the active axes where it is the same at all places and times: then no field is needed.
    virtual std::optional<std::array<double, 3>> uniform() const { return std::nullopt; }
};

/// What flows.
struct Fluid
{
    double nu = 0;                            ///< kinematic viscosity [m2/s]; 0: inviscid
    std::optional<double> rho = std::nullopt; ///< density [kg/m3], for pressures in Pa
    std::unique_ptr<const BodyForce> bodyForce = nullptr;
};

} // namespace isph
