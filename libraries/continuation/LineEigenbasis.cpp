#include "continuation/LineEigenbasis.hpp"

#include "continuation/ContinuedDerivative.hpp"
#include "core/Error.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <Eigen/Dense>
#include <fmt/format.h>
#include <numeric>
#include <optional>

namespace isph
{

namespace
{

using Matrix = Eigen::MatrixXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Index = Eigen::Index;

constexpr std::size_t rowGroup = 4;  ///< rows that are multiplied together
constexpr std::size_t lineGroup = 8; ///< lines that are multiplied together: a cache line
constexpr std::size_t largestBatch = 4 * lineGroup;

std::size_t roundedUp(std::size_t n, std::size_t unit) { return (n + unit - 1) / unit * unit; }

/// Both derivatives along a line as matrices, of its values and of the data that the continuation takes.
struct Derivatives
{
    RowMajor first;
    RowMajor second;
    Matrix firstOfData;
    Matrix secondOfData;
};

Derivatives matricesOf(const LineContinuation& continuation, const LineSymbol& symbol, double dataScale)
{
    const Index n = continuation.points();
    const auto points = static_cast<std::size_t>(n);
    const RowMajor unit = RowMajor::Identity(n, n);
    Derivatives matrices{RowMajor(n, n), RowMajor(n, n), Matrix(n, 2), Matrix(n, 2)};
    ContinuedDerivative ofValues(ContinuedTransform({points, points, 1}, continuation), symbol);
    ofValues({unit.data(), points * points}, {matrices.first.data(), points * points},
             {matrices.second.data(), points * points});

    ContinuedDerivative ofData(ContinuedTransform({1, points, 2}, continuation, dataScale), symbol);
    const std::vector<double> zeros(2 * points, 0.0);
    const std::array<double, 2> low{1, 0};
    const std::array<double, 2> high{0, 1};
    ofData(zeros, {matrices.firstOfData.data(), 2 * points}, {matrices.secondOfData.data(), 2 * points}, {low, high});
    return matrices;
}

[[noreturn]] void refuse(Index n, const std::string& what)
{
    throw Error(Fault::input, fmt::format("the second derivative on a line of {} unknown points {}", n, what),
                "choose kernel exact or a gaussian of order 20, and continuation of degree 3 or 4");
}

/// Real eigenvectors of length 1, in columns, by increasing size of the eigenvalue.
struct Spectrum
{
    std::vector<double> values;
    Matrix vectors;
};

Spectrum spectrumOf(const Matrix& matrix, Index unknown)
{
    const Eigen::EigenSolver<Matrix> solver(matrix);
    if (solver.info() != Eigen::Success) { refuse(unknown, "has eigenvalues that were not found"); }
    const Eigen::VectorXcd found = solver.eigenvalues();
    const double largest = found.cwiseAbs().maxCoeff();
    if ((found.imag().array() != 0).any())
    {
        refuse(unknown, fmt::format("has complex eigenvalues (imaginary parts up to {:.2g} of the largest)",
                                    found.imag().cwiseAbs().maxCoeff() / largest));
    }
    if (found.real().maxCoeff() > 1e-9 * largest)
    {
        refuse(unknown, fmt::format("has positive eigenvalues (up to {:.2g} of the largest)",
                                    found.real().maxCoeff() / largest));
    }
    std::vector<Index> order(static_cast<std::size_t>(matrix.rows()));
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::sort(order, {}, [&found](Index i) { return -found[i].real(); });
    Spectrum spectrum{{}, Matrix(matrix.rows(), matrix.rows())};
    const Eigen::MatrixXcd vectors = solver.eigenvectors();
    for (const Index i : order)
    {
        spectrum.vectors.col(static_cast<Index>(spectrum.values.size())) = vectors.col(i).real();
        spectrum.values.push_back(std::min(found[i].real(), 0.0));
    }
    return spectrum;
}

/// Largest and smallest singular value of eigenvectors that are even or odd (or neither: weight 1), at full length 1.
std::pair<double, double> singularValues(Matrix vectors, double weight, bool middle)
{
    const Index folded = vectors.rows() - (middle ? 1 : 0);
    vectors.topRows(folded) *= weight;
    vectors.colwise().normalize();
    const Eigen::VectorXd values = Eigen::BDCSVD<Matrix>(vectors).singularValues();
    return {values.maxCoeff(), values.minCoeff()};
}

/// Groups of rows one after the other, in each the columns one after the other.
AlignedVector<double> packed(const Matrix& matrix)
{
    const auto n = static_cast<std::size_t>(matrix.rows());
    AlignedVector<double> result(roundedUp(n, rowGroup) * n);
    for (std::size_t i = 0; i < n; ++i)
    {
        for (std::size_t j = 0; j < n; ++j)
        {
            result[(i / rowGroup * n + j) * rowGroup + i % rowGroup] =
                matrix(static_cast<Index>(i), static_cast<Index>(j));
        }
    }
    return result;
}

/// A group of rows times a group of lines of n values each, in vectors that stay in registers: compilers shuffle the
/// sums of plain loops about, at a tenth of the speed.
template<class Vector>
[[gnu::always_inline]] inline void multiplyRows(const double* rows, std::size_t n, const double* in, double* out)
{
    constexpr std::size_t width = lineGroup * sizeof(double) / sizeof(Vector);
    Vector sums[rowGroup][width] = {};
    for (std::size_t j = 0; j < n; ++j)
    {
        const auto* values = reinterpret_cast<const Vector*>(in + j * lineGroup);
        for (std::size_t r = 0; r < rowGroup; ++r)
        {
            for (std::size_t c = 0; c < width; ++c) { sums[r][c] += rows[j * rowGroup + r] * values[c]; }
        }
    }
    std::copy_n(&sums[0][0], rowGroup * width, reinterpret_cast<Vector*>(out));
}

using Two [[gnu::vector_size(16), gnu::may_alias]] = double;
void multiplyByTwo(const double* rows, std::size_t n, const double* in, double* out)
{
    multiplyRows<Two>(rows, n, in, out);
}

#if defined(__x86_64__)
using Four [[gnu::vector_size(32), gnu::may_alias]] = double;
[[gnu::target("fma")]] void multiplyByFour(const double* rows, std::size_t n, const double* in, double* out)
{
    multiplyRows<Four>(rows, n, in, out);
}
/// The fastest that this processor has.
auto productOfRows() { return __builtin_cpu_supports("fma") ? multiplyByFour : multiplyByTwo; }
#else
auto productOfRows() { return multiplyByTwo; }
#endif

/// A second derivative with its ends eliminated: matrix u + response data; the ends are unit data - rows u.
struct ClosedLine
{
    Matrix matrix;
    Matrix response;
    Matrix unit;
    Matrix rows;
};

/// With C u_ends + R u = G data at the points of ends that are not free; data are of the low and the high end.
ClosedLine closedLine(const Derivatives& derivatives, Index first, Index count, const std::vector<Index>& points,
                      const std::array<LineEnd, 2>& conditions)
{
    const auto e = static_cast<Index>(points.size());
    Matrix C = Matrix::Identity(e, e);
    Matrix R = Matrix::Zero(e, count);
    Matrix G = Matrix::Zero(e, 2);
    Matrix fromEnds(count, e);
    ClosedLine line;
    line.response = derivatives.secondOfData.middleRows(first, count);
    for (Index i = 0; i < e; ++i)
    {
        const Index point = points[static_cast<std::size_t>(i)];
        const Index side = point == 0 ? 0 : 1;
        fromEnds.col(i) = derivatives.second.col(point).segment(first, count);
        if (conditions[static_cast<std::size_t>(side)] == LineEnd::slope)
        {
            for (Index j = 0; j < e; ++j) { C(i, j) = derivatives.first(point, points[static_cast<std::size_t>(j)]); }
            R.row(i) = derivatives.first.row(point).segment(first, count);
            G.row(i) = -derivatives.firstOfData.row(point);
        }
        G(i, side) = 1;
        line.response.col(side).setZero();
    }
    line.unit = C.inverse() * G;
    line.rows = C.inverse() * R;
    line.response += fromEnds * line.unit;
    line.matrix = derivatives.second.block(first, first, count, count) - fromEnds * line.rows;
    return line;
}

/// What a matrix does to even and to odd values, given by their first halves; the matrix alone if its ends differ.
std::vector<Matrix> evenAndOdd(const Matrix& matrix)
{
    const Matrix reversed = matrix.reverse();
    const bool alike = (matrix - reversed).cwiseAbs().maxCoeff() < 1e-6 * matrix.cwiseAbs().maxCoeff();
    const Index odd = matrix.rows() / 2;
    if (!alike || odd == 0) { return {matrix}; }
    const Index even = matrix.rows() - odd;
    const Matrix own = 0.5 * (matrix + reversed); // without the difference of round-off
    const Matrix mirrored = own.rowwise().reverse();
    Matrix ofEven = own.topLeftCorner(even, even);
    ofEven.leftCols(odd) += mirrored.topLeftCorner(even, odd);
    return {ofEven, own.topLeftCorner(odd, odd) - mirrored.topLeftCorner(odd, odd)};
}

} // namespace

LineEigenbasis::LineEigenbasis(const LineLayout& layout, const LineContinuation& continuation, const LineSymbol& symbol,
                               LineEnd low, LineEnd high, double dataScale)
    : layout_(layout),
      first_(low == LineEnd::free ? 0 : 1),
      count_(layout.count - first_ - (high == LineEnd::free ? 0 : 1))
{
    assert(layout.count == static_cast<std::size_t>(continuation.points()));
    if (layout.count < 3)
    {
        throw Error(Fault::input, fmt::format("a line between walls has only {} points", layout.count),
                    "give it at least three");
    }
    std::vector<Index> points;
    if (low != LineEnd::free) { points.push_back(0); }
    if (high != LineEnd::free) { points.push_back(static_cast<Index>(layout.count - 1)); }
    const ClosedLine line = closedLine(matricesOf(continuation, symbol, dataScale), static_cast<Index>(first_),
                                       static_cast<Index>(count_), points, {low, high});
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const auto at = static_cast<Index>(i);
        FixedEnd end{.point = static_cast<std::size_t>(points[i]), .unit = {line.unit(at, 0), line.unit(at, 1)}};
        if (!line.rows.row(at).isZero(0)) { end.row.assign(line.rows.row(at).begin(), line.rows.row(at).end()); }
        ends_.push_back(std::move(end));
    }
    for (Index side = 0; side < 2; ++side)
    {
        const auto column = line.response.col(side);
        if (!column.isZero(0)) { response_[static_cast<std::size_t>(side)].assign(column.begin(), column.end()); }
    }

