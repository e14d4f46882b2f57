#include "poisson/MorrisSystem.hpp"

#include "core/Error.hpp"
#include "fields/reductions.hpp"
#include "poisson/MirroredAxis.hpp"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

namespace isph
{

namespace
{

using Place = std::array<int, 3>;

constexpr double entryBytes = 12; ///< a value and a column

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The entries of one row, gathered one by one and sorted at its end.
class Rows
{
public:
    Rows(std::size_t columns, std::size_t rows, std::size_t entries) : columns_(columns), slot_(columns, none)
    {
        starts_.reserve(rows + 1);
        starts_.push_back(0);
        indices_.reserve(entries);
        values_.reserve(entries);
    }

    void add(std::size_t column, double value)
    {
        int& slot = slot_[column];
        if (slot == none)
        {
            slot = static_cast<int>(row_.size());
            row_.emplace_back(static_cast<int>(column), value);
            return;
        }
        row_[at(slot)].second += value;
    }

    void endRow()
    {
        const auto byColumn = [](const auto& a, const auto& b) { return a.first < b.first; };
        if (!std::ranges::is_sorted(row_, byColumn)) { std::ranges::sort(row_, byColumn); }
        for (const auto& [column, value] : row_)
        {
            indices_.push_back(column);
            values_.push_back(value);
            slot_[at(column)] = none;
        }
        row_.clear();
        starts_.push_back(static_cast<int>(values_.size()));
    }

    SparseMatrix matrix() { return {columns_, std::move(starts_), std::move(indices_), std::move(values_)}; }

private:
    static constexpr int none = -1;

    std::size_t columns_;
    std::vector<int> slot_; ///< of a column in the row
    std::vector<std::pair<int, double>> row_;
    AlignedVector<int> starts_;
    AlignedVector<int> indices_;
    AlignedVector<double> values_;
};

} // namespace

std::array<AxisEnds, 3> wallEnds(const Lattice& lattice)
{
    std::array<AxisEnds, 3> ends{};
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        if (!lattice.activeAxis(d).periodic()) { ends[at(lattice.direction(d))] = {End::neumann, End::neumann}; }
    }
    return ends;
}

/// What is needed while rows are made. Axes are those of directions x, y, z; one left out has one point.
struct MirrorData::Assembly
{
    Assembly(MirrorData& target, const Lattice& lattice, const KernelSamples& samples,
             const std::array<AxisEnds, 3>& ends, bool withMatrix);

    std::size_t point(const Place& p) const { return at(p[0]) + at(counts[0]) * (at(p[1]) + at(counts[1]) * at(p[2])); }
    const MirrorImage& image(std::size_t d, int place) const { return images[d][at(place + reach)]; }
    std::size_t datum(std::size_t d, std::size_t end, const Place& p) const;

    void addNeighbour(const Place& p, double weight);
    void fold(std::size_t step, const Place& p, double weight);
    void addFixed(const Place& p, double weight);
    bool isFixed(const Place& p) const;
    bool plain(const Place& p) const;
    bool nearEnd(const Place& p) const;
    void makeRow(const Place& p);

    MirrorData& system;
    std::array<int, 3> counts{1, 1, 1};
    int reach = 0;
    std::vector<MirroredAxis> axes;
    std::array<const MirroredAxis*, 3> axisOf{};      ///< by direction
    std::array<std::vector<MirrorImage>, 3> images;   ///< from -reach to count - 1 + reach
    std::vector<std::size_t> order;                   ///< in which axes are folded
    std::vector<std::pair<Place, double>> neighbours; ///< offsets and entries
    std::optional<Rows> matrix;
    Rows data;
};

namespace
{

int reachOf(const KernelSamples& samples)
{
    int reach = 0;
    for (const auto& offset : samples.offsets)
    {
        for (const int step : offset) { reach = std::max(reach, std::abs(step)); }
    }
    return reach;
}

/// Points of all faces that are walls.
std::size_t facesOf(const Lattice& lattice)
{
    std::size_t points = 0;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const Axis& axis = lattice.activeAxis(d);
        if (!axis.periodic()) { points += 2 * (lattice.points() / at(axis.count)); }
    }
    return points;
}

/// Points whose neighbours lie beyond a point of a face, at most: as many as a kernel has neighbours on one side.
std::size_t dataEntries(const Lattice& lattice, std::size_t neighbours) { return facesOf(lattice) * (neighbours / 2); }

} // namespace

