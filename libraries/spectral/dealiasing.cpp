#include "spectral/dealiasing.hpp"

namespace isph
{

const Selection<Dealiasing>& dealiasings()
{
    static constexpr std::array<Selection<Dealiasing>::Variant, 2> table{{
        {"none", "all modes of the lattice", Dealiasing::none},
        {"twoThirds", "drop the upper third of the wavenumbers of each axis", Dealiasing::twoThirds},
    }};
    static_assert(distinct(table));
    static constexpr Selection<Dealiasing> selection("dealiasing", table);
    return selection;
}

RetainedModes::RetainedModes(const Lattice& lattice, Dealiasing dealiasing)
{
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const auto n = static_cast<std::size_t>(lattice.activeAxis(d).count);
        count_[static_cast<std::size_t>(d)] = n;
        largest_[static_cast<std::size_t>(d)] = dealiasing == Dealiasing::none ? n / 2 : (n - 1) / 3;
    }
    length_ = largest_[0] + 1;
}

} // namespace isph
