#pragma once

#include "kernels/Kernel.hpp"

namespace isph
{

/// The quintic spline of Morris, Fox & Zhu 1997, support 3h, second order. It has no simple closed symbol: always
/// sampled.
class QuinticSpline : public Kernel
{
public:
    int order() const override { return 2; }
    double w(double q, int dimensions) const override;
    double f(double q, int dimensions) const override;
    double g(double q, int dimensions) const override;
    double supportRadius() const override { return 3; }
    bool closed() const override { return false; }

    /// \throws std::logic_error: there are none.
    double symbol(double s) const override;
    double morrisSymbol(double s) const override;
};

} // namespace isph