MirrorData::Assembly::Assembly(MirrorData& target, const Lattice& lattice, const KernelSamples& samples,
                               const std::array<AxisEnds, 3>& ends, bool withMatrix)
    : system(target),
      reach(reachOf(samples)),
      data(facesOf(lattice), lattice.points(), dataEntries(lattice, samples.offsets.size()))
{
    if (withMatrix)
    {
        requireCountable(lattice, samples);
        matrix.emplace(lattice.points(), lattice.points(), lattice.points() * samples.offsets.size());
    }
    axes.reserve(3);
    std::size_t first = 0;
    for (int active = 0; active < lattice.dimensions(); ++active)
    {
        const std::size_t d = at(lattice.direction(active));
        const MirroredAxis& axis = axes.emplace_back(lattice.activeAxis(active), ends[d]);
        axisOf[d] = &axis;
        counts[d] = axis.count;
        for (int place = -reach; place < axis.count + reach; ++place) { images[d].push_back(axis.image(place)); }
        const bool values = axis.ends.low == End::dirichlet || axis.ends.high == End::dirichlet;
        system.constantMode_ = system.constantMode_ && !values;
        if (axis.ends.low == End::periodic) { continue; }
        system.facePoints_[d] = lattice.points() / at(axis.count);
        system.firstOfFace_[d] = {first, first + system.facePoints_[d]};
        first += 2 * system.facePoints_[d];
        // Values at faces are mirrored themselves, slopes only evenly: ends with values come first.
        order.insert(values ? order.begin() : order.end(), d);
    }
    for (std::size_t d = 0; d < 3; ++d)
    {
        if (axisOf[d] == nullptr) { images[d].resize(at(2 * reach + 1)); }
    }
    for (std::size_t b = 0; b < samples.offsets.size(); ++b)
    {
        // Neighbours on the rim of a spline have no weight.
        if (samples.laplacian[b] == 0) { continue; }
        Place offset{0, 0, 0};
        for (int d = 0; d < lattice.dimensions(); ++d) { offset[at(lattice.direction(d))] = samples.offsets[b][at(d)]; }
        neighbours.emplace_back(offset, -samples.laplacian[b]);
        if (offset == Place{0, 0, 0}) { system.diagonal_ = -samples.laplacian[b]; }
    }
}

bool MirrorData::Assembly::nearEnd(const Place& p) const
{
    return std::ranges::any_of(order, [&](std::size_t d) { return p[d] <= reach || p[d] + reach + 1 >= counts[d]; });
}

std::size_t MirrorData::Assembly::datum(std::size_t d, std::size_t end, const Place& p) const
{
    // Places along axes still to be folded may lie outside: data are mirrored evenly.
    std::size_t index = 0;
    std::size_t stride = 1;
    for (std::size_t other = 0; other < 3; ++other)
    {
        if (other == d) { continue; }
        index += stride * at(image(other, p[other]).point);
        stride *= at(counts[other]);
    }
    return system.firstOfFace_[d][end] + index;
}

bool MirrorData::Assembly::isFixed(const Place& p) const
{
    return std::ranges::any_of(order, [&](std::size_t d) { return axisOf[d]->fixed(p[d]); });
}

bool MirrorData::Assembly::plain(const Place& p) const
{
    for (std::size_t d = 0; d < 3; ++d)
    {
        if (p[d] < 0 || p[d] >= counts[d]) { return false; }
    }
    return !isFixed(p);
}

void MirrorData::Assembly::addFixed(const Place& p, double weight)
{
    // Of points on several faces the values of the last direction hold.
    for (std::size_t d = 3; d-- > 0;)
    {
        if (axisOf[d] == nullptr || !axisOf[d]->fixed(p[d])) { continue; }
        data.add(datum(d, p[d] == 0 ? 0 : 1, p), weight);
        return;
    }
}

void MirrorData::Assembly::fold(std::size_t step, const Place& p, double weight)
{
    if (step == order.size())
    {
        if (isFixed(p)) { addFixed(p, weight); }
        else if (matrix) { matrix->add(point(p), weight); }
        return;
    }
    const std::size_t d = order[step];
    const MirrorImage& mirrored = image(d, p[d]);
    const auto continueAt = [&](int place, double factor)
    {
        Place folded = p;
        folded[d] = place;
        if (factor != 0) { fold(step + 1, folded, weight * factor); }
    };
    continueAt(mirrored.point, mirrored.sign);
    continueAt(0, mirrored.lowPoint);
    continueAt(counts[d] - 1, mirrored.highPoint);
    if (mirrored.lowData != 0) { data.add(datum(d, 0, p), weight * mirrored.lowData); }
    if (mirrored.highData != 0) { data.add(datum(d, 1, p), weight * mirrored.highData); }
}

void MirrorData::Assembly::addNeighbour(const Place& p, double weight)
{
    if (plain(p))
    {
        if (matrix) { matrix->add(point(p), weight); }
        return;
    }
    Place inBox = p;
    for (std::size_t d = 0; d < 3; ++d)
    {
        if (axisOf[d] != nullptr && axisOf[d]->ends.low == End::periodic) { inBox[d] = image(d, p[d]).point; }
    }
    fold(0, inBox, weight);
}

