#pragma once

#include "fields/AlignedAllocator.hpp"
#include "linear/LinearOperator.hpp"

namespace isph
{

/// A sparse matrix by rows (CSR): row i has the entries from rowStarts()[i] to rowStarts()[i + 1], with columns in
/// rising order. It moves, and does not copy.
class SparseMatrix : public LinearOperator
{
public:
    /// Most entries that rows can be counted by: those of a matrix must be fewer.
    static constexpr double mostEntries = 2147483647;

    SparseMatrix() = default;

    /// \param rowStarts one more than there are rows, from 0 on
    SparseMatrix(std::size_t columns, AlignedVector<int> rowStarts, AlignedVector<int> columnIndices,
                 AlignedVector<double> values);
    SparseMatrix(SparseMatrix&&) noexcept = default;
    SparseMatrix& operator=(SparseMatrix&&) noexcept = default;

    std::size_t rows() const override { return rowStarts_.empty() ? 0 : rowStarts_.size() - 1; }
    std::size_t columns() const override { return columns_; }
    std::size_t entries() const { return values_.size(); }

    /// y = A x by Eigen's product. A row is summed by one thread: the same bits for any number of them.
    void apply(std::span<const double> x, std::span<double> y) const override;

    /// The entries (i, i), 0 where there is none.
    AlignedVector<double> diagonal() const;

    std::span<const int> rowStarts() const { return rowStarts_; }
    std::span<const int> columnIndices() const { return columnIndices_; }
    std::span<const double> values() const { return values_; }

private:
    void applyRows(std::size_t first, std::size_t count, std::span<const double> x, std::span<double> y) const;

    std::size_t columns_ = 0;
    AlignedVector<int> rowStarts_;
    AlignedVector<int> columnIndices_;
    AlignedVector<double> values_;
};

} // namespace isph
