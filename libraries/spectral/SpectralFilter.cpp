#include "spectral/SpectralFilter.hpp"

#include <algorithm>
#include <cmath>

namespace isph
{

const Selection<FilterSettings::Type>& filters()
{
    using Type = FilterSettings::Type;
    static constexpr std::array<Selection<Type>::Variant, 3> table{{
        {"none", "no filter", Type::none},
        {"exponential", "exp(-strength (|k|/kNyquist)^order) on each axis, once a step", Type::exponential},
        {"cutoff", "drops the modes above a fraction of the Nyquist wavenumber, once a step", Type::cutoff},
    }};
    static_assert(distinct(table));
    static constexpr Selection<Type> selection("filter", table);
    return selection;
}

double filterFactor(const FilterSettings& settings, double fraction)
{
    switch (settings.type)
    {
    case FilterSettings::Type::exponential:
        return std::exp(-settings.strength * std::pow(fraction, settings.order));
    case FilterSettings::Type::cutoff:
        return fraction <= settings.fraction ? 1 : 0;
    case FilterSettings::Type::none:
        break;
    }
    return 1;
}

std::array<std::vector<double>, 3> filterFactors(const Lattice& lattice, const FilterSettings& settings)
{
    std::array<std::vector<double>, 3> factors;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const int n = lattice.activeAxis(d).count;
        for (int i = 0; i < (d == 0 ? n / 2 + 1 : n); ++i)
        {
            factors[static_cast<std::size_t>(d)].push_back(filterFactor(settings, 2.0 * std::min(i, n - i) / n));
        }
    }
    return factors;
}

} // namespace isph
