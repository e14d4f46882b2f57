#include "linear/SparseMatrix.hpp"

#include <cassert>
#include <Eigen/SparseCore>
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

void SparseMatrix::apply(std::span<const double> x, std::span<double> y) const
{
    assert(x.size() == columns() && y.size() == rows() && x.data() != y.data());
    using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;
    const auto signedSize = [](std::size_t size) { return static_cast<Eigen::Index>(size); };
    const Eigen::Map<const Matrix> matrix(signedSize(rows()), signedSize(columns()), signedSize(entries()),
                                          rowStarts_.data(), columnIndices_.data(), values_.data());
    const Eigen::Map<const Eigen::VectorXd> in(x.data(), signedSize(x.size()));
    Eigen::Map<Eigen::VectorXd> out(y.data(), signedSize(y.size()));
    out.noalias() = matrix * in;
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
