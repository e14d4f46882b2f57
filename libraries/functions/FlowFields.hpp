#pragma once

#include "caseFields/VelocityDerivatives.hpp"
#include "core/Selection.hpp"
#include "fields/Field.hpp"
#include "functions/FunctionObject.hpp"
#include "functions/PressureForm.hpp"
#include "sampling/SampleSet.hpp"

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace isph
{

/// What can be sampled of a flow.
enum class FlowQuantity
{
    U,
    p,
    vorticity,
    divergence,
    Q,
};

const Selection<FlowQuantity>& flowQuantities();

/// The fields of a flow as functions write them: by name, with units, the pressure in the form that is written. What
/// follows from U is found by exact derivatives, as sampleLines and toVTK do.
class FlowFields
{
public:
    FlowFields(const Lattice& lattice, PressureForm pressure) : lattice_(lattice), pressure_(std::move(pressure)) {}

    int components(FlowQuantity quantity) const;
    std::string unit(FlowQuantity quantity) const;

    /// The fields at this time, in the order asked for; valid until the next call or step.
    std::vector<NamedField> at(const FlowAtTime& now, std::span<const FlowQuantity> quantities);

private:
    const RealField& pressureAt(const FlowAtTime& now);

    Lattice lattice_;
    PressureForm pressure_;
    RealField scaledPressure_;                       ///< where the form differs from the flow's own
    std::optional<VelocityDerivatives> derivatives_; ///< from the first quantity on that needs them
    std::map<FlowQuantity, RealField> derived_;
};

} // namespace isph
