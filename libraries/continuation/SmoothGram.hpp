#pragma once

#include "continuation/BlendedContinuation.hpp"

namespace isph
{

/// The closed form: the polynomial through the degree + 1 points next to each end, blended by S_m. With degree 4 and
/// m = 16 it is as accurate as the FC(Gram) tables of the literature, which need extended precision to make.
///
/// Weights after k steps, exact in double precision: w_c(k) = (-1)^c binom(k + c - 1, c) binom(k + P, P - c). With the
/// derivative at the wall given, the polynomial through the same points has one degree more.
class SmoothGram : public BlendedContinuation
{
public:
    static constexpr int leastDegree = 1;
    static constexpr int largestDegree = 8;

    /// \throws Error(input) without origin for a degree that is not 1 ... 8.
    explicit SmoothGram(int newPoints, int degree = 4, int smoothness = 16);

    int points() const override { return degree_ + 1; }

protected:
    std::vector<Extrapolation> extrapolations(EndCondition condition) const override;

private:
    int degree_;
};

/// The default for a line of n points: degree 4, or what fewer than five points determine.
SmoothGram defaultSmoothGram(int n);

} // namespace isph
