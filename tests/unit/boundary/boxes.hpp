#pragma once

#include "boundary/FlowBoundary.hpp"
#include "lattice/Lattice.hpp"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace isph::test
{

enum class AxisKind
{
    periodic,
    collocated,
    staggered,
    leftOut
};

/// A box [0, 1]^n with n points along each axis; patches are named like their faces, periodic ones like their axis.
inline Lattice box(std::array<AxisKind, 3> kinds, std::array<int, 3> counts, Patch::Type type = Patch::Type::wall)
{
    std::array<Axis, 3> axes;
    std::vector<Patch> patches;
    for (std::size_t a = 0; a < 3; ++a)
    {
        const std::string name(1, "xyz"[a]);
        axes[a] = {.name = name[0], .origin = 0, .extent = 1, .count = counts[a]};
        if (kinds[a] == AxisKind::leftOut)
        {
            axes[a].extent = 0;
            axes[a].count = 1;
            continue;
        }
        if (kinds[a] == AxisKind::periodic)
        {
            patches.push_back({name, Patch::Type::periodic, {name + "Min", name + "Max"}});
            continue;
        }
        axes[a].ends = Axis::Ends::bounded;
        axes[a].staggered = kinds[a] == AxisKind::staggered;
        for (const char* end : {"Min", "Max"}) { patches.push_back({name + end, type, {name + end}}); }
    }
    return Lattice(axes, std::move(patches));
}

/// Component of a velocity (0 for scalars), x, y, z, t.
using PlaceAndTime = std::function<double(int, double, double, double, double)>;

class PlainFaceFunction : public FaceFunction
{
public:
    PlainFaceFunction(PlaceAndTime function, bool changes, int* calls)
        : function_(std::move(function)), changes_(changes), calls_(calls)
    {
    }

    void evaluate(int component, std::span<const double> x, std::span<const double> y, std::span<const double> z,
                  double t, std::span<double> values) const override
    {
        if (calls_ != nullptr) { ++*calls_; }
        for (std::size_t i = 0; i < values.size(); ++i) { values[i] = function_(component, x[i], y[i], z[i], t); }
    }
    bool dependsOnTime() const override { return changes_; }

private:
    PlaceAndTime function_;
    bool changes_;
    int* calls_;
};

inline std::unique_ptr<const FaceFunction> steady(PlaceAndTime function, int* calls = nullptr)
{
    return std::make_unique<PlainFaceFunction>(std::move(function), false, calls);
}

inline std::unique_ptr<const FaceFunction> changing(PlaceAndTime function, int* calls = nullptr)
{
    return std::make_unique<PlainFaceFunction>(std::move(function), true, calls);
}

inline std::unique_ptr<const FaceFunction> uniform(std::array<double, 3> velocity)
{
    return steady([velocity](int c, double, double, double, double) { return velocity[static_cast<std::size_t>(c)]; });
}

using Faces = std::array<std::array<FaceCondition, 2>, 3>;

/// Walls at rest at every face, named like it.
inline Faces walls()
{
    Faces faces;
    for (std::size_t a = 0; a < 3; ++a)
    {
        for (std::size_t side = 0; side < 2; ++side)
        {
            FaceCondition& face = faces[a][side];
            face.patch = std::string(1, "xyz"[a]) + (side == 0 ? "Min" : "Max");
            face.velocity = VelocityCondition::value;
            face.pressure = PressureCondition::zeroGradient;
        }
    }
    return faces;
}

} // namespace isph::test
