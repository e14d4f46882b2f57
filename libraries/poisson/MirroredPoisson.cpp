#include "poisson/MirroredPoisson.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace isph
{

namespace
{

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The modes of a direction; one that is left out has a single one.
struct Modes
{
    std::vector<double> phase; ///< k dx
    std::vector<double> k2;
    std::size_t first = 0;
    std::size_t end = 1;
};

/// Sums weights times cosines axis by axis: from those of |offset| along the three axes to eigenvalues by mode.
std::vector<double> eigenvaluesOf(const Lattice& lattice, const KernelSamples& samples,
                                  const std::array<Modes, 3>& modes)
{
    std::array<std::size_t, 3> extents{1, 1, 1};
    for (const auto& offset : samples.offsets)
    {
        for (int d = 0; d < lattice.dimensions(); ++d)
        {
            std::size_t& extent = extents[at(lattice.direction(d))];
            extent = std::max(extent, at(std::abs(offset[at(d)])) + 1);
        }
    }
    std::vector<double> table(extents[0] * extents[1] * extents[2]);
    for (std::size_t b = 0; b < samples.offsets.size(); ++b)
    {
        std::array<std::size_t, 3> step{0, 0, 0};
        for (int d = 0; d < lattice.dimensions(); ++d)
        {
            step[at(lattice.direction(d))] = at(std::abs(samples.offsets[b][at(d)]));
        }
        table[step[0] + extents[0] * (step[1] + extents[1] * step[2])] -= samples.laplacian[b];
    }
    for (std::size_t d = 0; d < 3; ++d)
    {
        const std::size_t steps = extents[d];
        const std::size_t stride = d == 0 ? 1 : d == 1 ? extents[0] : extents[0] * extents[1];
        const std::size_t outer = table.size() / (stride * steps);
        const std::size_t count = modes[d].phase.size();
        std::vector<double> summed(stride * count * outer);
        for (std::size_t o = 0; o < outer; ++o)
        {
            for (std::size_t m = 0; m < count; ++m)
            {
                double* to = summed.data() + stride * (m + count * o);
                for (std::size_t s = 0; s < steps; ++s)
                {
                    const double cosine = std::cos(modes[d].phase[m] * static_cast<double>(s));
                    const double* from = table.data() + stride * (s + steps * o);
                    for (std::size_t i = 0; i < stride; ++i) { to[i] += cosine * from[i]; }
                }
            }
        }
        extents[d] = count;
        table = std::move(summed);
    }
    return table;
}

} // namespace

MirroredPoisson::MirroredPoisson(const Lattice& lattice, const KernelSamples& samples,
                                 const std::array<AxisEnds, 3>& ends, PlanEffort effort)
    : data_(lattice, samples, ends), inverse_(lattice.points()), given_(data_.fixed().size())
{
    const std::array<int, 3> counts{lattice.axis(0).count, lattice.axis(1).count, lattice.axis(2).count};
    std::array<Modes, 3> modes;
    for (Modes& left : modes) { left.phase = left.k2 = {0.0}; }
    double scale = 1;
    for (int active = 0; active < lattice.dimensions(); ++active)
    {
        const int direction = lattice.direction(active);
        const BoundedAxis axis(lattice.axis(direction), ends[at(direction)], BoundedPoisson::exactSymbol);
        Modes& along = modes[at(direction)];
        along.k2.assign(axis.k2.begin(), axis.k2.end());
        along.phase.resize(axis.points);
        std::ranges::transform(axis.k2, along.phase.begin(), [&](double k2) { return std::sqrt(k2) * axis.spacing; });
        along.first = axis.first;
        along.end = axis.first + axis.count;
        const Lines lines{counts, direction, static_cast<int>(axis.first), static_cast<int>(axis.count)};
        transforms_.emplace_back(lines, axis.basis, effort);
        scale /= transforms_.back().factor();
    }

    const std::vector<double> eigenvalues = eigenvaluesOf(lattice, samples, modes);
    const std::size_t nx = modes[0].k2.size();
    const std::size_t ny = modes[1].k2.size();
    for (std::size_t k = modes[2].first; k < modes[2].end; ++k)
    {
        for (std::size_t j = modes[1].first; j < modes[1].end; ++j)
        {
            for (std::size_t i = modes[0].first; i < modes[0].end; ++i)
            {
                const std::size_t mode = i + nx * (j + ny * k);
                // A null mode is judged by its own wave vector, as in invertedEigenvalues.
                const double k2 = modes[0].k2[i] + modes[1].k2[j] + modes[2].k2[k];
                inverse_[mode] = eigenvalues[mode] > 1e-24 * k2 && k2 > 0 ? scale / eigenvalues[mode] : 0;
            }
        }
    }
}

double MirroredPoisson::solve(const RealField& source, const WallData& walls, RealField& phi)
{
    const auto modes = phi[0];
    const double unbalanced = data_.rightHandSide(source[0], walls, modes);
    // Transforms pass over the points whose value is given.
    const auto fixed = data_.fixed();
    for (std::size_t n = 0; n < fixed.size(); ++n) { given_[n] = modes[fixed[n]] / data_.diagonal(); }
    for (const RealTransform& transform : transforms_) { transform.forward(modes); }
    std::ranges::transform(modes, inverse_, modes.begin(), std::multiplies{});
    for (const RealTransform& transform : transforms_) { transform.backward(modes); }
    for (std::size_t n = 0; n < fixed.size(); ++n) { modes[fixed[n]] = given_[n]; }
    return unbalanced;
}

} // namespace isph
