#pragma once

#include "flow/Convection.hpp"
#include "kernels/KernelSettings.hpp"
#include "operators/LaplacianForm.hpp"
#include "poisson/eigenvalues.hpp"
#include "schemes/TimeScheme.hpp"
#include "spectral/dealiasing.hpp"
#include "spectral/SpectralFilter.hpp"

namespace isph
{

/// Every choice of system/schemes and system/solution, resolved: what a flow is built from.
struct FlowSettings
{
    KernelSettings kernel;
    bool directSum = false; ///< operators by neighbour summation instead of transforms
    ConvectionForm convection = ConvectionForm::divergence;
    LaplacianForm laplacian = LaplacianForm::morris;
    const TimeScheme* time = nullptr;
    bool integratingFactor = true; ///< the viscous term is integrated exactly
    bool exactMeanFlow = true;     ///< a uniform mean velocity is carried exactly
    Dealiasing dealiasing = Dealiasing::twoThirds;
    FilterSettings filter;
    Eigenvalues eigenvalues = Eigenvalues::consistent;
    bool incremental = false; ///< the predictor knows the old pressure
    bool initialProjection = true;
};

} // namespace isph
