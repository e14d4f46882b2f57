#include "spectral/Wavenumbers.hpp"

#include <numbers>

namespace isph
{

Wavenumbers::Wavenumbers(const Lattice& lattice)
{
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const Axis& axis = lattice.activeAxis(d);
        const int n = axis.count;
        const int stored = d == 0 ? n / 2 + 1 : n;
        auto& all = k[static_cast<std::size_t>(d)];
        auto& odd = derivative[static_cast<std::size_t>(d)];
        for (int i = 0; i < stored; ++i)
        {
            const int mode = i <= n / 2 ? i : i - n;
            const double value = 2 * std::numbers::pi * mode / axis.extent;
            all.push_back(value);
            odd.push_back(2 * mode == n ? 0 : value);
        }
    }
}

} // namespace isph
