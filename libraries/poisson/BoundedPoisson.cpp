#include "poisson/BoundedPoisson.hpp"

#include "poisson/DirichletEdge.hpp"
#include "poisson/WallResponse.hpp"

#include <algorithm>
#include <cassert>
#include <optional>
#include <stdexcept>
#include <vector>

namespace isph
{

namespace
{

std::array<std::size_t, 3> sizesOf(const std::array<int, 3>& extents)
{
    return {static_cast<std::size_t>(extents[0]), static_cast<std::size_t>(extents[1]),
            static_cast<std::size_t>(extents[2])};
}

/// Modes of values at both faces of an axis.
struct FaceModes
{
    AlignedVector<double> low;
    AlignedVector<double> high;
};

} // namespace

struct BoundedPoisson::Parts
{
    /// What belongs to an active axis.
    struct Direction
    {
        Direction(int direction, const BoundedAxis& modes) : d(static_cast<std::size_t>(direction)), axis(modes) {}

        std::size_t d;
        BoundedAxis axis;
        std::optional<RealTransform> transform;
        std::vector<RealTransform> tangential; ///< of the faces of a bounded axis
        std::optional<WallResponse> response;
        FaceModes walls;
        FaceModes source;
        bool wallsGiven = false;
        bool sourceGiven = false;
        double meanFactor = 1; ///< of the tangential transforms
    };

    std::array<std::size_t, 3> extents;
    std::array<std::size_t, 3> first{0, 0, 0}; ///< modes in use
    std::array<std::size_t, 3> end{1, 1, 1};
    std::vector<Direction> directions;
    std::vector<DirichletEdge> edges;
    bool edgesGiven = false;
    AlignedVector<double> unused{0.0}; ///< k2 and eigenvalue of an axis left out
    double scale = 1;
    bool constantMode = true;

    std::size_t offset(std::size_t j, std::size_t k) const { return extents[0] * (j + extents[1] * k); }
    const AlignedVector<double>& tableOf(std::size_t d, AlignedVector<double> BoundedAxis::*table) const;

    void planFaces(const std::array<int, 3>& counts, Direction& direction, PlanEffort effort);
    void planEdges(const std::array<int, 3>& counts, PlanEffort effort);
    void transformFace(const Direction& direction, std::span<const double> values, AlignedVector<double>& modes) const;
    void readWalls(const WallData& walls);
    void readEdges(const WallData& walls);
    Direction& directionOf(std::size_t d);
    void divide(std::span<double> modes) const;
    void addWalls(const Direction& direction, std::span<double> modes) const;
    void addClosure(const Direction& direction, std::span<double> modes) const;
    void writeFixed(const Direction& direction, const FaceValues& values, std::span<double> phi) const;
    double excess(double meanMode) const;
    void differentiate(const Direction& direction, std::span<const double> modes, const PeriodicSlope& slope) const;
    double solve(const RealField& source, const WallData& walls, RealField& phi, const PeriodicSlope* slope);

