#pragma once

#include "boundary/FlowBoundary.hpp"
#include "continuation/LineLayout.hpp"

#include <array>
#include <span>
#include <vector>

namespace isph
{

/// What becomes of the velocity at the points of outlets.
///
/// The second derivative through an open end has nothing that holds it: with nu it makes every disturbance there grow,
/// the faster the finer the lattice. So the points of an outlet move by
///
///     du/dt = -max(u_n, 0) du/dn + what acts along the face,   du/dn by one-sided differences of third order:
///
/// what comes is carried out, nothing is diffused through the face, and fluid that turns back brings no gradient with
/// it. On staggered axes no point lies on an outlet, and there is nothing to do.
class OutflowCondition
{
public:
    OutflowCondition(const Lattice& lattice, const FlowBoundary& boundary);

    /// Around the transport of a component along active axis d, which has a value at every point:
    /// remembers the rates at outlets before it ...
    void keep(int d, std::span<const double> rate);
    /// ... and puts these back afterwards, with the transport above. \param carrier the velocity along d, or empty
    void replace(int d, std::span<const double> u, std::span<const double> carrier, std::span<double> rate) const;

private:
    struct Outlet
    {
        int d;
        LineLayout lines;
        bool high;
        double spacing;
        std::vector<double> kept;
    };

    std::vector<Outlet> outlets_;
};

} // namespace isph
