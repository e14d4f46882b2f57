#include "operators/KernelSamples.hpp"

#include "core/Error.hpp"
#include "neighbours/LatticeStencil.hpp"

#include <algorithm>
#include <cmath>

namespace isph
{

namespace
{

/// The kernel's quotients at an offset, times the volume of a point over prod h.
struct Sample
{
    std::array<double, 3> scaled{0, 0, 0}; ///< x_j/h_j
    double q2 = 0;
    double f = 0;
    double g = 0;
};

Sample sampleAt(const std::array<int, 3>& offset, const KernelSettings& settings, int dimensions)
{
    Sample sample;
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d)
    {
        sample.scaled[d] = offset[d] / settings.smoothingLength;
        sample.q2 += sample.scaled[d] * sample.scaled[d];
    }
    const double q = std::sqrt(sample.q2);
    const double volume = std::pow(settings.smoothingLength, -dimensions);
    sample.f = volume * settings.kernel->f(q, dimensions);
    sample.g = volume * settings.kernel->g(q, dimensions);
    return sample;
}

/// What a consistent operator would have as 1: the sums of the weights with the squares they should differentiate.
struct Moments
{
    double first = 1;  ///< of the gradient, and of Morris' Laplacian
    double second = 1; ///< of the kernel's second derivatives
};

Moments momentsOf(const std::vector<Sample>& samples, int dimensions)
{
    Moments moments{0, 0};
    for (const Sample& sample : samples)
    {
        moments.first -= sample.q2 * sample.f / dimensions;
        moments.second += 0.5 * sample.q2 * (sample.f + sample.q2 * sample.g / dimensions);
    }
    return moments;
}

} // namespace

KernelSamples::KernelSamples(const Lattice& lattice, const KernelSettings& settings, LaplacianForm form)
    : offsets(latticeStencil(lattice, settings.smoothingLength, settings.supportRadius))
{
    if (offsets.size() == 1)
    {
        throw Error(Fault::input, "the support of the sampled kernel reaches no neighbour",
                    "choose a larger supportRadius or smoothingLength");
    }
    const int dimensions = lattice.dimensions();
    std::array<double, 3> h{0, 0, 0};
    for (int d = 0; d < dimensions; ++d)
    {
        h[static_cast<std::size_t>(d)] = settings.smoothingLength * lattice.activeAxis(d).spacing();
    }
    const double widest = *std::ranges::max_element(h);
    const double morrisShare = form == LaplacianForm::morris ? 1 / (widest * widest) : 0;

    std::vector<Sample> samples;
    for (const auto& offset : offsets) { samples.push_back(sampleAt(offset, settings, dimensions)); }
    const Moments moments = settings.renormalise ? momentsOf(samples, dimensions) : Moments{};

    double sumOfWeights = 0;
    for (const Sample& sample : samples)
    {
        double weight = -2 * morrisShare * sample.f / moments.first;
        for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d)
        {
            // grad W(x_a - x_b) with x_b - x_a = x, hence the minus.
            gradient[d].push_back(-sample.scaled[d] * sample.f / (h[d] * moments.first));
            const double curvature = sample.f + sample.scaled[d] * sample.scaled[d] * sample.g;
            weight += (1 / (h[d] * h[d]) - morrisShare) * curvature / moments.second;
        }
        if (form != LaplacianForm::exact) { laplacian.push_back(weight); }
        sumOfWeights += weight;
    }

    // Laplacians act on differences f_b - f_a, as a truncated kernel's weights do not add up to zero by themselves: the
    // point itself carries minus the sum of the others.
    if (!laplacian.empty())
    {
        const auto self = std::ranges::find(offsets, std::array<int, 3>{0, 0, 0}) - offsets.begin();
        laplacian[static_cast<std::size_t>(self)] -= sumOfWeights;
    }
}

} // namespace isph
