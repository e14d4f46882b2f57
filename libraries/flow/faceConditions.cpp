#include "flow/faceConditions.hpp"

namespace isph
{

EndCondition velocityEnd(const FaceCondition& face, bool normal, bool staggered)
{
    if (face.velocity == VelocityCondition::slip && !normal) { return EndCondition::neumann; }
    // Off the points nothing is known of what flows out but that it hardly changes.
    if (face.velocity == VelocityCondition::outflow && staggered) { return EndCondition::neumann; }
    return EndCondition::dirichlet;
}

EndCondition viscousCondition(const FaceCondition& face, bool normal, bool staggered)
{
    return face.velocity == VelocityCondition::outflow ? EndCondition::neumann : velocityEnd(face, normal, staggered);
}

bool holdsValue(const FaceCondition& face, bool normal)
{
    return face.velocity == VelocityCondition::value || (face.velocity == VelocityCondition::slip && normal);
}

} // namespace isph
