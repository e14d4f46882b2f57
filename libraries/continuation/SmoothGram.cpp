#include "continuation/SmoothGram.hpp"

#include "core/Error.hpp"

#include <algorithm>
#include <string>

namespace isph
{

namespace
{

/// binom(n, k), by products that are whole numbers at every step.
double binomial(int n, int k)
{
    double value = 1;
    for (int j = 1; j <= k; ++j) { value = value * (n - k + j) / j; }
    return value;
}

/// Weights of the outward derivative at the end, times the spacing, of the polynomial through points 0 ... P.
std::vector<double> slopeWeights(int P)
{
    std::vector<double> weights(1, 0.0);
    for (int c = 1; c <= P; ++c)
    {
        weights.push_back((c % 2 == 0 ? 1 : -1) * binomial(P, c) / c);
        weights[0] += 1.0 / c;
    }
    return weights;
}

} // namespace

SmoothGram::SmoothGram(int newPoints, int degree, int smoothness)
    : BlendedContinuation(newPoints, smoothness), degree_(degree)
{
    if (degree < leastDegree || degree > largestDegree)
    {
        throw Error(Fault::input,
                    "degree " + std::to_string(degree) + " is not one of " + std::to_string(leastDegree) + " ... " +
                        std::to_string(largestDegree),
                    "smoothGram is proved for 3 ... 6; higher degrees amplify round-off");
    }
}

std::vector<BlendedContinuation::Extrapolation> SmoothGram::extrapolations(EndCondition condition) const
{
    const int P = degree_;
    const std::vector<double> slope = slopeWeights(P);
    std::vector<Extrapolation> steps;
    for (int k = 1; k <= newPoints(); ++k)
    {
        Extrapolation step;
        // The nodal polynomial over its slope at the end: what a unit of missing slope adds after k steps.
        const double nodal = k * binomial(k + P, P);
        for (int c = 0; c <= P; ++c)
        {
            const double weight = (c % 2 == 0 ? 1 : -1) * binomial(k + c - 1, c) * binomial(k + P, P - c);
            step.weights.push_back(
                condition == EndCondition::neumann ? weight - nodal * slope[static_cast<std::size_t>(c)] : weight);
        }
        step.datum = condition == EndCondition::neumann ? nodal : 0;
        steps.push_back(step);
    }
    return steps;
}

SmoothGram defaultSmoothGram(int n)
{
    return SmoothGram(automaticNewPoints(n), std::clamp(n - 1, SmoothGram::leastDegree, 4));
}

} // namespace isph
