#pragma once

#include "fields/Field.hpp"
#include "fieldStore/FieldReader.hpp"
#include "fieldStore/FieldWriter.hpp"
#include "flow/PressureRecord.hpp"
#include "schemes/IncompressibleSystem.hpp"
#include "schemes/stabilityLimits.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace isph
{

/// What the start did to the velocity it was given, as parts of its L2 norm.
struct StartReport
{
    double projected = 0; ///< taken out by the projection onto divergence-free fields
    double dealiased = 0; ///< in modes that dealiasing drops
    double nyquist = 0;   ///< in checkerboard modes, which no derivative sees
};

/// An incompressible flow in a box: its state, how it marches, and what can be asked of it between steps.
class IncompressibleFlow : public IncompressibleSystem
{
public:
    /// Starts from a velocity with a component for each active axis.
    virtual StartReport start(const RealField& velocity, bool project) = 0;

    /// The marching state, bit for bit.
    virtual void save(FieldWriter& writer) const = 0;
    virtual void restore(const FieldReader& reader) = 0;

    /// Whether a file holds the state of this kind of flow.
    virtual bool restores(const FieldReader& reader) const = 0;

    /// Goes back to the state before the last step (which diverged, say).
    virtual void stepBack() = 0;

    /// Rates of the present state, for choosing and judging a step; not finite when the state is not.
    virtual StepRates rates() = 0;

    /// What a user should know of these schemes in this scene before relying on the result.
    virtual std::vector<std::string> cautions() const { return {}; }

    /// How the last step took the viscous term, where steps differ in that; else empty.
    virtual std::string_view viscousStep() const { return {}; }

    /// What iterations for the pressure took in steps, where it is iterated; else null.
    virtual const PressureRecord* pressureRecord() const { return nullptr; }

    /// Velocity at the points, its mean included; valid until the next step.
    virtual const RealField& velocity() = 0;

    /// Kinematic pressure with zero mean, from the stress: lap p = div(f - div(uu)), third order in time.
    virtual const RealField& pressure(double t) = 0;

    /// Divergence by the scheme's own derivative.
    virtual const RealField& divergence() = 0;

    /// Transforms of one component made in steps so far, and what tells the plans apart.
    virtual long transforms() const = 0;
    virtual std::string planFingerprint() const = 0;
};

} // namespace isph