void MirrorData::Assembly::makeRow(const Place& p)
{
    if (isFixed(p))
    {
        system.fixed_.push_back(point(p));
        if (matrix) { matrix->add(point(p), system.diagonal_); }
        addFixed(p, -system.diagonal_);
    }
    else if (matrix || nearEnd(p))
    {
        for (const auto& [offset, weight] : neighbours)
        {
            addNeighbour({p[0] + offset[0], p[1] + offset[1], p[2] + offset[2]}, weight);
        }
    }
    if (matrix) { matrix->endRow(); }
    data.endRow();
}

MirrorData::MirrorData(const Lattice& lattice, const KernelSamples& samples, const std::array<AxisEnds, 3>& ends)
    : MirrorData(lattice, samples, ends, false)
{
}

MirrorData::MirrorData(const Lattice& lattice, const KernelSamples& samples, const std::array<AxisEnds, 3>& ends,
                       bool withMatrix)
{
    Assembly assembly(*this, lattice, samples, ends, withMatrix);
    Place p{0, 0, 0};
    for (p[2] = 0; p[2] < assembly.counts[2]; ++p[2])
    {
        for (p[1] = 0; p[1] < assembly.counts[1]; ++p[1])
        {
            for (p[0] = 0; p[0] < assembly.counts[0]; ++p[0]) { assembly.makeRow(p); }
        }
    }
    if (withMatrix) { matrix_ = assembly.matrix->matrix(); }
    totalWeight_ = static_cast<double>(lattice.points());
    if (assembly.order.empty()) { return; }
    ofData_ = assembly.data.matrix();
    data_.resize(ofData_.columns());
    supplied_.resize(lattice.points());
    weigh(assembly);
}

void MirrorData::weigh(const Assembly& assembly)
{
    weights_.assign(supplied_.size(), 1.0);
    for (std::size_t n = 0; n < weights_.size(); ++n)
    {
        std::size_t rest = n;
        for (std::size_t d = 0; d < 3; ++d)
        {
            const int place = static_cast<int>(rest % at(assembly.counts[d]));
            rest /= at(assembly.counts[d]);
            const MirroredAxis* axis = assembly.axisOf[d];
            if (axis == nullptr || axis->staggered || axis->ends.low == End::periodic) { continue; }
            if (place == 0 || place == axis->count - 1) { weights_[n] *= 0.5; }
        }
    }
    totalWeight_ = sum(weights_);
}

double MirrorData::rightHandSide(std::span<const double> source, const WallData& walls, std::span<double> result)
{
    std::ranges::transform(source, result.begin(), [](double value) { return -value; });
    for (const std::size_t point : fixed_) { result[point] = 0; }
    const bool given = std::ranges::any_of(walls, [](const FaceValues& values)
                                           { return !values.low.empty() || !values.high.empty(); });
    if (given && !data_.empty())
    {
        const auto take = [this](std::span<const double> values, std::size_t first, std::size_t count)
        {
            assert(values.empty() || values.size() == count);
            const auto target = std::span(data_).subspan(first, count);
            if (values.empty()) { std::ranges::fill(target, 0.0); }
            else { std::ranges::copy(values, target.begin()); }
        };
        for (std::size_t d = 0; d < 3; ++d)
        {
            take(walls[d].low, firstOfFace_[d][0], facePoints_[d]);
            take(walls[d].high, firstOfFace_[d][1], facePoints_[d]);
        }
        ofData_.apply(data_, supplied_);
        for (std::size_t i = 0; i < result.size(); ++i) { result[i] -= supplied_[i]; }
    }
    if (!constantMode_) { return 0; }
    const double mean = (weights_.empty() ? sum(result) : sumOfProducts(result, weights_)) / totalWeight_;
    for (double& value : result) { value -= mean; }
    return -mean;
}

void requireCountable(const Lattice& lattice, const KernelSamples& samples)
{
    const double entries = static_cast<double>(lattice.points()) * static_cast<double>(samples.offsets.size());
    if (entries < SparseMatrix::mostEntries) { return; }
    throw Error(Fault::input, "the matrix of the pressure would have more than 2147 million entries",
                "write solver fft; which needs no matrix, or take fewer points or a smaller supportRadius");
}

double morrisSystemBytes(const Lattice& lattice, std::size_t neighbours)
{
    return entryBytes * static_cast<double>(lattice.points()) * static_cast<double>(neighbours);
}

double mirrorDataBytes(const Lattice& lattice, std::size_t neighbours)
{
    return entryBytes * static_cast<double>(dataEntries(lattice, neighbours));
}

} // namespace isph
