#pragma once

#include "boundary/FlowBoundary.hpp"
#include "fields/Field.hpp"
#include "lattice/Lattice.hpp"

#include <functional>
#include <optional>

namespace isph
{

/// Component (0, 1, 2: x, y, z) of a velocity at a place [m/s].
using FlowOfPlace = std::function<double(int, double, double, double)>;

FlowOfPlace atRest();
FlowOfPlace uniformFlow(int direction, double velocity);

/// A flow at the points of a lattice.
RealField fieldOf(const Lattice& lattice, const FlowOfPlace& flow);

/// The faces of a boundary with the same conditions, prescribing another flow; pressures vanish.
FlowBoundary boundaryFor(const Lattice& lattice, const FlowBoundary& boundary, const FlowOfPlace& flow);

/// The way a uniform flow can take through a box whose faces keep their conditions.
struct Passage
{
    enum class Kind
    {
        through, ///< from a face that prescribes the velocity to one that lets it out
        around,  ///< along a periodic axis
        held     ///< from face to face that both prescribe it: walls that let it pass, for a box that is closed
    };
    int d;    ///< active axis
    int sign; ///< +1: towards its upper end
    Kind kind;
};

/// From an inlet to an outlet where there are such, else along a periodic axis, else between walls; nothing where every
/// bounded axis ends in a mirror.
std::optional<Passage> passageOf(const Lattice& lattice, const FlowBoundary& boundary);

/// Largest rate at which any disturbance of a flow can grow by what the flow does to it: the largest stretching,
/// bounded from above by the size of the velocity gradient (Serrin 1959), from differences of neighbours [1/s].
double largestStretching(const Lattice& lattice, const RealField& velocity);

} // namespace isph
