#pragma once

#include "continuation/BlendedContinuation.hpp"

namespace isph
{

/// Mirror particles, second order (Fourtakas, Rogers & Nasar 2021): values reflected at the wall, oddly about a given
/// wall value (f_k = 2 f_wall - f of the mirror image) or evenly with a given derivative (f_k = f of the image + 2 g
/// x).
///
/// Blended half-way between the walls, far from the points where the kernel sees it. With as many new points as make
/// the line twice as long (n - 2, staggered n), values that vanish at both walls become their exact odd reflection.
class Mirror : public BlendedContinuation
{
public:
    Mirror(int newPoints, bool staggered, int smoothness = 16);

    int points() const override { return staggered_ ? newPoints() : newPoints() + 1; }

protected:
    std::vector<Extrapolation> extrapolations(EndCondition condition) const override;

private:
    bool staggered_;
};

} // namespace isph
