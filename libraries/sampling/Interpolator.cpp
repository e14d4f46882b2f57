#include "sampling/Interpolator.hpp"

#include "core/Error.hpp"

#include <algorithm>
#include <cassert>
#include <fmt/format.h>
#include <numeric>

namespace isph
{

namespace
{

void requireInside(const Axis& axis, double coordinate)
{
    if (inside(axis, coordinate)) { return; }
    throw Error(Fault::input, fmt::format("a point at {} = {} lies outside of the box, which reaches from {} to {}",
                                          axis.name, coordinate, axis.origin, axis.origin + axis.extent));
}

/// An array of three extents, x fastest, summed up along one of them with the weights of a stencil.
void sumUp(std::span<const double> values, const std::array<int, 3>& extents, int direction, const AxisStencil& stencil,
           std::vector<double>& result)
{
    std::size_t inner = 1;
    std::size_t outer = 1;
    for (int d = 0; d < 3; ++d)
    {
        if (d < direction) { inner *= static_cast<std::size_t>(extents[static_cast<std::size_t>(d)]); }
        if (d > direction) { outer *= static_cast<std::size_t>(extents[static_cast<std::size_t>(d)]); }
    }
    const auto count = static_cast<std::size_t>(extents[static_cast<std::size_t>(direction)]);
    result.resize(inner * outer);
    for (std::size_t o = 0; o < outer; ++o)
    {
        double* const sums = result.data() + o * inner;
        std::size_t k = static_cast<std::size_t>(stencil.first);
        for (std::size_t w = 0; w < stencil.weights.size(); ++w, k = k + 1 == count ? 0 : k + 1)
        {
            const double weight = stencil.weights[w];
            const double* const row = values.data() + (o * count + k) * inner;
            // The first term is no sum, so that a lattice point gives its value in the same bits.
            if (w == 0)
            {
                std::transform(row, row + inner, sums, [weight](double value) { return weight * value; });
            }
            else
            {
                for (std::size_t i = 0; i < inner; ++i) { sums[i] += weight * row[i]; }
            }
        }
    }
}

} // namespace

Interpolator::Interpolator(const Lattice& lattice, const Points& points, Interpolation interpolation)
    : order_(points[0].size())
{
    for (std::size_t d = 0; d < 3; ++d)
    {
        const Axis& axis = lattice.axis(static_cast<int>(d));
        counts_[d] = axis.count;
        std::vector<double> distinctCoordinates = points[d];
        std::ranges::sort(distinctCoordinates);
        const auto repeated = std::ranges::unique(distinctCoordinates);
        distinctCoordinates.erase(repeated.begin(), repeated.end());
        for (const double coordinate : distinctCoordinates)
        {
            requireInside(axis, coordinate);
            stencils_[d].push_back(axisStencil(axis, coordinate, interpolation));
        }
        for (const double coordinate : points[d])
        {
            const auto found = std::ranges::lower_bound(distinctCoordinates, coordinate);
            which_[d].push_back(static_cast<std::size_t>(found - distinctCoordinates.begin()));
        }
    }
    std::ranges::stable_sort(axes_, {}, [this](int d) { return stencils_[static_cast<std::size_t>(d)].size(); });

    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::sort(order_, {},
                      [this](std::size_t n)
                      {
                          const auto stencilOf = [&](std::size_t a)
                          { return which_[static_cast<std::size_t>(axes_[a])][n]; };
                          return std::array{stencilOf(0), stencilOf(1), stencilOf(2)};
                      });
}

void Interpolator::operator()(std::span<const double> field, std::span<double> values) const
{
    assert(values.size() == points());
    std::array<std::vector<double>, 3> sums; // after one axis, two, and all three
    std::size_t before = 0;
    for (const std::size_t n : order_)
    {
        bool shared = n != order_.front();
        std::array<int, 3> extents = counts_;
        for (std::size_t a = 0; a < 3; ++a)
        {
            const auto d = static_cast<std::size_t>(axes_[a]);
            shared = shared && which_[d][n] == which_[d][before];
            const std::span<const double> source = a == 0 ? field : std::span<const double>(sums[a - 1]);
            if (!shared) { sumUp(source, extents, axes_[a], stencils_[d][which_[d][n]], sums[a]); }
            extents[d] = 1;
        }
        values[n] = sums[2].front();
        before = n;
    }
}

} // namespace isph
