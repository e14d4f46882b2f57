#include "boundary/conditionSelection.hpp"

#include <array>

namespace isph
{

namespace
{

using VelocityWord = ConditionWord<VelocityCondition>;
using PressureWord = ConditionWord<PressureCondition>;

constexpr std::array<Selection<VelocityWord>::Variant, 6> velocityWords{{
    {"periodic", "what leaves through one face of an axis enters through the other", {VelocityCondition::periodic, ""}},
    {"noSlip", "at rest, as the fluid at a wall", {VelocityCondition::value, ""}},
    {"fixedValue", "prescribed by 'value': moving walls, inlets", {VelocityCondition::value, "value"}},
    {"slip", "no flow through the face, no shear along it", {VelocityCondition::slip, ""}},
    {"symmetry", "the same: the flow behind the face is the mirror image", {VelocityCondition::slip, ""}},
    {"outflow", "nothing prescribed: the flow leaves as it comes", {VelocityCondition::outflow, ""}},
}};
static_assert(distinct(velocityWords));

constexpr std::array<Selection<PressureWord>::Variant, 4> pressureWords{{
    {"periodic", "what leaves through one face of an axis enters through the other", {PressureCondition::periodic, ""}},
    {"zeroGradient",
     "the gradient that keeps the velocity of the face: walls, inlets",
     {PressureCondition::zeroGradient, ""}},
    {"fixedValue", "prescribed by 'value': outlets", {PressureCondition::value, "value"}},
    {"fixedGradient", "outward derivative prescribed by 'gradient'", {PressureCondition::gradient, "gradient"}},
}};
static_assert(distinct(pressureWords));

} // namespace

const Selection<VelocityWord>& velocityConditions()
{
    static constexpr Selection<VelocityWord> selection("condition of the velocity", velocityWords);
    return selection;
}

const Selection<PressureWord>& pressureConditions()
{
    static constexpr Selection<PressureWord> selection("condition of the pressure", pressureWords);
    return selection;
}

const Schema& velocityConditionSchema()
{
    using Type = Key::Type;
    static const Schema schema(
        "velocityCondition",
        {{.name = "type", .type = Type::word, .meaning = "see -listVelocityConditions", .required = true},
         {.name = "value", .type = Type::function, .unit = "m/s", .meaning = "velocity, of x y z t"}});
    return schema;
}

const Schema& pressureConditionSchema()
{
    using Type = Key::Type;
    static const Schema schema(
        "pressureCondition",
        {{.name = "type", .type = Type::word, .meaning = "see -listPressureConditions", .required = true},
         {.name = "value", .type = Type::function, .meaning = "pressure, of x y z t"},
         {.name = "gradient", .type = Type::function, .meaning = "its outward derivative, of x y z t"}});
    return schema;
}

} // namespace isph