    // Where values are given, the row beside them misses a good part of its largest entry.
    constantMode_ = line.matrix.rowwise().sum().cwiseAbs().maxCoeff() < 1e-4 * line.matrix.cwiseAbs().maxCoeff();
    const std::vector<Matrix> parts = evenAndOdd(line.matrix);
    double largest = 0;
    double smallest = 1;
    for (const Matrix& part : parts)
    {
        Spectrum spectrum = spectrumOf(part, line.matrix.rows());
        if (constantMode_ && blocks_.empty())
        {
            spectrum.values[0] = 0;
            spectrum.vectors.col(0).setOnes();
        }
        const bool middle = parts.size() == 2 && part.rows() > parts[1].rows();
        const auto [most, least] = singularValues(spectrum.vectors, parts.size() == 2 ? std::sqrt(2.0) : 1, middle);
        largest = std::max(largest, most);
        smallest = std::min(smallest, least);
        eigenvalues_.insert(eigenvalues_.end(), spectrum.values.begin(), spectrum.values.end());
        blocks_.push_back(
            {static_cast<std::size_t>(part.rows()), packed(spectrum.vectors.inverse()), packed(spectrum.vectors)});
    }
    condition_ = largest / smallest;
    if (!(condition_ < 1e6)) { refuse(line.matrix.rows(), "has eigenvectors that are almost dependent"); }
    panelSize_ = roundedUp(count_ + rowGroup, rowGroup) * lineGroup;
    panel_.resize(panelSize_ * largestBatch / lineGroup);
    product_.resize(panel_.size());
}

