#include "lattice/Lattice.hpp"

#include "core/Error.hpp"

#include <utility>

namespace isph
{

Lattice::Lattice(std::array<Axis, 3> axes, std::vector<Patch> patches) : axes_(axes), patches_(std::move(patches))
{
    for (int direction = 0; direction < 3; ++direction)
    {
        if (axis(direction).active()) { directions_[static_cast<std::size_t>(dimensions_++)] = direction; }
    }
    if (dimensions_ < 2)
    {
        throw Error(Fault::input, "the lattice has fewer than two axes with an extent",
                    "incompressible flow along one line is a constant: give two or three axes an extent above 0");
    }
}

std::size_t Lattice::points() const
{
    std::size_t n = 1;
    for (const Axis& a : axes_) { n *= static_cast<std::size_t>(a.count); }
    return n;
}

double Lattice::pointVolume() const
{
    double volume = 1;
    for (int d = 0; d < dimensions_; ++d) { volume *= activeAxis(d).spacing(); }
    return volume;
}

bool Lattice::periodic() const
{
    for (int d = 0; d < dimensions_; ++d)
    {
        if (!activeAxis(d).periodic()) { return false; }
    }
    return true;
}

bool Lattice::staggered() const
{
    for (int d = 0; d < dimensions_; ++d)
    {
        if (!activeAxis(d).periodic() && activeAxis(d).staggered) { return true; }
    }
    return false;
}

std::array<std::vector<double>, 3> Lattice::coordinates() const
{
    std::array<std::vector<double>, 3> result;
    for (auto& values : result) { values.reserve(points()); }
    for (int iz = 0; iz < axis(2).count; ++iz)
    {
        for (int iy = 0; iy < axis(1).count; ++iy)
        {
            for (int ix = 0; ix < axis(0).count; ++ix)
            {
                result[0].push_back(axis(0).coordinate(ix));
                result[1].push_back(axis(1).coordinate(iy));
                result[2].push_back(axis(2).coordinate(iz));
            }
        }
    }
    return result;
}

} // namespace isph
