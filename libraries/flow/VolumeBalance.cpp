#include "flow/VolumeBalance.hpp"

#include "lattice/LatticeFace.hpp"
#include "lattice/Quadrature.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace isph
{

namespace
{

constexpr std::array<Side, 2> sidesOfAxis{Side::low, Side::high};

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The first active axis with an outlet, or -1.
int axisOfOutlets(const Lattice& lattice, const FlowBoundary& boundary)
{
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        if (lattice.activeAxis(d).periodic()) { continue; }
        for (const Side side : sidesOfAxis)
        {
            if (boundary.face(lattice.direction(d), side).velocity == VelocityCondition::outflow) { return d; }
        }
    }
    return -1;
}

} // namespace

bool VolumeBalance::concerns(const Lattice& lattice, const FlowBoundary& boundary)
{
    return axisOfOutlets(lattice, boundary) >= 0;
}

VolumeBalance::VolumeBalance(const Lattice& lattice, const FlowBoundary& boundary)
    : lattice_(lattice),
      boundary_(boundary),
      d_(axisOfOutlets(lattice, boundary)),
      direction_(lattice.direction(d_)),
      lines_(linesAlong(lattice, direction_)),
      faceWeights_(LatticeFace(lattice, direction_, false).weights()),
      freeWeights_(faceWeights_),
      planeWeights_(quadratureWeights(lattice.axis(direction_))),
      lack_(lines_.count),
      sides_(lines_.count),
      integral_(lines_.count)
{
    std::vector<bool> held(lines_.lines());
    for (int d = 0; d < lattice_.dimensions(); ++d)
    {
        if (d == d_ || lattice_.activeAxis(d).periodic()) { continue; }
        for (const Side side : sidesOfAxis) { findSides(d, side, held); }
    }
    for (std::size_t l = 0; l < held.size(); ++l)
    {
        if (held[l]) { freeWeights_[l] = 0; }
    }
    freeArea_ = std::accumulate(freeWeights_.begin(), freeWeights_.end(), 0.0);
}

void VolumeBalance::findSides(int d, Side side, std::vector<bool>& held)
{
    const int direction = lattice_.direction(d);
    const Axis& normal = lattice_.axis(direction);
    const FaceCondition& condition = boundary_.face(direction, side);
    const bool open = condition.velocity == VelocityCondition::outflow;
    const bool flows = open || (condition.velocity == VelocityCondition::value && condition.U);
    const bool holds = !normal.staggered && !boundary_.velocity(direction, side, d_).empty();

    // Its points in storage order, and where they are in their cross-sections.
    const int across = 3 - direction - direction_;
    const std::vector<double> weightsAcross = quadratureWeights(lattice_.axis(across));
    const int fast = std::min(across, direction_);
    const int slow = std::max(across, direction_);
    const std::array<std::size_t, 3> strides{1, at(lattice_.axis(0).count),
                                             at(lattice_.axis(0).count) * at(lattice_.axis(1).count)};
    const std::vector<bool> heldByOthers = held;
    std::size_t index = 0;
    std::array<std::size_t, 3> i{};
    i[at(direction)] = side == Side::low ? 0 : at(normal.count - 1);
    for (i[at(slow)] = 0; i[at(slow)] < at(lattice_.axis(slow).count); ++i[at(slow)])
    {
        for (i[at(fast)] = 0; i[at(fast)] < at(lattice_.axis(fast).count); ++i[at(fast)], ++index)
        {
            const std::size_t plane = i[at(direction_)];
            const std::size_t point = i[0] * strides[0] + i[1] * strides[1] + i[2] * strides[2];
            const std::size_t first = point - plane * lines_.inner;
            const std::size_t line = first / (lines_.inner * lines_.count) * lines_.inner + first % lines_.inner;
            if (flows)
            {
                const double weight = weightsAcross[i[at(across)]];
                pores_.push_back({direction, side, index, plane, side == Side::low ? -weight : weight, d, point, open});
            }
            if (holds && !heldByOthers[line])
            {
                held_.push_back({direction, side, index, plane, faceWeights_[line]});
                held[line] = true;
            }
        }
    }
}

bool VolumeBalance::prescribes(Side side) const
{
    return boundary_.face(direction_, side).velocity != VelocityCondition::outflow;
}

void VolumeBalance::begin()
{
    std::ranges::fill(lack_, 0.0);
    std::ranges::fill(sides_, 0.0);
}

