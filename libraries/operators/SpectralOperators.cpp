#include "operators/SpectralOperators.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace isph
{

SpectralOperators::SpectralOperators(const Lattice& lattice, DerivativeSymbol derivative,
                                     AlignedVector<double> laplacian)
    : derivative_(std::move(derivative)),
      laplacian_(std::move(laplacian)),
      transform_(lattice, 1),
      real_(1, lattice.points()),
      scratch_(1, transform_.modes())
{
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        modes_[static_cast<std::size_t>(d)] = SpectralField(1, transform_.modes());
    }
    for (auto& row : d_) { row.resize(derivative_.rows().length()); }
}

void SpectralOperators::forward(std::span<const double> values, SpectralField& modes)
{
    std::ranges::copy(values, real_[0].begin());
    transform_.forward(real_, modes);
}

void SpectralOperators::backward(std::span<double> values)
{
    transform_.backward(scratch_, real_);
    const double scale = 1.0 / static_cast<double>(transform_.points());
    std::ranges::transform(real_[0], values.begin(), [scale](double value) { return scale * value; });
}

void SpectralOperators::addDerivative(const SpectralField& modes, int axis, double sign, bool add)
{
    const ModeRows& rows = derivative_.rows();
    const auto in = modes[0];
    const auto out = scratch_[0];
    for (std::size_t row = 0; row < rows.count(); ++row)
    {
        derivative_.row(row, 0, rows.length(), {d_[0].data(), d_[1].data(), d_[2].data()});
        const std::size_t first = rows.offset(row);
        for (std::size_t i = 0; i < rows.length(); ++i)
        {
            const double d = sign * d_[static_cast<std::size_t>(axis)][i];
            const std::complex<double> term(-d * in[first + i].imag(), d * in[first + i].real());
            out[first + i] = add ? out[first + i] + term : term;
        }
    }
}

void SpectralOperators::gradient(const RealField& f, int component, RealField& gradient)
{
    forward(f[component], modes_[0]);
    for (int d = 0; d < gradient.components(); ++d)
    {
        addDerivative(modes_[0], d, 1, false);
        backward(gradient[d]);
    }
}

void SpectralOperators::divergence(const RealField& u, RealField& divergence)
{
    for (int d = 0; d < u.components(); ++d)
    {
        forward(u[d], modes_[0]);
        addDerivative(modes_[0], d, 1, d > 0);
    }
    backward(divergence[0]);
}

void SpectralOperators::laplacian(const RealField& f, RealField& laplacian)
{
    assert(laplacian_.size() == transform_.modes());
    for (int component = 0; component < f.components(); ++component)
    {
        forward(f[component], modes_[0]);
        std::ranges::transform(modes_[0][0], laplacian_, scratch_[0].begin(),
                               [](const std::complex<double>& c, double lambda) { return -lambda * c; });
        backward(laplacian[component]);
    }
}

void SpectralOperators::curl(const RealField& u, RealField& vorticity)
{
    const int dimensions = u.components();
    for (int d = 0; d < dimensions; ++d) { forward(u[d], modes_[static_cast<std::size_t>(d)]); }
    if (dimensions == 2)
    {
        addDerivative(modes_[1], 0, 1, false);
        addDerivative(modes_[0], 1, -1, true);
        backward(vorticity[0]);
        return;
    }
    for (int component = 0; component < 3; ++component)
    {
        const int next = (component + 1) % 3;
        const int last = (component + 2) % 3;
        addDerivative(modes_[static_cast<std::size_t>(last)], next, 1, false);
        addDerivative(modes_[static_cast<std::size_t>(next)], last, -1, true);
        backward(vorticity[component]);
    }
}

} // namespace isph
