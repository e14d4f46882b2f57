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

bool ModeRows::checkerboard(std::size_t row, std::size_t i) const
{
    if (wavenumbers_.derivative[0][i] != 0) { return false; }
    for (int d = 1; d < dimensions_; ++d)
    {
        if (derivative(row, d) != 0) { return false; }
    }
    return wavenumbers_.k[0][i] != 0 || k2OfRow(row) > 0;
}

} // namespace isph
