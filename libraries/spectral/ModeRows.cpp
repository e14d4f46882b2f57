#include "spectral/ModeRows.hpp"

#include "spectral/FourierTransform.hpp"

namespace isph
{

ModeRows::ModeRows(const Lattice& lattice)
    : dimensions_(lattice.dimensions()),
      points0_(static_cast<std::size_t>(lattice.activeAxis(0).count)),
      extents_(modeExtents(lattice)),
      wavenumbers_(lattice)
{
}

double ModeRows::k2OfRow(std::size_t row) const
{
    double k2 = 0;
    for (int d = 1; d < dimensions_; ++d) { k2 += k(row, d) * k(row, d); }
    return k2;
}

} // namespace isph
