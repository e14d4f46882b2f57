#include "poisson/ContinuedHelmholtz.hpp"

#include "core/Error.hpp"

#include <algorithm>
#include <cassert>
#include <fmt/format.h>
#include <stdexcept>

namespace isph
{

namespace
{

LineEnd lineEnd(End end) { return end == End::dirichlet ? LineEnd::value : LineEnd::slope; }

/// The points of a face, in runs of neighbours: calls visit(first point, its place in the face, length).
template<class Visit>
void forFace(const LineLayout& lines, std::size_t at, Visit visit)
{
    for (std::size_t o = 0; o < lines.outer; ++o)
    {
        visit((o * lines.count + at) * lines.inner, o * lines.inner, lines.inner);
    }
}

void write(const LineLayout& lines, std::size_t at, std::span<const double> values, std::span<double> u)
{
    forFace(lines, at,
            [&](std::size_t point, std::size_t place, std::size_t length)
            {
                const auto to = u.subspan(point, length).begin();
                if (values.empty()) { std::fill_n(to, length, 0.0); }
                else { std::ranges::copy(values.subspan(place, length), to); }
            });
}

} // namespace

std::vector<ContinuedAxis> continuedAxes(const Lattice& lattice, const Continuations& continuations,
                                         const KernelSettings& kernel, const std::array<AxisEnds, 3>& ends)
{
    std::vector<ContinuedAxis> axes;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const Axis& axis = lattice.activeAxis(d);
        const auto direction = static_cast<std::size_t>(lattice.direction(d));
        const auto& continuation = continuations[direction];
        const AxisEnds& given = ends[direction];
        if (axis.periodic() != (given.low == End::periodic) || axis.periodic() != (given.high == End::periodic) ||
            axis.periodic() == static_cast<bool>(continuation))
        {
            throw std::logic_error("continuedAxes: conditions, continuations and axes do not suit each other");
        }
        ContinuedAxis result;
        if (continuation)
        {
            if (axis.staggered)
            {
                throw Error(Fault::input,
                            fmt::format("axis {} is staggered: the direct solver needs points on its walls", axis.name),
                            "leave staggered out, or choose another solver");
            }
            result.continuation.emplace(*continuation, axis.count);
            result.low = lineEnd(given.low);
            result.high = lineEnd(given.high);
        }
        const int length = continuation ? result.continuation->extendedPoints() : axis.count;
        result.symbol = lineSymbol(kernel, length, axis.spacing());
        axes.push_back(std::move(result));
    }
    return axes;
}

ContinuedHelmholtz::ContinuedHelmholtz(const Lattice& lattice, const std::vector<ContinuedAxis>& axes,
                                       PlanEffort effort)
    : extents_{static_cast<std::size_t>(lattice.axis(0).count), static_cast<std::size_t>(lattice.axis(1).count),
               static_cast<std::size_t>(lattice.axis(2).count)}
{
    assert(axes.size() == static_cast<std::size_t>(lattice.dimensions()));
    const std::array<int, 3> counts{lattice.axis(0).count, lattice.axis(1).count, lattice.axis(2).count};
    for (std::size_t d = 0; d < 3; ++d)
    {
        eigenvalues_[d].resize(extents_[d]);
        weights_[d].assign(extents_[d], 1.0);
    }
    for (int a = 0; a < lattice.dimensions(); ++a)
    {
        const ContinuedAxis& axis = axes[static_cast<std::size_t>(a)];
        const auto d = static_cast<std::size_t>(lattice.direction(a));
        Direction direction{d, linesAlong(lattice, lattice.direction(a)), {}, {}, axis.low, axis.high};
        if (axis.continuation)
        {
            const LineEigenbasis& basis = direction.basis.emplace(direction.layout, *axis.continuation, axis.symbol,
                                                                  axis.low, axis.high, axis.dataScale);
            first_[d] = basis.first();
            end_[d] = basis.first() + basis.count();
            std::ranges::copy(basis.eigenvalues(), std::span(eigenvalues_[d]).subspan(first_[d]).begin());
            if (!lattice.activeAxis(a).staggered) { weights_[d].front() = weights_[d].back() = 0.5; }
            constantMode_ = constantMode_ && basis.constantMode();
        }
        else
        {
            const Lines lines{.extents = counts, .axis = lattice.direction(a), .count = counts[d]};
            scale_ /= direction.fourier.emplace(lines, RealBasis::fourier, effort).factor();
            end_[d] = extents_[d];
            for (std::size_t m = 0; m < extents_[d]; ++m)
            {
                eigenvalues_[d][m] = -axis.symbol.second[std::min(m, extents_[d] - m)];
            }
        }
        directions_.push_back(std::move(direction));
    }
}

