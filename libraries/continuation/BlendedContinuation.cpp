#include "continuation/BlendedContinuation.hpp"

#include "core/Error.hpp"
#include "lattice/fastCounts.hpp"

#include <cmath>
#include <string>

namespace isph
{

int automaticNewPoints(int n) { return static_cast<int>(continuedCount(n)) - n; }

double smoothStep(int m, double t)
{
    if (t > 0.5) { return 1 - smoothStep(m, 1 - t); }
    double sum = 0;
    double term = 1; // binom(m + j, j) (1 - t)^j
    for (int j = 0; j <= m; ++j)
    {
        sum += term;
        term *= (1 - t) * (m + j + 1) / (j + 1);
    }
    return std::pow(t, m + 1) * sum;
}

BlendedContinuation::BlendedContinuation(int newPoints, int smoothness)
    : Continuation(newPoints), smoothness_(smoothness)
{
    if (newPoints < 1)
    {
        throw Error(Fault::input, "an extension of " + std::to_string(newPoints) + " points is none",
                    "write auto, or at least 1");
    }
    if (smoothness < 0 || smoothness > largestSmoothness)
    {
        throw Error(Fault::input, "smoothness " + std::to_string(smoothness) + " is not one of 0 ... " +
                                      std::to_string(largestSmoothness));
    }
}

EndBlock BlendedContinuation::end(EndCondition condition) const
{
    const std::vector<Extrapolation> steps = extrapolations(condition);
    EndBlock block;
    block.newPoints = newPoints();
    block.points = static_cast<int>(steps.front().weights.size());
    bool anyDatum = false;
    for (int k = 1; k <= newPoints(); ++k)
    {
        const Extrapolation& step = steps[static_cast<std::size_t>(k - 1)];
        const double blend = 1 - smoothStep(smoothness_, static_cast<double>(k) / (newPoints() + 1));
        for (const double weight : step.weights) { block.weights.push_back(blend * weight); }
        block.data.push_back(blend * step.datum);
        anyDatum = anyDatum || step.datum != 0;
    }
    if (!anyDatum) { block.data.clear(); }
    return block;
}

} // namespace isph
