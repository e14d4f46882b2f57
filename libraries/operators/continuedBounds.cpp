#include "operators/continuedBounds.hpp"

#include "operators/lineSymbolOf.hpp"

#include <algorithm>
#include <cmath>

namespace isph
{

OperatorBounds continuedBounds(const Lattice& lattice, const Continuations& continuations, const KernelSettings& kernel,
                               LaplacianForm form)
{
    OperatorBounds bounds;
    double magnitude2 = 0;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const Axis& axis = lattice.activeAxis(d);
        const auto& continuation = continuations[static_cast<std::size_t>(lattice.direction(d))];
        const int length = axis.count + (continuation ? continuation->newPoints() : 0);
        const LineSymbol symbol = lineSymbolOf(kernel, form, length, axis.spacing());
        double largestFirst = 0;
        double largestSecond = 0;
        double leastSecond = 0;
        for (std::size_t m = 1; m < symbol.second.size(); ++m)
        {
            const double first = std::abs(symbol.first[m]);
            const double second = symbol.second[m];
            largestFirst = std::max(largestFirst, first);
            largestSecond = std::max(largestSecond, second);
            leastSecond = std::min(leastSecond, second);
            // Of all axes together the ratio is largest along one of them.
            if (second > 0)
            {
                bounds.derivativeOverLaplacian = std::max(bounds.derivativeOverLaplacian, first * first / second);
            }
        }
        bounds.derivative[static_cast<std::size_t>(d)] = largestFirst;
        magnitude2 += largestFirst * largestFirst;
        bounds.laplacian += largestSecond;
        bounds.leastLaplacian += leastSecond;
    }
    bounds.derivativeMagnitude = std::sqrt(magnitude2);
    return bounds;
}

} // namespace isph
