#pragma once

#include "boundary/FlowBoundary.hpp"
#include "continuation/Continuation.hpp"

#include <array>

namespace isph
{

/// What the continuation of a velocity component knows at a face: on walls its points are values like any other.
/// \param normal whether the component is the one through the face
EndCondition velocityEnd(const FaceCondition& face, bool normal, bool staggered);

/// The same for a viscous term by itself: it must not have an end that nothing holds (OutflowCondition), so at outlets
/// the velocity does not change along the normal.
EndCondition viscousCondition(const FaceCondition& face, bool normal, bool staggered);

/// Whether a face prescribes the values of a velocity component at points that lie on it.
bool holdsValue(const FaceCondition& face, bool normal);

/// Outward derivative at an outlet, times the spacing, from the point there and those behind it: one-sided differences
/// of third order.
inline constexpr std::array<double, 4> outletDifference{11.0 / 6, -18.0 / 6, 9.0 / 6, -2.0 / 6};

} // namespace isph
