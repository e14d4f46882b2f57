#include "transport/ScalarBoundary.hpp"

#include "core/Error.hpp"
#include "fields/reductions.hpp"

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

} // namespace

ScalarBoundary::ScalarBoundary(const Lattice& lattice, std::array<std::array<ScalarFace, 2>, 3> faces)
    : lattice_(lattice)
{
    for (int direction = 0; direction < 3; ++direction)
    {
        const Axis& axis = lattice_.axis(direction);
        for (const Side side : sides)
        {
            Face& face = at(direction, side);
            face.face = std::move(faces[static_cast<std::size_t>(direction)][side == Side::low ? 0 : 1]);
            face.bounded = axis.active() && !axis.periodic();
            if (face.bounded) { place(face, direction, side); }
        }
    }
    collectPrescribed();
}

void ScalarBoundary::place(Face& face, int direction, Side side)
{
    const Axis& axis = lattice_.axis(direction);
    const LineLayout lines = linesAlong(lattice_, direction);
    face.onPoints = !axis.staggered;
    face.first = side == Side::low ? 0 : (lines.count - 1) * lines.inner;
    face.data.assign(lines.lines(), 0.0);
    for (auto& coordinates : face.coordinates) { coordinates.resize(lines.lines()); }
    const auto nx = static_cast<std::size_t>(lattice_.axis(0).count);
    const auto ny = static_cast<std::size_t>(lattice_.axis(1).count);
    for (std::size_t line = 0; line < lines.lines(); ++line)
    {
        const std::size_t point = lines.start(line) + face.first;
        const std::array<std::size_t, 3> index{point % nx, point / nx % ny, point / (nx * ny)};
        for (std::size_t d = 0; d < 3; ++d)
        {
            face.coordinates[d][line] = lattice_.axis(static_cast<int>(d)).coordinate(static_cast<int>(index[d]));
        }
        face.coordinates[static_cast<std::size_t>(direction)][line] =
            axis.origin + (side == Side::low ? 0 : axis.extent);
    }
}

std::size_t ScalarBoundary::pointOf(const Face& face, int direction, std::size_t line) const
{
    return linesAlong(lattice_, direction).start(line) + face.first;
}

void ScalarBoundary::collectPrescribed()
{
    std::map<std::size_t, int> shares;
    for (int direction = 0; direction < 3; ++direction)
    {
        for (const Side side : sides)
        {
            const Face& face = at(direction, side);
            if (!face.bounded || !face.onPoints || face.face.condition != ScalarCondition::value) { continue; }
            for (std::size_t line = 0; line < face.data.size(); ++line)
            {
                const std::size_t point = pointOf(face, direction, line);
                prescribed_.push_back({point, &face.data[line], 1});
                ++shares[point];
            }
        }
    }
    for (Prescribed& value : prescribed_) { value.weight = 1.0 / shares[value.point]; }
}

EndCondition ScalarBoundary::endCondition(int direction, Side side) const
{
    const bool mirrored = condition(direction, side) == ScalarCondition::outflow && lattice_.axis(direction).staggered;
    const bool slope = mirrored || condition(direction, side) == ScalarCondition::gradient;
    return slope ? EndCondition::neumann : EndCondition::dirichlet;
}

void ScalarBoundary::update(double t)
{
    for (int direction = 0; direction < 3; ++direction)
    {
        for (const Side side : sides)
        {
            Face& face = at(direction, side);
            const FaceFunction* data = face.face.data.get();
            if (!face.bounded || data == nullptr || (evaluated_ && !data->dependsOnTime())) { continue; }
            const auto& [x, y, z] = face.coordinates;
            data->evaluate(0, x, y, z, t, face.data);
            const auto wrong = std::ranges::find_if_not(face.data, [](double value) { return std::isfinite(value); });
            if (wrong != face.data.end())
            {
                const auto i = static_cast<std::size_t>(wrong - face.data.begin());
                throw Error(Fault::input,
                            fmt::format("what patch {} prescribes is {} at ({:g} {:g} {:g}), t = {:g} s",
                                        face.face.patch, *wrong, x[i], y[i], z[i], t),
                            "look for a division by zero, or a root or logarithm of a negative number");
            }
            if (face.face.condition == ScalarCondition::value)
            {
                largestValue_ = std::max(largestValue_, largestMagnitude(face.data));
            }
            else
            {
                const double dx = lattice_.axis(direction).spacing();
                for (double& slope : face.data) { slope *= dx; }
            }
        }
    }
    evaluated_ = true;
}

EndData ScalarBoundary::endData(int direction) const
{
    return {at(direction, Side::low).data, at(direction, Side::high).data};
}

void ScalarBoundary::impose(std::span<double> values) const
{
    for (const Prescribed& prescribed : prescribed_) { values[prescribed.point] = 0; }
    for (const Prescribed& prescribed : prescribed_)
    {
        values[prescribed.point] += prescribed.weight * *prescribed.value;
    }
}

bool ScalarBoundary::prescribesFlux() const
{
    return std::ranges::any_of(faces_,
                               [](const std::array<Face, 2>& ends)
                               {
                                   return std::ranges::any_of(ends,
                                                              [](const Face& face) {
                                                                  return face.bounded &&
                                                                         face.face.condition ==
                                                                             ScalarCondition::gradient &&
                                                                         face.face.data != nullptr;
                                                              });
                               });
}

std::vector<std::string> ScalarBoundary::inflowThroughOutflow(const RealField& velocity) const
{
    std::vector<std::string> patches;
    for (int d = 0; d < lattice_.dimensions(); ++d)
    {
        const double roundOff = 1e-10 * largestMagnitude(velocity[d]);
        for (const Side side : sides)
        {
            const Face& face = at(lattice_.direction(d), side);
            if (!face.bounded || face.face.condition != ScalarCondition::outflow) { continue; }
            const double inwards = side == Side::low ? 1 : -1;
            bool enters = false;
            for (std::size_t line = 0; line < face.data.size(); ++line)
            {
                enters = enters || inwards * velocity[d][pointOf(face, lattice_.direction(d), line)] > roundOff;
            }
            if (enters && std::ranges::find(patches, face.face.patch) == patches.end())
            {
                patches.push_back(face.face.patch);
            }
        }
    }
    return patches;
}

} // namespace isph