/// Where the value of an unknown point stands before even and odd parts are taken: beside its mirror image.
std::size_t LineEigenbasis::rowOf(std::size_t i) const
{
    const std::size_t even = blocks_[0].size;
    return i < even ? i : even + (count_ - 1 - i);
}

template<class Visit>
void LineEigenbasis::forPoints(std::size_t line, std::size_t lines, Visit visit) const
{
    for (std::size_t l = 0; l < lines;)
    {
        const std::size_t together =
            std::min({lines - l, layout_.inner - (line + l) % layout_.inner, lineGroup - l % lineGroup});
        const std::size_t start = layout_.start(line + l) + first_ * layout_.inner;
        const std::size_t place = l / lineGroup * panelSize_ + l % lineGroup;
        for (std::size_t i = 0; i < count_; ++i)
        {
            for (std::size_t t = 0; t < together; ++t) { visit(start + i * layout_.inner + t, i, place + t); }
        }
        l += together;
    }
}

/// (a, b) -> factor (a + b, a - b) for the points that are beside their images.
void LineEigenbasis::foldPairs(double factor, AlignedVector<double>& panel) const
{
    if (blocks_.size() == 1) { return; }
    const std::size_t pairs = blocks_[1].size * lineGroup;
    for (std::size_t group = 0; group < panel.size(); group += panelSize_)
    {
        double* a = panel.data() + group;
        double* b = a + blocks_[0].size * lineGroup;
        for (std::size_t i = 0; i < pairs; ++i)
        {
            const double sum = a[i] + b[i];
            b[i] = factor * (a[i] - b[i]);
            a[i] = factor * sum;
        }
    }
}

