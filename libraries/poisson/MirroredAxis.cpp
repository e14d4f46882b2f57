#include "poisson/MirroredAxis.hpp"

#include "core/Error.hpp"

#include <fmt/format.h>
#include <stdexcept>

namespace isph
{

MirroredAxis::MirroredAxis(const Axis& axis, AxisEnds conditions)
    : count(axis.count), spacing(axis.spacing()), staggered(axis.staggered && !axis.periodic()), ends(conditions)
{
    const bool periodicLow = ends.low == End::periodic;
    if (periodicLow != (ends.high == End::periodic) || periodicLow != axis.periodic())
    {
        throw std::logic_error("MirroredAxis: the conditions do not suit the axis");
    }
    if (!axis.periodic() && !staggered && count < 3)
    {
        throw Error(Fault::input, fmt::format("axis {} has no point inside its walls", axis.name),
                    "give it at least three");
    }
}

bool MirroredAxis::fixed(int point) const
{
    if (staggered) { return false; }
    return (point == 0 && ends.low == End::dirichlet) || (point == count - 1 && ends.high == End::dirichlet);
}

MirrorImage MirroredAxis::image(int place) const
{
    MirrorImage image;
    if (ends.low == End::periodic)
    {
        image.point = ((place % count) + count) % count;
        return image;
    }
    // Twice the places of the walls, so that staggered ones have whole numbers, too.
    const int low = staggered ? -1 : 0;
    const int high = 2 * (count - 1) - low;
    while (2 * place < low || 2 * place > high)
    {
        const bool beyondLow = 2 * place < low;
        const int wall = beyondLow ? low : high;
        const int mirrored = wall - place;
        double& data = beyondLow ? image.lowData : image.highData;
        double& point = beyondLow ? image.lowPoint : image.highPoint;
        if ((beyondLow ? ends.low : ends.high) == End::neumann) { data += image.sign * (place - mirrored) * spacing; }
        else
        {
            (staggered ? data : point) += 2 * image.sign;
            image.sign = -image.sign;
        }
        place = mirrored;
    }
    image.point = place;
    return image;
}

} // namespace isph
