#pragma once

namespace isph
{

/// u* = u^k + dt (g F^k + z F^{k-1}), then a projection over a dt (Fourtakas et al. 2021, sec. 2.2; Lin et al. 2026,
/// eqs 5-8, with the signs of docs/theory/errata.md).
struct Substep
{
    double a;      ///< length of the substep in steps, g + z
    double g;      ///< weight of the present rate F^k
    double z;      ///< weight of the previous rate F^{k-1}
    double start;  ///< when F^k is evaluated, in steps from the beginning
    int numerator; ///< a as a fraction of small numbers: factors exp(a ...) are powers of one
    int denominator;
    bool first;
    bool last;
};

/// What a time scheme marches: something with a rate of change and a constraint to project onto.
class IncompressibleSystem
{
public:
    virtual ~IncompressibleSystem() = default;

    /// One substep of a step of dt that began at time t: predictor, pressure, projection.
    virtual void advance(const Substep& substep, double t, double dt) = 0;
};

} // namespace isph