void LineEigenbasis::multiply(AlignedVector<double> Block::*matrix, std::size_t lines)
{
    const auto multiplyGroup = productOfRows();
    std::size_t before = 0;
    for (const Block& block : blocks_)
    {
        const std::size_t n = block.size;
        for (std::size_t i = 0; i < n; i += rowGroup)
        {
            // Rows beyond the block are zeros that the next block overwrites.
            for (std::size_t l = 0; l < lines; l += lineGroup)
            {
                const std::size_t panel = l / lineGroup * panelSize_;
                multiplyGroup((block.*matrix).data() + i * n, n, panel_.data() + panel + before * lineGroup,
                              product_.data() + panel + (before + i) * lineGroup);
            }
        }
        before += n;
    }
}

void LineEigenbasis::forward(std::span<double> values)
{
    for (std::size_t line = 0; line < layout_.lines(); line += largestBatch)
    {
        const std::size_t lines = std::min(largestBatch, layout_.lines() - line);
        forPoints(line, lines,
                  [&](std::size_t point, std::size_t i, std::size_t place)
                  { panel_[place + rowOf(i) * lineGroup] = values[point]; });
        foldPairs(0.5, panel_);
        multiply(&Block::toModes, lines);
        forPoints(line, lines,
                  [&](std::size_t point, std::size_t i, std::size_t place)
                  { values[point] = product_[place + i * lineGroup]; });
    }
}

void LineEigenbasis::backward(std::span<double> values)
{
    for (std::size_t line = 0; line < layout_.lines(); line += largestBatch)
    {
        const std::size_t lines = std::min(largestBatch, layout_.lines() - line);
        forPoints(line, lines,
                  [&](std::size_t point, std::size_t i, std::size_t place)
                  { panel_[place + i * lineGroup] = values[point]; });
        multiply(&Block::toValues, lines);
        foldPairs(1, product_);
        forPoints(line, lines,
                  [&](std::size_t point, std::size_t i, std::size_t place)
                  { values[point] = product_[place + rowOf(i) * lineGroup]; });
    }
}

void LineEigenbasis::addData(double factor, std::span<const double> low, std::span<const double> high,
                             std::span<double> values) const
{
    for (const std::size_t side : {0, 1})
    {
        const std::span<const double> data = side == 0 ? low : high;
        const AlignedVector<double>& response = response_[side];
        if (data.empty() || response.empty()) { continue; }
        for (std::size_t o = 0; o < layout_.outer; ++o)
        {
            const double* datum = data.data() + o * layout_.inner;
            for (std::size_t i = 0; i < count_; ++i)
            {
                double* row = values.data() + (o * layout_.count + first_ + i) * layout_.inner;
                const double scale = factor * response[i];
                for (std::size_t l = 0; l < layout_.inner; ++l) { row[l] += scale * datum[l]; }
            }
        }
    }
}

void LineEigenbasis::fillEnds(std::span<const double> low, std::span<const double> high, std::span<double> values) const
{
    for (const FixedEnd& end : ends_)
    {
        for (std::size_t o = 0; o < layout_.outer; ++o)
        {
            const std::size_t line = o * layout_.inner;
            double* value = values.data() + (o * layout_.count + end.point) * layout_.inner;
            for (std::size_t l = 0; l < layout_.inner; ++l)
            {
                value[l] =
                    (low.empty() ? 0 : end.unit[0] * low[line + l]) + (high.empty() ? 0 : end.unit[1] * high[line + l]);
            }
            if (end.row.empty()) { continue; }
            for (std::size_t i = 0; i < count_; ++i)
            {
                const double* row = values.data() + (o * layout_.count + first_ + i) * layout_.inner;
                for (std::size_t l = 0; l < layout_.inner; ++l) { value[l] -= end.row[i] * row[l]; }
            }
        }
    }
}

} // namespace isph
