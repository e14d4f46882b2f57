#pragma once

#include "continuation/continuedField.hpp"
#include "flow/Convection.hpp"
#include "kernels/KernelSettings.hpp"
#include "operators/LaplacianForm.hpp"
#include "poisson/eigenvalues.hpp"
#include "poisson/pressureSolvers.hpp"
#include "schemes/TimeScheme.hpp"
#include "spectral/dealiasing.hpp"
#include "spectral/SpectralFilter.hpp"

#include <optional>
#include <string>

namespace isph
{

/// How a step meets the conditions at walls (docs/theory/walls.md).
enum class WallTreatment
{
    consistent,      ///< the momentum step on all points; the pressure's wall slope restores the normal velocity
    paper,           ///< walls reset before the projection, dp/dn = 0 (Lin et al. 2026)
    incremental,     ///< the predictor knows the old pressure; dphi/dn = 0
    rotational,      ///< the same, the pressure without nu div u (Guermond, Minev & Shen 2006)
    slip,            ///< tangential wall values preset with the old pressure (Fontana et al. 2020)
    pressurePoisson, ///< pressure from the momentum equation (Johnston & Liu 2004)
};

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
    std::optional<IterationSettings> iteration; ///< the pressure by the matrix of classical ISPH, not by transforms
    bool incremental = false;                   ///< the predictor knows the old pressure
    bool initialProjection = true;

    // Bounded axes only.
    Continuations continuations; ///< by direction; null for periodic axes
    std::string continuation;    ///< what they are, for logs: "smoothGram, degree 4"
    bool extended = false;       ///< transform the whole extended box, as the paper does
    WallTreatment walls = WallTreatment::consistent;
    bool crankNicolson = false;    ///< the viscous term is implicit
    bool automaticViscous = false; ///< a step may choose between both, see crankNicolsonPays
    bool directPressure = false;   ///< pressure from the diagonalised continuation operators
};

} // namespace isph
