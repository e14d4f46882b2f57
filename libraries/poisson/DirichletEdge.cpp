#include "poisson/DirichletEdge.hpp"

#include <algorithm>

namespace isph
{

namespace
{

/// Modes of the function that is 1 at a Dirichlet end, linear to 0 at another one or constant to a Neumann end.
AlignedVector<double> modesOfEnd(const BoundedAxis& axis, bool high)
{
    const auto& weight = high ? axis.high : axis.low;
    AlignedVector<double> modes(axis.points);
    for (std::size_t i = axis.first; i < axis.first + axis.count; ++i) { modes[i] = weight[i] / axis.sine2[i]; }
    return modes;
}

} // namespace

DirichletEdge::DirichletEdge(const std::array<int, 3>& counts, const std::array<const BoundedAxis*, 3>& axes,
                             const Face& a, const Face& b, PlanEffort effort)
    : faces_{a, b}, along_(3 - a.d - b.d)
{
    for (std::size_t d = 0; d < 3; ++d)
    {
        extents_[d] = static_cast<std::size_t>(counts[d]);
        eigenvalues_[d].assign(extents_[d], 0.0);
        if (axes[d] != nullptr) { eigenvalues_[d] = axes[d]->eigenvalue; }
    }
    for (const Face& face : faces_) { tables_[face.d] = modesOfEnd(*axes[face.d], face.high); }
    values_.resize(extents_[along_]);
    straight_.resize(extents_[along_]);
    if (const BoundedAxis* axis = axes[along_])
    {
        const Lines lines{
            {static_cast<int>(values_.size()), 1, 1}, 0, static_cast<int>(axis->first), static_cast<int>(axis->count)};
        transform_.emplace(lines, axis->basis, effort);
        if (axis->fixedLow()) { ofEnds_[0] = modesOfEnd(*axis, false); }
        if (axis->fixedHigh()) { ofEnds_[1] = modesOfEnd(*axis, true); }
    }
}

void DirichletEdge::addValues(std::size_t face, std::span<const double> values, double weight)
{
    if (values.empty()) { return; }
    const Face& other = faces_[1 - face];
    std::array<std::size_t, 3> sizes = extents_;
    sizes[faces_[face].d] = 1;
    const std::array<std::size_t, 3> strides{1, sizes[0], sizes[0] * sizes[1]};
    const std::size_t start = (other.high ? sizes[other.d] - 1 : 0) * strides[other.d];
    for (std::size_t i = 0; i < values_.size(); ++i) { values_[i] += weight * values[start + i * strides[along_]]; }
}

void DirichletEdge::read(std::span<const double> ofA, std::span<const double> ofB)
{
    std::fill(values_.begin(), values_.end(), 0.0);
    const double weight = faces_[0].onPoints && faces_[1].onPoints ? 0.5 : 1;
    if (faces_[1].onPoints) { addValues(0, ofA, weight); }
    if (faces_[0].onPoints) { addValues(1, ofB, weight); }
    std::fill(straight_.begin(), straight_.end(), 0.0);
    for (std::size_t e = 0; e < 2; ++e)
    {
        const double value = e == 0 ? values_.front() : values_.back();
        for (std::size_t i = 0; i < ofEnds_[e].size(); ++i) { straight_[i] += value * ofEnds_[e][i]; }
    }
    if (transform_) { transform_->forward(values_); }
}

void DirichletEdge::subtractFrom(std::size_t face, std::span<double> faceModes) const
{
    const std::size_t other = faces_[1 - face].d;
    std::array<std::size_t, 3> sizes = extents_;
    sizes[faces_[face].d] = 1;
    const std::array<std::size_t, 3> strides{1, sizes[0], sizes[0] * sizes[1]};
    for (std::size_t m = 0; m < values_.size(); ++m)
    {
        // Two edges of a face share what is straight.
        const double value = values_[m] - 0.5 * straight_[m];
        for (std::size_t i = 0; i < extents_[other]; ++i)
        {
            faceModes[i * strides[other] + m * strides[along_]] -= value * tables_[other][i];
        }
    }
}

void DirichletEdge::addTo(std::span<double> modes, const std::array<std::size_t, 3>& first,
                          const std::array<std::size_t, 3>& end) const
{
    for (std::size_t k = first[2]; k < end[2]; ++k)
    {
        for (std::size_t j = first[1]; j < end[1]; ++j)
        {
            double* row = modes.data() + extents_[0] * (j + extents_[1] * k);
            for (std::size_t i = first[0]; i < end[0]; ++i)
            {
                const std::array<std::size_t, 3> index{i, j, k};
                const std::size_t m = index[along_];
                const double total = eigenvalues_[0][i] + eigenvalues_[1][j] + eigenvalues_[2][k];
                const double across = total - eigenvalues_[along_][m];
                const double value = (values_[m] - straight_[m]) * across / total + straight_[m] / 3;
                row[i] += value * tables_[faces_[0].d][index[faces_[0].d]] * tables_[faces_[1].d][index[faces_[1].d]];
            }
        }
    }
}

} // namespace isph
