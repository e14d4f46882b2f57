#include "linear/SparseMatrix.hpp"

#include <algorithm>
#include <cassert>
#include <Eigen/SparseCore>
#include <omp.h>
#include <stdexcept>
#include <utility>

namespace isph
{

SparseMatrix::SparseMatrix(std::size_t columns, AlignedVector<int> rowStarts, AlignedVector<int> columnIndices,
                           AlignedVector<double> values)
    : columns_(columns),
      rowStarts_(std::move(rowStarts)),
      columnIndices_(std::move(columnIndices)),
      values_(std::move(values))
{
    const bool consistent = !rowStarts_.empty() && rowStarts_.front() == 0 &&
                            static_cast<std::size_t>(rowStarts_.back()) == values_.size() &&
                            columnIndices_.size() == values_.size();
    if (!consistent) { throw std::logic_error("SparseMatrix: rows, columns and values do not fit"); }
}

void SparseMatrix::applyRows(std::size_t first, std::size_t count, std::span<const double> x, std::span<double> y) const
{
    using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;
    const auto signedSize = [](std::size_t size) { return static_cast<Eigen::Index>(size); };
    const int* starts = rowStarts_.data() + first;
    const Eigen::Map<const Matrix> matrix(signedSize(count), signedSize(columns()), starts[count] - starts[0], starts,
                                          columnIndices_.data(), values_.data());
    const Eigen::Map<const Eigen::VectorXd> in(x.data(), signedSize(x.size()));
    Eigen::Map<Eigen::VectorXd> out(y.data() + first, signedSize(count));
    out.noalias() = matrix * in;
}

void SparseMatrix::apply(std::span<const double> x, std::span<double> y) const
{
    assert(x.size() == columns() && y.size() == rows() && x.data() != y.data());
    // Few entries are sooner multiplied than shared out, and a team of one thread would still be allocated.
    constexpr std::size_t worthSharing = 100000;
    if (omp_get_max_threads() == 1 || entries() < worthSharing) { return applyRows(0, rows(), x, y); }
    constexpr std::ptrdiff_t block = 512;
    const auto last = static_cast<std::ptrdiff_t>(rows());
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t first = 0; first < last; first += block)
    {
        applyRows(static_cast<std::size_t>(first), static_cast<std::size_t>(std::min(block, last - first)), x, y);
    }
}

AlignedVector<double> SparseMatrix::diagonal() const
{
    AlignedVector<double> diagonal(rows());
    for (std::size_t i = 0; i < rows(); ++i)
    {
        for (int n = rowStarts_[i]; n < rowStarts_[i + 1]; ++n)
        {
            const auto entry = static_cast<std::size_t>(n);
            if (columnIndices_[entry] == static_cast<int>(i)) { diagonal[i] += values_[entry]; }
        }
    }
    return diagonal;
}

} // namespace isph
