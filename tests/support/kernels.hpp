#pragma once

#include "kernels/ExactKernel.hpp"
#include "kernels/Gaussian.hpp"
#include "kernels/KernelSettings.hpp"
#include "kernels/QuinticSpline.hpp"

#include <memory>

namespace isph::test
{

inline KernelSettings closedGaussian(int order, double smoothingLength)
{
    KernelSettings kernel;
    kernel.kernel = std::make_unique<Gaussian>(order);
    kernel.smoothingLength = smoothingLength;
    kernel.supportRadius = kernel.kernel->supportRadius();
    return kernel;
}

inline KernelSettings sampledGaussian(int order, double smoothingLength, double supportRadius)
{
    KernelSettings kernel = closedGaussian(order, smoothingLength);
    kernel.symbol = KernelSettings::Symbol::sampled;
    kernel.supportRadius = supportRadius;
    return kernel;
}

inline KernelSettings quinticSpline(double smoothingLength)
{
    KernelSettings kernel;
    kernel.kernel = std::make_unique<QuinticSpline>();
    kernel.smoothingLength = smoothingLength;
    kernel.symbol = KernelSettings::Symbol::sampled;
    kernel.supportRadius = 3;
    return kernel;
}

inline KernelSettings exactKernel()
{
    KernelSettings kernel;
    kernel.kernel = std::make_unique<ExactKernel>();
    return kernel;
}

} // namespace isph::test
