#pragma once

#include "schemes/TimeScheme.hpp"

#include <array>

namespace isph
{

/// How fast the terms of a flow change it, as rates whose product with dt a scheme limits.
struct StepRates
{
    double convective = 0; ///< largest |u . D| over points and modes [1/s]
    double viscous = 0;    ///< largest nu times minus the Laplacian, where the viscous term is explicit [1/s]

    /// Forward Euler has no part of the imaginary axis: convection needs |u|^2/nu times this to balance [1/s]; 0 for
    /// schemes that need no viscosity.
    double unbalancedConvection = 0;

    /// Whether the viscous term turns implicit in steps that are too long for it.
    bool viscousYields = false;

    double courant = 0;     ///< largest sum |u_j|/dx_j over points: Courant number per unit of time [1/s]
    double meanCourant = 0; ///< its mean

    /// A measure of the velocity, on any scale, where its Courant number is not known: a growth of it tells a
    /// divergence.
    double magnitude = 0;
};

/// Whether a step of dt is taken with the viscous term implicit: it yields, and dt is beyond what all terms bear.
bool viscousTermYields(const TimeScheme& scheme, const StepRates& rates, double dt);

/// dt times a rate over what the scheme can bear: stable below 1.
struct StabilityMargin
{
    double convective = 0;
    double viscous = 0;

    bool convectionRules() const { return convective >= viscous; }
};

StabilityMargin stabilityMargin(const TimeScheme& scheme, const StepRates& rates, double dt);

/// The largest dt for which the terms are stable together: sqrt(convective^2 + viscous^2) = 1 lies within the scheme's
/// region (RK3); for forward Euler the terms add. Infinity where nothing limits.
double largestStableStep(const TimeScheme& scheme, const StepRates& rates);

} // namespace isph
