#include "continuation/Mirror.hpp"

namespace isph
{

Mirror::Mirror(int newPoints, bool staggered, int smoothness)
    : BlendedContinuation(newPoints, smoothness), staggered_(staggered)
{
}

std::vector<BlendedContinuation::Extrapolation> Mirror::extrapolations(EndCondition condition) const
{
    std::vector<Extrapolation> steps;
    for (int k = 1; k <= newPoints(); ++k)
    {
        Extrapolation step;
        step.weights.assign(static_cast<std::size_t>(points()), 0.0);
        const bool odd = condition == EndCondition::dirichlet;
        step.weights[static_cast<std::size_t>(staggered_ ? k - 1 : k)] = odd ? -1 : 1;
        if (!odd) { step.datum = staggered_ ? 2 * k - 1 : 2 * k; }
        else if (staggered_) { step.datum = 2; }
        else { step.weights[0] += 2; }
        steps.push_back(step);
    }
    return steps;
}

} // namespace isph
