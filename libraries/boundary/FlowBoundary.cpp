#include "boundary/FlowBoundary.hpp"

#include "core/Error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <utility>

namespace isph
{

namespace
{

constexpr std::array<Side, 2> sides{Side::low, Side::high};

/// The two directions along a face, the one that is fastest in its data first.
std::array<int, 2> directionsAlong(int direction) { return {direction == 0 ? 1 : 0, direction == 2 ? 1 : 2}; }

bool isBounded(const Axis& axis) { return axis.active() && !axis.periodic(); }

std::array<double, 3> pointOf(const std::array<std::vector<double>, 3>& coordinates, std::size_t i)
{
    return {coordinates[0][i], coordinates[1][i], coordinates[2][i]};
}

void requireFinite(std::span<const double> values, const std::array<std::vector<double>, 3>& coordinates,
                   const std::string& patch, std::string_view quantity, double t)
{
    const auto wrong = std::ranges::find_if_not(values, [](double value) { return std::isfinite(value); });
    if (wrong == values.end()) { return; }
    const auto [x, y, z] = pointOf(coordinates, static_cast<std::size_t>(wrong - values.begin()));
    throw Error(Fault::input,
                fmt::format("the {} that patch {} prescribes is {} at ({:g} {:g} {:g}), t = {:g} s", quantity, patch,
                            *wrong, x, y, z, t),
                "look for a division by zero, or a root or logarithm of a negative number");
}

/// Weight of point i in an integral along an axis [m]; 1 for an axis left out.
///
/// The corrections near the ends make sums of polynomials up to the third degree exact: those of Gregory for points on
/// both ends, and their like for points half a spacing inside.
double weightOf(const Axis& axis, int i, FlowBoundary::Quadrature quadrature)
{
    constexpr std::array<double, 4> onEnds{251.0 / 720, 299.0 / 240, 211.0 / 240, 739.0 / 720};
    constexpr std::array<double, 4> inside{6463.0 / 5760, 1457.0 / 1920, 741.0 / 640, 5537.0 / 5760};
    if (!axis.active()) { return 1; }
    if (axis.periodic()) { return axis.spacing(); }
    const int fromEnd = std::min(i, axis.count - 1 - i);
    if (quadrature == FlowBoundary::Quadrature::endCorrected && axis.count >= 8)
    {
        return fromEnd < 4 ? (axis.staggered ? inside : onEnds)[static_cast<std::size_t>(fromEnd)] * axis.spacing()
                           : axis.spacing();
    }
    return (fromEnd == 0 && !axis.staggered ? 0.5 : 1) * axis.spacing();
}

} // namespace

FlowBoundary::FlowBoundary(const Lattice& lattice, std::array<std::array<FaceCondition, 2>, 3> faces)
    : lattice_(lattice)
{
    for (int direction = 0; direction < 3; ++direction)
    {
        for (const Side side : sides)
        {
            Face& face = faces_[at(direction)][at(side)];
            face.condition = std::move(faces[at(direction)][at(side)]);
            if (!isBounded(lattice_.axis(direction))) { continue; }

            placePoints(face, direction, side);
            const FaceCondition& condition = face.condition;
            const std::size_t size = face.points.size();
            for (int d = 0; d < lattice_.dimensions(); ++d)
            {
                const bool normal = lattice_.direction(d) == direction;
                if (condition.velocity == VelocityCondition::value ||
                    (condition.velocity == VelocityCondition::slip && normal))
                {
                    face.own[at(d)].resize(size);
                    face.velocity[at(d)].resize(size);
                }
            }
            if (condition.pressure != PressureCondition::zeroGradient && condition.p) { face.pressure.resize(size); }
            dependsOnTime_ =
                dependsOnTime_ ||
                (condition.velocity == VelocityCondition::value && condition.U && condition.U->dependsOnTime()) ||
                (!face.pressure.empty() && condition.p->dependsOnTime());
        }
    }
    findCorners();
}

void FlowBoundary::placePoints(Face& face, int direction, Side side) const
{
    const Axis& normal = lattice_.axis(direction);
    const auto [a, b] = directionsAlong(direction);
    const std::array<std::size_t, 3> strides{1, static_cast<std::size_t>(lattice_.axis(0).count),
                                             static_cast<std::size_t>(lattice_.axis(0).count) *
                                                 static_cast<std::size_t>(lattice_.axis(1).count)};
    const std::size_t first =
        side == Side::low ? 0 : static_cast<std::size_t>(normal.count - 1) * strides[at(direction)];
    face.onPoints = !normal.staggered;
    for (int ib = 0; ib < lattice_.axis(b).count; ++ib)
    {
        for (int ia = 0; ia < lattice_.axis(a).count; ++ia)
        {
            face.points.push_back(first + static_cast<std::size_t>(ia) * strides[at(a)] +
                                  static_cast<std::size_t>(ib) * strides[at(b)]);
            face.coordinates[at(direction)].push_back(side == Side::low ? normal.origin
                                                                        : normal.origin + normal.extent);
            face.coordinates[at(a)].push_back(lattice_.axis(a).coordinate(ia));
            face.coordinates[at(b)].push_back(lattice_.axis(b).coordinate(ib));
        }
    }
}

void FlowBoundary::findCorners()
{
    const auto isEnd = [this](int direction, int i)
    {
        const Axis& axis = lattice_.axis(direction);
        return isBounded(axis) && !axis.staggered && (i == 0 || i == axis.count - 1);
    };
    std::map<std::size_t, Corner> corners;
    for (int direction = 0; direction < 3; ++direction)
    {
        const auto [a, b] = directionsAlong(direction);
        for (const Side side : sides)
        {
            const Face& face = faces_[at(direction)][at(side)];
            if (!face.onPoints) { continue; }
            for (std::size_t i = 0; i < face.points.size(); ++i)
            {
                const int along = lattice_.axis(a).count;
                if (isEnd(a, static_cast<int>(i) % along) || isEnd(b, static_cast<int>(i) / along))
                {
                    corners[face.points[i]].push_back({direction, side, i});
                }
            }
        }
    }
    for (auto& [point, corner] : corners) { corners_.push_back(std::move(corner)); }
}

bool FlowBoundary::fixesPressure() const
{
    return std::ranges::any_of(
        faces_,
        [](const std::array<Face, 2>& ends)
        {
            return std::ranges::any_of(
                ends, [](const Face& face)
                { return !face.points.empty() && face.condition.pressure == PressureCondition::value; });
        });
}

void FlowBoundary::update(double t)
{
    if (evaluated_ && !dependsOnTime_) { return; }
    for (auto& ends : faces_)
    {
        for (Face& face : ends)
        {
            evaluateVelocity(face, t);
            evaluatePressure(face, t);
        }
    }
    applyCornerRule();
    evaluated_ = true;
}

void FlowBoundary::evaluateVelocity(Face& face, double t)
{
    const FaceCondition& condition = face.condition;
    if (condition.velocity != VelocityCondition::value || !condition.U || face.points.empty()) { return; }
    if (evaluated_ && !condition.U->dependsOnTime()) { return; }
    const auto& [x, y, z] = face.coordinates;
    for (int d = 0; d < lattice_.dimensions(); ++d)
    {
        std::vector<double>& values = face.own[at(d)];
        condition.U->evaluate(lattice_.direction(d), x, y, z, t, values);
        requireFinite(values, face.coordinates, condition.patch, "velocity", t);
        std::ranges::copy(values, face.velocity[at(d)].begin());
    }
}

void FlowBoundary::evaluatePressure(Face& face, double t)
{
    const FaceCondition& condition = face.condition;
    if (face.pressure.empty() || (evaluated_ && !condition.p->dependsOnTime())) { return; }
    const auto& [x, y, z] = face.coordinates;
    condition.p->evaluate(0, x, y, z, t, face.pressure);
    const bool gradient = condition.pressure == PressureCondition::gradient;
    requireFinite(face.pressure, face.coordinates, condition.patch, gradient ? "pressure gradient" : "pressure", t);
}

double FlowBoundary::ownSpeed(const Share& share) const
{
    const Face& face = faceAt(share);
    if (face.condition.velocity != VelocityCondition::value) { return -1; }
    double squares = 0;
    for (int d = 0; d < lattice_.dimensions(); ++d)
    {
        squares += face.own[at(d)][share.index] * face.own[at(d)][share.index];
    }
    return std::sqrt(squares);
}

void FlowBoundary::applyCornerRule()
{
    for (const Corner& corner : corners_)
    {
        const Share* owner = nullptr;
        double highest = -1;
        for (const Share& share : corner)
        {
            if (const double speed = ownSpeed(share); speed > highest)
            {
                highest = speed;
                owner = &share;
            }
        }
        if (owner == nullptr) { continue; }
        for (const Share& share : corner)
        {
            for (int d = 0; d < lattice_.dimensions(); ++d)
            {
                std::vector<double>& values = faceAt(share).velocity[at(d)];
                if (!values.empty()) { values[share.index] = faceAt(*owner).own[at(d)][owner->index]; }
            }
        }
    }
}

std::span<const double> FlowBoundary::velocity(int direction, Side side, int d) const
{
    return faces_[at(direction)][at(side)].velocity[at(d)];
}

std::span<const double> FlowBoundary::ownVelocity(int direction, Side side, int d) const
{
    return faces_[at(direction)][at(side)].own[at(d)];
}

std::span<const double> FlowBoundary::normalVelocity(int direction, Side side) const
{
    for (int d = 0; d < lattice_.dimensions(); ++d)
    {
        if (lattice_.direction(d) == direction) { return faces_[at(direction)][at(side)].own[at(d)]; }
    }
    return {};
}

std::span<const double> FlowBoundary::pressure(int direction, Side side) const
{
    return faces_[at(direction)][at(side)].pressure;
}

std::array<std::span<const double>, 3> FlowBoundary::coordinates(int direction, Side side) const
{
    const auto& [x, y, z] = faces_[at(direction)][at(side)].coordinates;
    return {x, y, z};
}

void FlowBoundary::impose(RealField& U) const
{
    // The corner rule made faces agree on the points they share, so their order does not matter.
    for (const auto& ends : faces_)
    {
        for (const Face& face : ends)
        {
            if (!face.onPoints) { continue; }
            for (int d = 0; d < U.components(); ++d)
            {
                const std::vector<double>& values = face.velocity[at(d)];
                const std::span<double> component = U[d];
                for (std::size_t i = 0; i < values.size(); ++i) { component[face.points[i]] = values[i]; }
            }
        }
    }
}

void FlowBoundary::imposeNormal(RealField& U) const
{
    for (int d = 0; d < lattice_.dimensions(); ++d)
    {
        for (const Face& face : faces_[at(lattice_.direction(d))])
        {
            if (!face.onPoints) { continue; }
            const std::vector<double>& values = face.own[at(d)];
            for (std::size_t i = 0; i < values.size(); ++i) { U[d][face.points[i]] = values[i]; }
        }
    }
}

bool FlowBoundary::flowsThroughCorners() const
{
    for (int d = 0; d < lattice_.dimensions(); ++d)
    {
        for (const Face& face : faces_[at(lattice_.direction(d))])
        {
            if (face.onPoints && !std::ranges::equal(face.velocity[at(d)], face.own[at(d)])) { return true; }
        }
    }
    return false;
}

FlowBoundary::Flux FlowBoundary::flux(Quadrature quadrature) const
{
    Flux flux;
    for (int d = 0; d < lattice_.dimensions(); ++d)
    {
        const int direction = lattice_.direction(d);
        const auto [a, b] = directionsAlong(direction);
        const int along = lattice_.axis(a).count;
        for (const Side side : sides)
        {
            const Face& face = faces_[at(direction)][at(side)];
            if (face.condition.velocity != VelocityCondition::value) { continue; }
            for (std::size_t i = 0; i < face.points.size(); ++i)
            {
                const double weight = weightOf(lattice_.axis(a), static_cast<int>(i) % along, quadrature) *
                                      weightOf(lattice_.axis(b), static_cast<int>(i) / along, quadrature);
                const double normal = face.own[at(d)][i];
                const double inwards = side == Side::low ? normal : -normal;
                (inwards > 0 ? flux.in : flux.out) += weight * std::abs(inwards);
            }
        }
    }
    return flux;
}

std::optional<FlowBoundary::Contradiction> FlowBoundary::contradiction(double tolerance) const
{
    double fastest = 0;
    for (const Corner& corner : corners_)
    {
        for (const Share& share : corner) { fastest = std::max(fastest, ownSpeed(share)); }
    }
    const auto ownVelocity = [this](const Share& share)
    {
        std::array<double, 3> result{};
        for (int d = 0; d < lattice_.dimensions(); ++d)
        {
            result[at(lattice_.direction(d))] = faceAt(share).own[at(d)][share.index];
        }
        return result;
    };
    for (const Corner& corner : corners_)
    {
        for (std::size_t one = 0; one < corner.size(); ++one)
        {
            for (std::size_t other = one + 1; other < corner.size(); ++other)
            {
                // A sine that ends in a rounding error of zero is at rest.
                const double slower = std::min(ownSpeed(corner[one]), ownSpeed(corner[other]));
                const double faster = std::max(ownSpeed(corner[one]), ownSpeed(corner[other]));
                if (!(slower > tolerance * fastest)) { continue; }
                const std::array<double, 3> u = ownVelocity(corner[one]);
                const std::array<double, 3> v = ownVelocity(corner[other]);
                if (std::hypot(u[0] - v[0], u[1] - v[1], u[2] - v[2]) <= tolerance * faster) { continue; }
                return Contradiction{{faceAt(corner[one]).condition.patch, faceAt(corner[other]).condition.patch},
                                     {u, v},
                                     pointOf(faceAt(corner[one]).coordinates, corner[one].index)};
            }
        }
    }
    return std::nullopt;
}

} // namespace isph
