#include "lattice/LatticeFace.hpp"

#include "lattice/Quadrature.hpp"
#include "lattice/readPatches.hpp"

#include <algorithm>
#include <cassert>

namespace isph
{

namespace
{

/// Weights of points at 1/2, 3/2, ... of the polynomial through them at 0.
std::vector<double> weightsAtWall(int points)
{
    std::vector<double> weights(static_cast<std::size_t>(points), 1.0);
    for (int j = 0; j < points; ++j)
    {
        for (int k = 0; k < points; ++k)
        {
            if (k != j) { weights[static_cast<std::size_t>(j)] *= (k + 0.5) / (k - j); }
        }
    }
    return weights;
}

/// Whether point i of an axis lies on a face.
bool onFace(const Axis& axis, int i)
{
    return axis.active() && !axis.periodic() && !axis.staggered && (i == 0 || i == axis.count - 1);
}

} // namespace

LatticeFace::LatticeFace(const Lattice& lattice, int direction, bool upper) : direction_(direction), upper_(upper)
{
    const Axis& normal = lattice.axis(direction);
    assert(normal.active() && !normal.periodic());
    extrapolation_ = normal.staggered ? weightsAtWall(std::min(4, normal.count)) : std::vector{1.0};

    std::array<std::ptrdiff_t, 3> stride{1, lattice.axis(0).count, 0};
    stride[2] = stride[1] * lattice.axis(1).count;
    const std::ptrdiff_t step = stride[static_cast<std::size_t>(direction)];
    inward_ = upper ? -step : step;
    const std::ptrdiff_t first = upper ? (normal.count - 1) * step : 0;

    const int a = direction == 0 ? 1 : 0;
    const int b = direction == 2 ? 1 : 2;
    const std::vector<double> weightsA = quadratureWeights(lattice.axis(a));
    const std::vector<double> weightsB = quadratureWeights(lattice.axis(b));
    const double place = upper ? normal.origin + normal.extent : normal.origin;
    for (int ib = 0; ib < lattice.axis(b).count; ++ib)
    {
        for (int ia = 0; ia < lattice.axis(a).count; ++ia)
        {
            points_.push_back(static_cast<std::size_t>(first + ia * stride[static_cast<std::size_t>(a)] +
                                                       ib * stride[static_cast<std::size_t>(b)]));
            if (!normal.staggered && !onFace(lattice.axis(a), ia) && !onFace(lattice.axis(b), ib))
            {
                innerPoints_.push_back(points_.back());
            }
            coordinates_[static_cast<std::size_t>(direction)].push_back(place);
            coordinates_[static_cast<std::size_t>(a)].push_back(lattice.axis(a).coordinate(ia));
            coordinates_[static_cast<std::size_t>(b)].push_back(lattice.axis(b).coordinate(ib));
            weights_.push_back(weightsA[static_cast<std::size_t>(ia)] * weightsB[static_cast<std::size_t>(ib)]);
        }
    }
}

void LatticeFace::values(std::span<const double> field, std::span<double> onFace) const
{
    assert(onFace.size() == points());
    for (std::size_t n = 0; n < points_.size(); ++n)
    {
        auto point = static_cast<std::ptrdiff_t>(points_[n]);
        onFace[n] = 0;
        for (const double weight : extrapolation_)
        {
            onFace[n] += weight * field[static_cast<std::size_t>(point)];
            point += inward_;
        }
    }
}

std::vector<LatticeFace> facesOf(const Patch& patch, const Lattice& lattice)
{
    std::vector<LatticeFace> faces;
    for (int d = 0; d < 3; ++d)
    {
        for (const bool upper : {false, true})
        {
            const std::string& name = faceNames()[static_cast<std::size_t>(2 * d + (upper ? 1 : 0))];
            if (std::ranges::find(patch.faces, name) != patch.faces.end()) { faces.emplace_back(lattice, d, upper); }
        }
    }
    return faces;
}

std::vector<LatticeFace> boundedFaces(const Lattice& lattice)
{
    std::vector<LatticeFace> faces;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        if (lattice.activeAxis(d).periodic()) { continue; }
        for (const bool upper : {false, true}) { faces.emplace_back(lattice, lattice.direction(d), upper); }
    }
    return faces;
}

} // namespace isph
