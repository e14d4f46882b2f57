#include "operators/ExtendedOperators.hpp"

#include "operators/lineSymbolOf.hpp"

#include <algorithm>
#include <cassert>

namespace isph
{

namespace
{

std::array<std::size_t, 3> countsOf(const Lattice& lattice)
{
    std::array<std::size_t, 3> counts{};
    for (std::size_t d = 0; d < 3; ++d)
    {
        counts[d] = static_cast<std::size_t>(lattice.axis(static_cast<int>(d)).count);
    }
    return counts;
}

LineLayout layoutOf(const std::array<std::size_t, 3>& counts, std::size_t direction)
{
    LineLayout layout;
    for (std::size_t d = 0; d < 3; ++d)
    {
        (d < direction ? layout.inner : d == direction ? layout.count : layout.outer) *= counts[d];
    }
    return layout;
}

/// Lines continued together, as in ContinuedTransform.
constexpr std::size_t batch = 16;

} // namespace

ExtendedOperators::ExtendedOperators(const Lattice& lattice, const Continuations& continuations, const Ends& ends,
                                     const KernelSettings& kernel, LaplacianForm laplacian, PlanEffort effort)
    : counts_(countsOf(lattice)),
      extendedCounts_(counts_),
      modeExtents_(isph::modeExtents(extendedLattice(lattice, continuations))),
      transform_(extendedLattice(lattice, continuations), 1, effort),
      modes_(1, transform_.modes()),
      product_(1, transform_.modes()),
      result_(1, transform_.points())
{
    for (std::size_t direction = 0; direction < 3; ++direction)
    {
        if (!continuations[direction]) { continue; }
        LineContinuation continuation(*continuations[direction], static_cast<int>(counts_[direction]),
                                      ends[direction][0], ends[direction][1]);
        const LineLayout before = layoutOf(extendedCounts_, direction);
        extendedCounts_[direction] = static_cast<std::size_t>(continuation.extendedPoints());
        const LineLayout after = layoutOf(extendedCounts_, direction);
        const std::size_t faster = direction == 0 ? 1 : 0;
        const std::size_t slower = direction == 2 ? 1 : 2;
        passes_.push_back({direction,
                           before,
                           after,
                           std::move(continuation),
                           extendedCounts_[faster],
                           {counts_[faster], counts_[slower]},
                           RealField(batch, after.count),
                           RealField(1, after.points())});
    }
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const Axis& axis = lattice.activeAxis(d);
        const auto length = extendedCounts_[static_cast<std::size_t>(lattice.direction(d))];
        const LineSymbol half = lineSymbolOf(kernel, laplacian, static_cast<int>(length), axis.spacing());
        Symbol& symbol = symbols_[static_cast<std::size_t>(d)];
        const auto points = static_cast<double>(transform_.points());
        for (std::size_t m = 0; m < modeExtents_[static_cast<std::size_t>(d)]; ++m)
        {
            const bool negative = m > length / 2;
            const std::size_t k = negative ? length - m : m;
            symbol.first.push_back((negative ? -half.first[k] : half.first[k]) / points);
            symbol.second.push_back(half.second[k] / points);
        }
    }
}

void ExtendedOperators::extend(Pass& pass, std::span<const double> values, const EndData& data)
{
    // Where another direction has been continued before there are no data; what is made up there touches no point of
    // the lattice.
    const auto datum = [&pass](std::span<const double> of, std::size_t line)
    {
        const std::size_t fast = line % pass.across;
        const std::size_t slow = line / pass.across;
        const auto [fasts, slows] = pass.linesOfData;
        return of.empty() || fast >= fasts || slow >= slows ? 0.0 : of[fast + fasts * slow];
    };
    for (std::size_t first = 0; first < pass.before.lines(); first += batch)
    {
        gatherLines(values, pass.before, first, pass.lines);
        const std::size_t end = std::min(first + batch, pass.before.lines());
        for (std::size_t line = first; line < end; ++line)
        {
            pass.continuation.extend(pass.lines[static_cast<int>(line - first)], datum(data.lower, line),
                                     datum(data.upper, line));
        }
        scatterLines(pass.lines, pass.after, first, pass.values[0]);
    }
}

void ExtendedOperators::take(std::span<const double> values, const std::array<EndData, 3>& data)
{
    assert(!passes_.empty());
    for (Pass& pass : passes_)
    {
        extend(pass, values, data[pass.direction]);
        values = pass.values[0];
    }
    transform_.forward(passes_.back().values, modes_);
}

template<class Visit>
void ExtendedOperators::forEachRun(int d, Visit visit) const
{
    const auto axis = static_cast<std::size_t>(d);
    std::size_t inner = 1;
    for (std::size_t e = 0; e < axis; ++e) { inner *= modeExtents_[e]; }
    for (std::size_t first = 0, run = 0; first < modes_.size(); first += inner, ++run)
    {
        visit(run % modeExtents_[axis], first, inner);
    }
}

void ExtendedOperators::multiplyFirst(int d)
{
    const auto in = modes_[0];
    const auto out = product_[0];
    const auto& symbol = symbols_[static_cast<std::size_t>(d)].first;
    forEachRun(d,
               [&](std::size_t m, std::size_t first, std::size_t count)
               {
                   for (std::size_t i = first; i < first + count; ++i)
                   {
                       out[i] = {-symbol[m] * in[i].imag(), symbol[m] * in[i].real()};
                   }
               });
}

void ExtendedOperators::multiplySecond(int d)
{
    const auto in = modes_[0];
    const auto out = product_[0];
    const auto& symbol = symbols_[static_cast<std::size_t>(d)].second;
    forEachRun(
        d, [&](std::size_t m, std::size_t first, std::size_t count)
        { std::transform(&in[first], &in[first] + count, &out[first], [s = -symbol[m]](auto c) { return s * c; }); });
}

template<class Visit>
void ExtendedOperators::backward(Visit visit)
{
    transform_.backward(product_, result_);
    const auto values = result_[0];
    for (std::size_t row = 0; row < counts_[1] * counts_[2]; ++row)
    {
        const std::size_t place = (row / counts_[1] * extendedCounts_[1] + row % counts_[1]) * extendedCounts_[0];
        for (std::size_t i = 0; i < counts_[0]; ++i) { visit(row * counts_[0] + i, values[place + i]); }
    }
}

void ExtendedOperators::derivative(int d, std::span<double> slope)
{
    multiplyFirst(d);
    backward([slope](std::size_t point, double value) { slope[point] = value; });
}

void ExtendedOperators::addTransport(int d, std::span<const double> carrier, double nu, std::span<double> rate)
{
    if (!carrier.empty())
    {
        multiplyFirst(d);
        backward([=](std::size_t point, double slope) { rate[point] -= carrier[point] * slope; });
    }
    if (nu > 0)
    {
        multiplySecond(d);
        backward([=](std::size_t point, double curvature) { rate[point] += nu * curvature; });
    }
}

} // namespace isph