void VolumeBalance::addFlow(double factor)
{
    if (prescribes(Side::low) || prescribes(Side::high))
    {
        const auto normal = boundary_.normalVelocity(direction_, prescribes(Side::low) ? Side::low : Side::high);
        double through = 0;
        for (std::size_t l = 0; l < normal.size(); ++l) { through += faceWeights_[l] * normal[l]; }
        for (double& flow : lack_) { flow += factor * through; }
    }
    for (const Pore& pore : pores_)
    {
        if (pore.open) { continue; }
        sides_[pore.plane] += factor * pore.weight * boundary_.normalVelocity(pore.direction, pore.side)[pore.index];
    }
}

void VolumeBalance::prescribe(double factor)
{
    addFlow(factor);
    for (const Held& point : held_)
    {
        lack_[point.plane] -= factor * point.weight * boundary_.velocity(point.direction, point.side, d_)[point.index];
    }
}

void VolumeBalance::integrate(std::span<const double> values)
{
    const std::size_t n = values.size();
    const Axis& axis = lattice_.axis(direction_);
    // Cubics through the points next to each interval; the first cross-section may lie half a spacing inside.
    integral_[0] = axis.staggered ? 0.5 * values[0] : 0;
    for (std::size_t i = 0; i + 1 < n; ++i)
    {
        const double step = i == 0       ? (5 * values[0] + 8 * values[1] - values[2]) / 12
                            : i + 2 == n ? (5 * values[n - 1] + 8 * values[n - 2] - values[n - 3]) / 12
                                         : (13 * (values[i] + values[i + 1]) - values[i - 1] - values[i + 2]) / 24;
        integral_[i + 1] = integral_[i] + step;
    }
    for (double& value : integral_) { value *= axis.spacing(); }
}

void VolumeBalance::subtractSides(const RealField& u)
{
    if (pores_.empty()) { return; }
    for (const Pore& pore : pores_)
    {
        if (pore.open) { sides_[pore.plane] += pore.weight * u[pore.component][pore.point]; }
    }
    integrate(sides_);
    double total = 0;
    for (std::size_t i = 0; i < sides_.size(); ++i) { total += planeWeights_[i] * sides_[i]; }
    // By which the two quadratures differ: spread evenly.
    const double end = lattice_.axis(direction_).staggered ? 0.5 * lattice_.axis(direction_).spacing() : 0;
    const double rest = (total - integral_.back() - end * sides_.back()) / static_cast<double>(sides_.size() - 1);
    const double behind = prescribes(Side::low) ? 0 : total; // known is what passes the other end
    for (std::size_t i = 0; i < lack_.size(); ++i)
    {
        lack_[i] += behind - integral_[i] - rest * static_cast<double>(i);
    }
}

void VolumeBalance::compare(const RealField& u, std::span<const double> weights)
{
    subtractSides(u);
    for (std::size_t l = 0; l < weights.size(); ++l)
    {
        const std::size_t start = lines_.start(l);
        for (std::size_t i = 0; i < lack_.size(); ++i) { lack_[i] -= weights[l] * u[d_][start + i * lines_.inner]; }
    }
    for (double& value : lack_) { value /= freeArea_; }
    if (prescribes(Side::low) || prescribes(Side::high)) { return; }
    double mean = 0;
    for (std::size_t i = 0; i < lack_.size(); ++i) { mean += planeWeights_[i] * lack_[i]; }
    mean /= lattice_.axis(direction_).extent;
    for (double& value : lack_) { value -= mean; }
}

void VolumeBalance::correct(RealField& u)
{
    begin();
    addFlow(1);
    compare(u, faceWeights_);
    if (!lattice_.axis(direction_).staggered)
    {
        if (prescribes(Side::low)) { lack_.front() = 0; }
        if (prescribes(Side::high)) { lack_.back() = 0; }
    }
    for (std::size_t l = 0; l < freeWeights_.size(); ++l)
    {
        if (freeWeights_[l] == 0) { continue; }
        const std::size_t start = lines_.start(l);
        for (std::size_t i = 0; i < lack_.size(); ++i) { u[d_][start + i * lines_.inner] += lack_[i]; }
    }
}

void VolumeBalance::addPressure(const RealField& rate, RealField& p)
{
    compare(rate, freeWeights_);
    integrate(lack_);
    const double atOutlet = prescribes(Side::high) ? 0 : integral_.back();
    for (std::size_t l = 0; l < freeWeights_.size(); ++l)
    {
        const std::size_t start = lines_.start(l);
        for (std::size_t i = 0; i < lack_.size(); ++i) { p[0][start + i * lines_.inner] += atOutlet - integral_[i]; }
    }
}

} // namespace isph
