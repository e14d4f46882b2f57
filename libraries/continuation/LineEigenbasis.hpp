#pragma once

#include "continuation/LineContinuation.hpp"
#include "continuation/LineLayout.hpp"
#include "continuation/LineSymbol.hpp"
#include "fields/AlignedAllocator.hpp"

#include <array>
#include <span>
#include <vector>

namespace isph
{

/// How the second derivative along lines is closed at an end.
enum class LineEnd
{
    value, ///< the value at the end point is given
    slope, ///< the derivative at the end point is given, and its value eliminated by it
    free   ///< the end point is unknown as the others are: the continuation is all the condition there is
};

/// The second derivative along continued lines, closed at both ends, in the basis of its eigenvectors: there it is a
/// multiplication, and (alpha - beta D2) u = f a division.
///
/// D2 is the derivative of ContinuedDerivative as a matrix; with both ends alike it falls into one for even and one for
/// odd values, which halves the products. Data are those of each line: values; slopes along the axis [1/m] (not outward
/// ones); at free ends what the continuation takes (EndData). Empty spans stand for zeros. Making a basis takes some
/// ten count^3 operations; applying it to a field 4 count (ends alike: 2) a point and no memory.
class LineEigenbasis
{
public:
    /// \param layout of the lines in a field, all their points
    /// \param symbol of a kernel on the extended lines
    /// \param dataScale of the data at free ends, as ContinuedTransform has it
    /// \throws Error(input) without origin if the matrix has complex, positive or defective eigenvalues, or if no point
    /// is unknown
    LineEigenbasis(const LineLayout& layout, const LineContinuation& continuation, const LineSymbol& symbol,
                   LineEnd low, LineEnd high, double dataScale = 1);

    std::size_t first() const { return first_; } ///< first unknown point of a line; modes are stored from there on
    std::size_t count() const { return count_; } ///< unknown points
    std::span<const double> eigenvalues() const { return eigenvalues_; } ///< of D2, mode by mode: none positive [1/m2]
    bool constantMode() const { return constantMode_; } ///< whether mode 0 is the constant 1, with eigenvalue 0

    /// Largest over smallest singular value of the matrix of eigenvectors of length 1: what round-off may grow by.
    double condition() const { return condition_; }

    /// Replaces the unknown values of every line by their modes, and back.
    void forward(std::span<double> values);
    void backward(std::span<double> values);

    /// Adds factor times the second derivative of the data alone to the unknown points.
    void addData(double factor, std::span<const double> low, std::span<const double> high,
                 std::span<double> values) const;

    /// Sets the values at ends that are not free, from the data and the values at the other points.
    void fillEnds(std::span<const double> low, std::span<const double> high, std::span<double> values) const;

private:
    /// The eigenvectors of all, the even or the odd values, and their inverse, in groups of rows as they are applied.
    struct Block
    {
        std::size_t size;
        AlignedVector<double> toModes;
        AlignedVector<double> toValues;
    };

    /// A point whose value is unit[0] lowDatum + unit[1] highDatum - sum_i row[i] u_i, i the unknown points.
    struct FixedEnd
    {
        std::size_t point;
        std::array<double, 2> unit{};
        AlignedVector<double> row{}; ///< empty: zeros
    };

    std::size_t rowOf(std::size_t i) const;
    template<class Visit>
    void forPoints(std::size_t line, std::size_t lines, Visit visit) const;
    void multiply(AlignedVector<double> Block::*matrix, std::size_t lines);
    void foldPairs(double factor, AlignedVector<double>& panel) const;

    LineLayout layout_;
    std::size_t first_;
    std::size_t count_;
    bool constantMode_ = false;
    double condition_ = 0;
    std::vector<FixedEnd> ends_;
    std::array<AlignedVector<double>, 2> response_; ///< second derivative of a unit datum at the low and high end
    std::vector<double> eigenvalues_;
    std::vector<Block> blocks_; ///< one, or even and odd
    std::size_t panelSize_;     ///< values of a group of lines
    AlignedVector<double> panel_;
    AlignedVector<double> product_;
};

} // namespace isph
