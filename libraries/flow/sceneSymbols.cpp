#include "flow/sceneSymbols.hpp"

#include "operators/continuedBounds.hpp"

#include <optional>

namespace isph
{

namespace
{

/// The samples of a sampled kernel, with the weights of one Laplacian.
std::optional<KernelSamples> samplesFor(const Lattice& lattice, const KernelSettings& kernel, LaplacianForm form)
{
    if (kernel.symbol == KernelSettings::Symbol::closed) { return std::nullopt; }
    return KernelSamples(lattice, kernel, form);
}

} // namespace

DerivativeSymbol derivativeOf(const Lattice& lattice, const KernelSettings& kernel)
{
    const auto samples = samplesFor(lattice, kernel, LaplacianForm::exact);
    return DerivativeSymbol(lattice, kernel, samples ? &*samples : nullptr);
}

AlignedVector<double> laplacianOf(const Lattice& lattice, const KernelSettings& kernel, LaplacianForm form)
{
    const auto samples = form == LaplacianForm::exact ? std::nullopt : samplesFor(lattice, kernel, form);
    return laplacianSymbol(lattice, kernel, form, samples ? &*samples : nullptr);
}

OperatorBounds boundsOf(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings)
{
    if (!lattice.periodic())
    {
        OperatorBounds bounds = continuedBounds(lattice, settings.continuations, settings.kernel, settings.laplacian);
        if (fluid.nu == 0) { bounds.laplacian = bounds.leastLaplacian = bounds.derivativeOverLaplacian = 0; }
        return bounds;
    }
    AlignedVector<double> laplacian;
    if (fluid.nu > 0) { laplacian = laplacianOf(lattice, settings.kernel, settings.laplacian); }
    return operatorBounds(derivativeOf(lattice, settings.kernel), laplacian, {lattice, settings.dealiasing});
}

} // namespace isph
