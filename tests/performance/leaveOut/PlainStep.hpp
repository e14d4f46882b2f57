#pragma once

#include "fields/Field.hpp"
#include "flow/Scene.hpp"

#include <memory>

namespace isph::test
{

/// The RK3 step of one scene written out by hand: no settings, no choice, no virtual call, only what this scene needs,
/// with the transforms of the suite. The suite's step is measured against it.
class PlainStep
{
public:
    virtual ~PlainStep() = default;

    /// A step, and the largest speeds that the next one's length is chosen by.
    virtual void step(double dt) = 0;

    virtual RealField velocity() = 0;
};

/// \param scene of Load::alone
/// \param start divergence-free
std::unique_ptr<PlainStep> plainPeriodic(const Scene& scene, const RealField& start, PlanEffort effort);

/// Between walls at rest, but for a lid along the upper end of y in a cavity.
std::unique_ptr<PlainStep> plainBounded(const Scene& scene, const RealField& start, PlanEffort effort);

} // namespace isph::test
