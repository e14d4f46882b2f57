#include "functions/FlowFields.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace isph
{

namespace
{

constexpr std::array<Selection<FlowQuantity>::Variant, 5> table{{
    {"U", "velocity", FlowQuantity::U},
    {"p", "pressure", FlowQuantity::p},
    {"vorticity", "curl U", FlowQuantity::vorticity},
    {"divergence", "div U, by exact derivatives", FlowQuantity::divergence},
    {"Q", "second invariant of grad U", FlowQuantity::Q},
}};
static_assert(distinct(table));

} // namespace

const Selection<FlowQuantity>& flowQuantities()
{
    static constexpr Selection<FlowQuantity> selection("field", table);
    return selection;
}

int FlowFields::components(FlowQuantity quantity) const
{
    if (quantity == FlowQuantity::U) { return lattice_.dimensions(); }
    return quantity == FlowQuantity::vorticity && lattice_.dimensions() == 3 ? 3 : 1;
}

std::string FlowFields::unit(FlowQuantity quantity) const
{
    switch (quantity)
    {
    case FlowQuantity::U:
        return "m/s";
    case FlowQuantity::p:
        return pressure_.unit;
    case FlowQuantity::vorticity:
    case FlowQuantity::divergence:
        return "1/s";
    case FlowQuantity::Q:
        break;
    }
    return "1/s2";
}

const RealField& FlowFields::pressureAt(const FlowAtTime& now)
{
    const RealField& pressure = now.flow.pressure(now.time);
    if (pressure_.scale == 1) { return pressure; }
    if (scaledPressure_.components() == 0) { scaledPressure_ = RealField(1, lattice_.points()); }
    std::ranges::transform(pressure[0], scaledPressure_[0].begin(),
                           [scale = pressure_.scale](double value) { return scale * value; });
    return scaledPressure_;
}

std::vector<NamedField> FlowFields::at(const FlowAtTime& now, std::span<const FlowQuantity> quantities)
{
    const auto derived = [&](FlowQuantity quantity) -> const RealField&
    {
        if (!derivatives_) { derivatives_.emplace(lattice_); }
        RealField& field = derived_[quantity];
        field = quantity == FlowQuantity::vorticity    ? derivatives_->vorticity(now.flow.velocity())
                : quantity == FlowQuantity::divergence ? derivatives_->divergence(now.flow.velocity())
                                                       : derivatives_->Q(now.flow.velocity());
        return field;
    };
    std::vector<NamedField> fields;
    for (const FlowQuantity quantity : quantities)
    {
        const RealField& values = quantity == FlowQuantity::U   ? now.flow.velocity()
                                  : quantity == FlowQuantity::p ? pressureAt(now)
                                                                : derived(quantity);
        fields.push_back({std::string(flowQuantities().nameOf(quantity)), unit(quantity), values});
    }
    return fields;
}

} // namespace isph
