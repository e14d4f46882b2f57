#include "continuation/LineContinuation.hpp"

#include "core/Error.hpp"

#include <algorithm>
#include <cassert>
#include <string>

namespace isph
{

namespace
{

void add(double factor, const double* column, std::span<double> to)
{
    for (std::size_t k = 0; k < to.size(); ++k) { to[k] += factor * column[k]; }
}

} // namespace

LineContinuation::End::End(const EndBlock& block, bool reversed) : points(block.points)
{
    const int d = block.newPoints;
    const auto stepsTo = [d, reversed](int k) { return reversed ? d + 1 - k : k; };
    for (int c = 0; c < block.points; ++c)
    {
        for (int k = 1; k <= d; ++k) { columns.push_back(block.weight(stepsTo(k), c)); }
    }
    for (int k = 1; k <= d && !block.data.empty(); ++k)
    {
        data.push_back(block.data[static_cast<std::size_t>(stepsTo(k) - 1)]);
    }
}

LineContinuation::LineContinuation(const Continuation& continuation, int n, EndCondition lower, EndCondition upper)
    : points_(n),
      newPoints_(continuation.newPoints()),
      lower_(continuation.end(lower), true),
      upper_(continuation.end(upper), false)
{
    if (n < continuation.points())
    {
        throw Error(Fault::input,
                    "the continuation uses " + std::to_string(continuation.points()) +
                        " points at each end, but the axis has " + std::to_string(n),
                    "take more lattice points, or fewer points of continuation");
    }
}

void LineContinuation::extend(std::span<double> line, double lowerDatum, double upperDatum) const
{
    const auto n = static_cast<std::size_t>(points_);
    const auto d = static_cast<std::size_t>(newPoints_);
    assert(line.size() == n + d);
    const std::span<double> added = line.subspan(n);
    std::ranges::fill(added, 0.0);
    for (std::size_t c = 0; c < static_cast<std::size_t>(upper_.points); ++c)
    {
        add(line[n - 1 - c], upper_.columns.data() + c * d, added);
    }
    for (std::size_t c = 0; c < static_cast<std::size_t>(lower_.points); ++c)
    {
        add(line[c], lower_.columns.data() + c * d, added);
    }
    if (!upper_.data.empty()) { add(upperDatum, upper_.data.data(), added); }
    if (!lower_.data.empty()) { add(lowerDatum, lower_.data.data(), added); }
}

} // namespace isph
