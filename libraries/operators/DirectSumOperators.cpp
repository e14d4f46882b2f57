#include "operators/DirectSumOperators.hpp"

#include <algorithm>
#include <utility>

namespace isph
{

DirectSumOperators::DirectSumOperators(const Lattice& lattice, KernelSamples samples) : samples_(std::move(samples))
{
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        counts_[static_cast<std::size_t>(d)] = lattice.activeAxis(d).count;
    }
}

void DirectSumOperators::sum(std::span<const double> f, const std::vector<double>& weights,
                             std::span<double> result) const
{
    const auto [nx, ny, nz] = counts_;
    const auto rowOf = [nx = nx, ny = ny](int j, int k)
    { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(j + ny * k); };
    const auto wrapped = [](int i, int n) { return ((i % n) + n) % n; };

#pragma omp parallel for collapse(2) schedule(static)
    for (int k = 0; k < nz; ++k)
    {
        for (int j = 0; j < ny; ++j)
        {
            double* out = result.data() + rowOf(j, k);
            for (std::size_t b = 0; b < weights.size(); ++b)
            {
                const auto& offset = samples_.offsets[b];
                const double* in = f.data() + rowOf(wrapped(j + offset[1], ny), wrapped(k + offset[2], nz));
                // The neighbour of point i is i + shift, wrapped once: two plain loops instead of a test per point.
                const int shift = wrapped(offset[0], nx);
                const double weight = weights[b];
                for (int i = 0; i < nx - shift; ++i) { out[i] += weight * in[i + shift]; }
                for (int i = nx - shift; i < nx; ++i) { out[i] += weight * in[i + shift - nx]; }
            }
        }
    }
}

void DirectSumOperators::gradient(const RealField& f, int component, RealField& gradient)
{
    for (int d = 0; d < gradient.components(); ++d)
    {
        std::ranges::fill(gradient[d], 0.0);
        sum(f[component], samples_.gradient[static_cast<std::size_t>(d)], gradient[d]);
    }
}

void DirectSumOperators::divergence(const RealField& u, RealField& divergence)
{
    std::ranges::fill(divergence[0], 0.0);
    for (int d = 0; d < u.components(); ++d)
    {
        sum(u[d], samples_.gradient[static_cast<std::size_t>(d)], divergence[0]);
    }
}

void DirectSumOperators::laplacian(const RealField& f, RealField& laplacian)
{
    for (int component = 0; component < f.components(); ++component)
    {
        std::ranges::fill(laplacian[component], 0.0);
        sum(f[component], samples_.laplacian, laplacian[component]);
    }
}

} // namespace isph
