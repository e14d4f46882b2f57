#pragma once

#include "continuation/BlendedContinuation.hpp"

namespace isph
{

/// The continuation of Lin, Fourtakas & Rogers 2026, section 4: a polynomial fitted to the points next to each end by
/// least squares, blended by S_2 (their quintic) or a smoother S_m.
///
/// With the quintic the derivatives have orders 2.5 and 1.5 whatever the degree; with 7 or 8 points and an extension
/// of a quarter the operators are unstable. A quarter of the interval and S_m with m >= 8 are safe.
class Polynomial : public BlendedContinuation
{
public:
    static constexpr int largestDegree = 15;

    /// \param points fitted at each end
    /// \throws Error(input) without origin for a degree that is not 0 ... 15, or for fewer points than degree + 1.
    Polynomial(int newPoints, int degree, int points, int smoothness = 2);

    int points() const override { return points_; }

    /// Points that are fitted when nothing else is asked for: a quarter of the intervals, at least 8.
    static int automaticPoints(int intervals);

protected:
    std::vector<Extrapolation> extrapolations(EndCondition condition) const override;

private:
    int degree_;
    int points_;
};

} // namespace isph
