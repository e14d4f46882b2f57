#include "caseFields/VelocityDerivatives.hpp"

#include "core/Error.hpp"

#include <algorithm>
#include <cassert>
#include <fmt/format.h>

namespace isph
{

namespace
{

const Lattice& periodic(const Lattice& lattice)
{
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        if (!lattice.activeAxis(d).periodic())
        {
            throw Error(Fault::input, {"constant/lattice", 0, ""},
                        fmt::format("derivatives need a lattice that is periodic along every axis, but {} is bounded",
                                    lattice.activeAxis(d).name),
                        "leave out the derived fields");
        }
    }
    return lattice;
}

/// +1 where the normal of the active axes a, b completes a, b, n to a right-handed set, -1 for x and z.
double normalSign(const Lattice& lattice) { return lattice.direction(1) - lattice.direction(0) == 2 ? -1 : 1; }

constexpr std::complex<double> i{0, 1};

} // namespace

VelocityDerivatives::VelocityDerivatives(const RealField& U, const Lattice& lattice)
    : lattice_(periodic(lattice)),
      wavenumbers_(lattice),
      transform_(lattice, 1),
      modes_(lattice.dimensions(), transform_.modes()),
      scratch_(1, transform_.modes())
{
    assert(U.components() == lattice.dimensions() && U.size() == lattice.points());
    RealField component(1, U.size());
    const double scale = 1 / static_cast<double>(U.size());
    for (int d = 0; d < U.components(); ++d)
    {
        std::copy(U[d].begin(), U[d].end(), component[0].begin());
        transform_.forward(component, scratch_);
        for (std::size_t n = 0; n < modes_.size(); ++n) { modes_[d][n] = scale * scratch_[0][n]; }
    }
}

template<class Coefficient>
RealField VelocityDerivatives::field(Coefficient coefficient)
{
    const auto extents = modeExtents(lattice_);
    const auto wavenumber = [this](std::size_t d, std::size_t index)
    { return wavenumbers_.derivative[d].empty() ? 0.0 : wavenumbers_.derivative[d][index]; };

    std::size_t n = 0;
    for (std::size_t i2 = 0; i2 < extents[2]; ++i2)
    {
        for (std::size_t i1 = 0; i1 < extents[1]; ++i1)
        {
            for (std::size_t i0 = 0; i0 < extents[0]; ++i0)
            {
                scratch_[0][n] = coefficient(n, std::array{wavenumber(0, i0), wavenumber(1, i1), wavenumber(2, i2)});
                ++n;
            }
        }
    }
    RealField result(1, transform_.points());
    transform_.backward(scratch_, result);
    return result;
}

RealField VelocityDerivatives::vorticity()
{
    if (lattice_.dimensions() == 2)
    {
        const double sign = normalSign(lattice_);
        return field([&](std::size_t n, const auto& k)
                     { return sign * i * (k[0] * modes_[1][n] - k[1] * modes_[0][n]); });
    }
    RealField result(3, transform_.points());
    for (int d = 0; d < 3; ++d)
    {
        const int a = (d + 1) % 3;
        const int b = (d + 2) % 3;
        const RealField component = field(
            [&](std::size_t n, const auto& k) {
                return i *
                       (k[static_cast<std::size_t>(a)] * modes_[b][n] - k[static_cast<std::size_t>(b)] * modes_[a][n]);
            });
        std::copy(component[0].begin(), component[0].end(), result[d].begin());
    }
    return result;
}

RealField VelocityDerivatives::divergence()
{
    return field(
        [&](std::size_t n, const auto& k)
        {
            Mode sum = 0;
            for (int d = 0; d < modes_.components(); ++d) { sum += k[static_cast<std::size_t>(d)] * modes_[d][n]; }
            return i * sum;
        });
}

RealField VelocityDerivatives::Q()
{
    const auto gradient = [&](int component, int direction)
    {
        return field([&](std::size_t n, const auto& k)
                     { return i * k[static_cast<std::size_t>(direction)] * modes_[component][n]; });
    };
    // The second invariant is the sum of the principal minors of the gradient: one for each pair of axes.
    RealField result(1, transform_.points());
    for (int a = 0; a < lattice_.dimensions(); ++a)
    {
        for (int b = a + 1; b < lattice_.dimensions(); ++b)
        {
            const RealField aa = gradient(a, a);
            const RealField bb = gradient(b, b);
            const RealField ab = gradient(a, b);
            const RealField ba = gradient(b, a);
            for (std::size_t n = 0; n < result.size(); ++n)
            {
                result[0][n] += aa[0][n] * bb[0][n] - ab[0][n] * ba[0][n];
            }
        }
    }
    return result;
}

RealField VelocityDerivatives::streamFunction()
{
    assert(lattice_.dimensions() == 2);
    RealField psi = field(
        [&](std::size_t n, const auto& k) -> Mode
        {
            const double k2 = k[0] * k[0] + k[1] * k[1];
            return k2 > 0 ? i * (k[0] * modes_[1][n] - k[1] * modes_[0][n]) / k2 : 0;
        });

    // The part of the mean flow grows from point to point, and the Fourier series cannot hold it.
    const auto gain = streamFunctionGain();
    const std::array<int, 3> count{lattice_.axis(0).count, lattice_.axis(1).count, lattice_.axis(2).count};
    std::size_t n = 0;
    for (int iz = 0; iz < count[2]; ++iz)
    {
        for (int iy = 0; iy < count[1]; ++iy)
        {
            for (int ix = 0; ix < count[0]; ++ix)
            {
                psi[0][n++] += gain[0] * ix / count[0] + gain[1] * iy / count[1] + gain[2] * iz / count[2];
            }
        }
    }
    return psi;
}

std::array<double, 3> VelocityDerivatives::streamFunctionGain() const
{
    assert(lattice_.dimensions() == 2);
    std::array<double, 3> gain{};
    gain[static_cast<std::size_t>(lattice_.direction(0))] = -modes_[1][0].real() * lattice_.activeAxis(0).extent;
    gain[static_cast<std::size_t>(lattice_.direction(1))] = modes_[0][0].real() * lattice_.activeAxis(1).extent;
    return gain;
}

} // namespace isph
