#pragma once

#include "continuation/Continuation.hpp"

namespace isph
{

/// Extrapolates from both ends and blends, with d new points and t_k = k/(d + 1):
///     F_k = (1 - S_m(t_k)) upper(k) + S_m(t_k) lower(d + 1 - k)
/// (Lin, Fourtakas & Rogers 2026, eqs 28 and 29, with the points counted as docs/theory has them).
class BlendedContinuation : public Continuation
{
public:
    /// \throws Error(input) without origin unless newPoints >= 1 and smoothness is 0 ... largestSmoothness.
    BlendedContinuation(int newPoints, int smoothness);

    static constexpr int largestSmoothness = 60;

    EndBlock end(EndCondition condition) const final;

protected:
    /// Weights of the values and factor of the datum after a number of steps outward.
    struct Extrapolation
    {
        std::vector<double> weights;
        double datum = 0;
    };

    /// For 1 ... newPoints() steps, without blending.
    virtual std::vector<Extrapolation> extrapolations(EndCondition condition) const = 0;

private:
    int smoothness_;
};

/// S_m(t) on [0, 1]: the polynomial of degree 2m + 1 that goes from 0 to 1 with m derivatives zero at both ends, the
/// regularised incomplete beta function I_t(m + 1, m + 1). S_2 is the quintic of Lin, Fourtakas & Rogers 2026, eq. 29.
double smoothStep(int m, double t);

} // namespace isph
