#pragma once

#include "boundary/FlowBoundary.hpp"
#include "core/Selection.hpp"
#include "dictionary/Schema.hpp"

#include <string_view>

namespace isph
{

/// What a word for a condition means.
template<class Condition>
struct ConditionWord
{
    Condition condition;
    std::string_view key; ///< of the function that it needs; empty: none
};

/// What `type` may be in the boundaryField of U, and of p.
const Selection<ConditionWord<VelocityCondition>>& velocityConditions();
const Selection<ConditionWord<PressureCondition>>& pressureConditions();

/// Keys of a patch in the boundaryField of U, and of p.
const Schema& velocityConditionSchema();
const Schema& pressureConditionSchema();

} // namespace isph