    /// Calls visit(mode, index on the axis, tangential mode) for all modes.
    template<class Visit>
    void forModes(const Direction& direction, Visit visit) const
    {
        for (std::size_t k = first[2]; k < end[2]; ++k)
        {
            for (std::size_t j = first[1]; j < end[1]; ++j)
            {
                const std::size_t row = offset(j, k);
                // One loop for each axis: in each either the axis' or the tangential tables are constant.
                if (direction.d == 0)
                {
                    for (std::size_t i = first[0]; i < end[0]; ++i) { visit(row + i, i, j + extents[1] * k); }
                }
                else
                {
                    const std::size_t index = direction.d == 1 ? j : k;
                    const std::size_t tangential = extents[0] * (direction.d == 1 ? k : j);
                    for (std::size_t i = first[0]; i < end[0]; ++i) { visit(row + i, index, tangential + i); }
                }
            }
        }
    }
};

BoundedPoisson::BoundedPoisson(const Lattice& lattice, const std::array<AxisEnds, 3>& ends, PlanEffort effort,
                               const AxisSymbol& symbol)
    : parts_(std::make_unique<Parts>())
{
    const std::array<int, 3> counts{lattice.axis(0).count, lattice.axis(1).count, lattice.axis(2).count};
    parts_->extents = sizesOf(counts);
    for (int a = 0; a < lattice.dimensions(); ++a)
    {
        const int d = lattice.direction(a);
        const auto index = static_cast<std::size_t>(d);
        Parts::Direction direction(d, BoundedAxis(lattice.axis(d), ends[index], symbol));
        const BoundedAxis& axis = direction.axis;
        direction.transform.emplace(Lines{counts, d, static_cast<int>(axis.first), static_cast<int>(axis.count)},
                                    axis.basis, effort);
        parts_->scale /= direction.transform->factor();
        parts_->first[index] = axis.first;
        parts_->end[index] = axis.first + axis.count;
        parts_->constantMode = parts_->constantMode && axis.constantMode();
        parts_->directions.push_back(std::move(direction));
    }
    for (auto& direction : parts_->directions)
    {
        if (direction.axis.bounded()) { parts_->planFaces(counts, direction, effort); }
    }
    parts_->planEdges(counts, effort);
}

BoundedPoisson::~BoundedPoisson() = default;
BoundedPoisson::BoundedPoisson(BoundedPoisson&&) noexcept = default;
BoundedPoisson& BoundedPoisson::operator=(BoundedPoisson&&) noexcept = default;

const AlignedVector<double>& BoundedPoisson::Parts::tableOf(std::size_t d,
                                                            AlignedVector<double> BoundedAxis::*table) const
{
    for (const auto& direction : directions)
    {
        if (direction.d == d) { return direction.axis.*table; }
    }
    return unused;
}

void BoundedPoisson::Parts::planFaces(const std::array<int, 3>& counts, Direction& direction, PlanEffort effort)
{
    std::array<int, 3> face = counts;
    face[direction.d] = 1;
    for (const auto& other : directions)
    {
        if (other.d == direction.d) { continue; }
        const Lines lines{face, static_cast<int>(other.d), static_cast<int>(other.axis.first),
                          static_cast<int>(other.axis.count)};
        direction.tangential.emplace_back(lines, other.axis.basis, effort);
        direction.meanFactor *= direction.tangential.back().factor();
    }

    const auto sizes = sizesOf(face);
    AlignedVector<double> kappa2;
    std::array<const AlignedVector<double>*, 3> k2{};
    for (std::size_t d = 0; d < 3; ++d) { k2[d] = d == direction.d ? &unused : &tableOf(d, &BoundedAxis::k2); }
    for (std::size_t k = 0; k < sizes[2]; ++k)
    {
        for (std::size_t j = 0; j < sizes[1]; ++j)
        {
            for (std::size_t i = 0; i < sizes[0]; ++i) { kappa2.push_back((*k2[0])[i] + (*k2[1])[j] + (*k2[2])[k]); }
        }
    }
    for (FaceModes* modes : {&direction.walls, &direction.source})
    {
        modes->low.resize(kappa2.size());
        modes->high.resize(kappa2.size());
    }
    direction.response.emplace(direction.axis, std::move(kappa2));
}

void BoundedPoisson::Parts::planEdges(const std::array<int, 3>& counts, PlanEffort effort)
{
    std::array<const BoundedAxis*, 3> axes{};
    std::vector<DirichletEdge::Face> faces;
    for (const auto& direction : directions)
    {
        const BoundedAxis& axis = direction.axis;
        axes[direction.d] = &axis;
        if (axis.ends.low == End::dirichlet) { faces.push_back({direction.d, false, axis.fixedLow()}); }
        if (axis.ends.high == End::dirichlet) { faces.push_back({direction.d, true, axis.fixedHigh()}); }
    }
    for (const auto& a : faces)
    {
        for (const auto& b : faces)
        {
            // On staggered points no face's values reach the edge.
            if (a.d < b.d && (a.onPoints || b.onPoints)) { edges.emplace_back(counts, axes, a, b, effort); }
        }
    }
}

void BoundedPoisson::Parts::transformFace(const Direction& direction, std::span<const double> values,
                                          AlignedVector<double>& modes) const
{
    if (values.empty())
    {
        std::fill(modes.begin(), modes.end(), 0.0);
        return;
    }
    assert(values.size() == modes.size());
    std::copy(values.begin(), values.end(), modes.begin());
    for (const auto& transform : direction.tangential) { transform.forward(modes); }
}

BoundedPoisson::Parts::Direction& BoundedPoisson::Parts::directionOf(std::size_t d)
{
    return *std::find_if(directions.begin(), directions.end(), [d](const Direction& other) { return other.d == d; });
}

void BoundedPoisson::Parts::readWalls(const WallData& walls)
{
    edgesGiven = false;
    for (auto& direction : directions)
    {
        const FaceValues& values = walls[direction.d];
        direction.wallsGiven = direction.axis.bounded() && !(values.low.empty() && values.high.empty());
        edgesGiven = edgesGiven || (direction.wallsGiven && !edges.empty());
    }
    for (auto& direction : directions)
    {
        // Values at an edge concern the face that was given none, too.
        direction.wallsGiven = direction.wallsGiven || (edgesGiven && direction.axis.bounded());
        if (!direction.wallsGiven) { continue; }
        transformFace(direction, walls[direction.d].low, direction.walls.low);
        transformFace(direction, walls[direction.d].high, direction.walls.high);
    }
    if (edgesGiven) { readEdges(walls); }
}

void BoundedPoisson::Parts::readEdges(const WallData& walls)
{
    const auto given = [&](const DirichletEdge::Face& face)
    { return face.high ? walls[face.d].high : walls[face.d].low; };
    for (auto& edge : edges)
    {
        const auto& faces = edge.faces();
        edge.read(given(faces[0]), given(faces[1]));
        for (std::size_t f = 0; f < 2; ++f)
        {
            FaceModes& modes = directionOf(faces[f].d).walls;
            edge.subtractFrom(f, faces[f].high ? modes.high : modes.low);
        }
    }
}

void BoundedPoisson::Parts::divide(std::span<double> modes) const
{
    std::array<const AlignedVector<double>*, 3> k2{};
    std::array<const AlignedVector<double>*, 3> eigenvalue{};
    for (std::size_t d = 0; d < 3; ++d)
    {
        k2[d] = &tableOf(d, &BoundedAxis::k2);
        eigenvalue[d] = &tableOf(d, &BoundedAxis::eigenvalue);
    }
    for (std::size_t k = first[2]; k < end[2]; ++k)
    {
        for (std::size_t j = first[1]; j < end[1]; ++j)
        {
            double* row = modes.data() + offset(j, k);
            const double k2OfRow = (*k2[1])[j] + (*k2[2])[k];
            const double eigenvalueOfRow = (*eigenvalue[1])[j] + (*eigenvalue[2])[k];
            for (std::size_t i = first[0]; i < end[0]; ++i)
            {
                // A null mode is judged by its own wave vector, as in invertedEigenvalues.
                const double value = (*eigenvalue[0])[i] + eigenvalueOfRow;
                const double least = 1e-24 * ((*k2[0])[i] + k2OfRow);
                row[i] = value > least ? -row[i] / value : 0;
            }
        }
    }
}

void BoundedPoisson::Parts::addWalls(const Direction& direction, std::span<double> modes) const
{
    const WallResponse& response = *direction.response;
    const BoundedAxis& axis = direction.axis;
    forModes(direction,
             [&](std::size_t mode, std::size_t i, std::size_t t)
             {
                 modes[mode] += (axis.low[i] * direction.walls.low[t] + axis.high[i] * direction.walls.high[t]) /
                                response.denominator(t, axis.sine2[i]);
             });
}

void BoundedPoisson::Parts::addClosure(const Direction& direction, std::span<double> modes) const
{
    const WallResponse& response = *direction.response;
    const BoundedAxis& axis = direction.axis;
    forModes(direction,
             [&](std::size_t mode, std::size_t i, std::size_t t)
             {
                 modes[mode] += axis.low[i] * direction.source.low[t] * response.closureLow(t, i) +
                                axis.high[i] * direction.source.high[t] * response.closureHigh(t, i);
             });
}

void BoundedPoisson::Parts::writeFixed(const Direction& direction, const FaceValues& values,
                                       std::span<double> phi) const
{
    const auto write = [&](std::size_t at, std::span<const double> face)
    {
        std::array<std::size_t, 3> begin{0, 0, 0};
        std::array<std::size_t, 3> stop = extents;
        begin[direction.d] = at;
        stop[direction.d] = at + 1;
        std::size_t n = 0;
        for (std::size_t k = begin[2]; k < stop[2]; ++k)
        {
            for (std::size_t j = begin[1]; j < stop[1]; ++j)
            {
                for (std::size_t i = begin[0]; i < stop[0]; ++i)
                {
                    phi[offset(j, k) + i] = face.empty() ? 0 : face[n];
                    ++n;
                }
            }
        }
    };
    if (direction.axis.fixedLow()) { write(0, values.low); }
    if (direction.axis.fixedHigh()) { write(direction.axis.points - 1, values.high); }
}

double BoundedPoisson::Parts::excess(double meanMode) const
{
    double mean = meanMode * scale;
    for (const auto& direction : directions)
    {
        if (!direction.wallsGiven) { continue; }
        mean -= (direction.walls.high[0] - direction.walls.low[0]) / (direction.meanFactor * direction.axis.extent);
    }
    return mean;
}

void BoundedPoisson::Parts::differentiate(const Direction& direction, std::span<const double> modes,
                                          const PeriodicSlope& slope) const
{
    // A series has its real parts first, at m, and the imaginary ones from the end, at n - m.
    const std::size_t n = direction.axis.points;
    const std::size_t stride = direction.d == 0 ? 1 : direction.d == 1 ? extents[0] : extents[0] * extents[1];
    forModes(direction,
             [&](std::size_t mode, std::size_t i, std::size_t)
             {
                 const std::size_t m = std::min(i, n - i);
                 const std::size_t partner = mode - i * stride + (n - i) % n * stride;
                 const bool alone = m == 0 || 2 * m == n;
                 slope.values[mode] = alone ? 0 : (i == m ? -slope.symbol[m] : slope.symbol[m]) * modes[partner];
             });
}

double BoundedPoisson::Parts::solve(const RealField& source, const WallData& walls, RealField& phi,
                                    const PeriodicSlope* slope)
{
    const auto modes = phi[0];
    assert(source.size() == modes.size() && modes.size() == extents[0] * extents[1] * extents[2]);
    std::copy(source[0].begin(), source[0].end(), modes.begin());
    for (const auto& direction : directions) { direction.transform->forward(modes); }
    readWalls(walls);
    const double unbalanced = constantMode ? excess(modes[0]) : 0;

    divide(modes);
    for (auto& direction : directions)
    {
        if (direction.wallsGiven)
        {
            direction.response->scale(direction.walls.low, direction.walls.high);
            addWalls(direction, modes);
        }
        if (direction.sourceGiven) { addClosure(direction, modes); }
    }
    if (edgesGiven)
    {
        for (const auto& edge : edges) { edge.addTo(modes, first, end); }
    }
    // The response of the constant to a flux is its division by zero.
    if (constantMode) { modes[0] = 0; }

    for (double& value : modes) { value *= scale; }
    const auto differentiated = [slope](const Direction& direction)
    { return slope != nullptr && direction.d == static_cast<std::size_t>(slope->direction); };
    for (const auto& direction : directions)
    {
        if (!differentiated(direction)) { direction.transform->backward(modes); }
    }
    for (const auto& direction : directions)
    {
        if (!differentiated(direction)) { continue; }
        differentiate(direction, modes, *slope);
        direction.transform->backward(slope->values);
        direction.transform->backward(modes);
    }
    for (const auto& direction : directions) { writeFixed(direction, walls[direction.d], modes); }
    return unbalanced;
}

double BoundedPoisson::solve(const RealField& source, const WallData& walls, RealField& phi, const PeriodicSlope* slope)
{
    for (auto& direction : parts_->directions) { direction.sourceGiven = false; }
    return parts_->solve(source, walls, phi, slope);
}

double BoundedPoisson::solveClosed(const RealField& source, const WallData& walls, const FaceValues& sourceAtWalls,
                                   RealField& phi, const PeriodicSlope* slope)
{
    const auto bounded = [](const Parts::Direction& direction) { return direction.axis.bounded(); };
    auto& directions = parts_->directions;
    if (std::count_if(directions.begin(), directions.end(), bounded) != 1)
    {
        throw std::logic_error("BoundedPoisson::solveClosed: needs exactly one bounded axis");
    }
    auto& direction = *std::find_if(directions.begin(), directions.end(), bounded);
    direction.sourceGiven = true;
    parts_->transformFace(direction, sourceAtWalls.low, direction.source.low);
    parts_->transformFace(direction, sourceAtWalls.high, direction.source.high);
    return parts_->solve(source, walls, phi, slope);
}

} // namespace isph
