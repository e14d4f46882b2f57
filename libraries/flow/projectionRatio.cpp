#include "flow/projectionRatio.hpp"

#include "operators/lineSymbolOf.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isph
{

namespace
{

/// A periodic lattice of the same spacings: of its waves are those of any other.
Lattice sameSpacings(const Lattice& lattice, int count)
{
    std::array<Axis, 3> axes;
    for (std::size_t d = 0; d < 3; ++d)
    {
        const Axis& axis = lattice.axis(static_cast<int>(d));
        axes[d].name = axis.name;
        if (!axis.active()) { continue; }
        axes[d].count = count;
        axes[d].extent = axis.spacing() * count;
    }
    return {axes, {}};
}

/// -|D|^2 of operators that act line by line, row after row.
AlignedVector<double> squaredLineSymbols(const Lattice& lattice, const KernelSettings& kernel, const ModeRows& rows)
{
    const int count = lattice.activeAxis(0).count;
    std::array<std::vector<double>, 3> symbols;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        symbols[static_cast<std::size_t>(d)] =
            lineSymbolOf(kernel, LaplacianForm::secondDerivative, count, lattice.activeAxis(d).spacing()).first;
    }
    AlignedVector<double> squares;
    for (std::size_t row = 0; row < rows.count(); ++row)
    {
        double ofRow = 0;
        for (int d = 1; d < lattice.dimensions(); ++d)
        {
            const std::size_t index = rows.index(row, d);
            const double symbol = symbols[static_cast<std::size_t>(d)][std::min(index, count - index)];
            ofRow += symbol * symbol;
        }
        for (std::size_t i = 0; i < rows.length(); ++i) { squares.push_back(symbols[0][i] * symbols[0][i] + ofRow); }
    }
    return squares;
}

} // namespace

double largestProjectionRatio(const Lattice& lattice, const FlowSettings& settings)
{
    const KernelSettings& kernel = settings.kernel;
    const int reach = static_cast<int>(kernel.supportRadius * kernel.smoothingLength + 1e-9);
    const Lattice waves = sameSpacings(lattice, 2 * (reach / 2 * 2) + 36);
    const KernelSamples samples(waves, kernel, LaplacianForm::morris);
    FourierTransform transform(waves, 1);
    AlignedVector<double> laplacian = symbolOfWeights(waves, transform, samples.offsets, samples.laplacian, false);
    const double atRest = laplacian[0];
    for (double& value : laplacian) { value = atRest - value; }

    const DerivativeSymbol derivative(waves, kernel, &samples);
    if (lattice.periodic())
    {
        const OperatorBounds bounds = operatorBounds(derivative, laplacian, {waves, settings.dealiasing});
        const bool negative = bounds.leastLaplacian < -1e-12 * bounds.laplacian;
        return negative ? std::numeric_limits<double>::infinity() : bounds.derivativeOverLaplacian;
    }
    const AlignedVector<double> squares = squaredLineSymbols(waves, kernel, derivative.rows());
    double largest = 0;
    for (std::size_t mode = 1; mode < squares.size(); ++mode)
    {
        if (laplacian[mode] <= 0) { return std::numeric_limits<double>::infinity(); }
        largest = std::max(largest, squares[mode] / laplacian[mode]);
    }
    return largest;
}

std::string mirrorCaution(const Lattice& lattice, const FlowSettings& settings)
{
    const bool mirrors = !lattice.periodic() && settings.eigenvalues == Eigenvalues::morris && !settings.directPressure;
    if (!mirrors || settings.continuation == "mirror") { return {}; }
    return "the Laplacian of the pressure mirrors its neighbours at walls, but the continuation does not: most flows "
           "grow "
           "without limit. Write continuation { type mirror; } in system/schemes";
}

} // namespace isph
