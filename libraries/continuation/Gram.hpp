#pragma once

#include "continuation/Continuation.hpp"

namespace isph
{

/// FC(Gram), for comparison (Bruno & Lyon 2010; Amlani & Bruno 2016): each Gram polynomial of the points next to an end
/// goes on as the trigonometric polynomial that fits it there and vanishes further out, by least squares.
///
/// The table is made here, in double-double arithmetic. Values at the points only: a derivative at the wall cannot be
/// prescribed, and a constant is continued smoothly but not as a constant.
class Gram : public Continuation
{
public:
    static constexpr int leastNewPoints = 8;
    static constexpr int largestNewPoints = 100;

    /// \param degree of the polynomials, 2 ... 8
    /// \throws Error(input) without origin for a degree or an extension out of range.
    explicit Gram(int newPoints, int degree = 4);

    int points() const override { return points_; }

    /// \throws Error(input) without origin for EndCondition::neumann.
    EndBlock end(EndCondition condition) const override;

private:
    int points_;
    std::vector<double> weights_; ///< of EndBlock
};

} // namespace isph