double ContinuedHelmholtz::solve(double alpha, double beta, std::span<const double> f, const WallData& walls,
                                 std::span<double> u)
{
    assert(f.size() == u.size() && u.size() == extents_[0] * extents_[1] * extents_[2]);
    assert(alpha != 0 || beta != 0);
    if (f.data() != u.data()) { std::ranges::copy(f, u.begin()); }
    for (const Direction& direction : directions_)
    {
        // Nothing that stands on walls may disturb a transform.
        if (first_[direction.d] > 0) { write(direction.layout, 0, {}, u); }
        if (end_[direction.d] < extents_[direction.d]) { write(direction.layout, end_[direction.d], {}, u); }
    }
    for (const Direction& direction : directions_)
    {
        const FaceValues& data = walls[direction.d];
        if (direction.basis) { direction.basis->addData(beta, data.low, data.high, u); }
    }
    for (Direction& direction : directions_)
    {
        if (direction.basis) { direction.basis->forward(u); }
        else { direction.fourier->forward(u); }
    }
    const bool floating = constantMode_ && alpha == 0;
    const double excess = floating ? scale_ * u[first_[0] + offset(first_[1], first_[2])] : 0;
    divide(alpha, beta, u);
    for (Direction& direction : directions_)
    {
        if (direction.basis) { direction.basis->backward(u); }
        else { direction.fourier->backward(u); }
    }
    fillWalls(walls, u);
    if (floating) { subtractMean(u); }
    return excess;
}

void ContinuedHelmholtz::divide(double alpha, double beta, std::span<double> modes) const
{
    for (std::size_t k = first_[2]; k < end_[2]; ++k)
    {
        for (std::size_t j = first_[1]; j < end_[1]; ++j)
        {
            double* row = modes.data() + offset(j, k);
            const double ofRow = eigenvalues_[1][j] + eigenvalues_[2][k];
            for (std::size_t i = first_[0]; i < end_[0]; ++i)
            {
                // 0 is exact: the constant, where nothing else determines it.
                const double value = alpha - beta * (eigenvalues_[0][i] + ofRow);
                row[i] = value != 0 ? scale_ * row[i] / value : 0;
            }
        }
    }
}

void ContinuedHelmholtz::fillWalls(const WallData& walls, std::span<double> u) const
{
    for (const Direction& direction : directions_)
    {
        const FaceValues& data = walls[direction.d];
        if (direction.basis) { direction.basis->fillEnds(data.low, data.high, u); }
    }
    // Slopes of a later direction have overwritten values on the edges.
    for (const Direction& direction : directions_)
    {
        if (!direction.basis) { continue; }
        const FaceValues& data = walls[direction.d];
        if (direction.low == LineEnd::value) { write(direction.layout, 0, data.low, u); }
        if (direction.high == LineEnd::value) { write(direction.layout, direction.layout.count - 1, data.high, u); }
    }
}

void ContinuedHelmholtz::subtractMean(std::span<double> u) const
{
    double sum = 0;
    double total = 0;
    for (std::size_t k = 0; k < extents_[2]; ++k)
    {
        for (std::size_t j = 0; j < extents_[1]; ++j)
        {
            for (std::size_t i = 0; i < extents_[0]; ++i)
            {
                const double weight = weights_[0][i] * weights_[1][j] * weights_[2][k];
                sum += weight * u[offset(j, k) + i];
                total += weight;
            }
        }
    }
    for (double& value : u) { value -= sum / total; }
}

double ContinuedHelmholtz::condition() const
{
    double largest = 1;
    for (const Direction& direction : directions_)
    {
        if (direction.basis) { largest = std::max(largest, direction.basis->condition()); }
    }
    return largest;
}

} // namespace isph
