#pragma once

#include "kernels/Kernel.hpp"

#include <stdexcept>

namespace isph
{

/// The limit of infinite order: the exact derivative of the trigonometric interpolant. It has no samples.
class ExactKernel : public Kernel
{
public:
    int order() const override { return 0; }
    double w(double, int) const override { throw std::logic_error("the exact kernel has no samples"); }
    double f(double, int) const override { throw std::logic_error("the exact kernel has no samples"); }
    double g(double, int) const override { throw std::logic_error("the exact kernel has no samples"); }
    double supportRadius() const override { return 0; }
    bool closed() const override { return true; }
    double symbol(double) const override { return 1; }
    double morrisSymbol(double) const override { return 1; }
};

} // namespace isph
