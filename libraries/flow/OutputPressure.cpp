#include "flow/OutputPressure.hpp"

#include <algorithm>

namespace isph
{

OutputPressure::OutputPressure(const Lattice& lattice)
    : rows_(lattice),
      transform_(lattice, 1),
      real_(1, lattice.points()),
      modes_(1, transform_.modes()),
      sum_(1, transform_.modes())
{
}

void OutputPressure::evaluate(const RealField* velocity, const RealField* force, RealField& pressure)
{
    const auto sum = sum_[0];
    const auto modes = modes_[0];
    std::ranges::fill(sum, 0.0);

    // Adds factor(k)/k^2 times the transform of real_ to the sum.
    const auto& k0 = rows_.wavenumbers().derivative[0];
    const auto addTransform = [&](auto factor)
    {
        transform_.forward(real_, modes_);
        for (std::size_t row = 0; row < rows_.count(); ++row)
        {
            const std::array<double, 2> kRow{rows_.dimensions() > 1 ? rows_.derivative(row, 1) : 0,
                                             rows_.dimensions() > 2 ? rows_.derivative(row, 2) : 0};
            for (std::size_t i = 0; i < rows_.length(); ++i)
            {
                const std::array<double, 3> k{k0[i], kRow[0], kRow[1]};
                const double k2 = k[0] * k[0] + k[1] * k[1] + k[2] * k[2];
                if (k2 == 0) { continue; }
                sum[rows_.offset(row) + i] += factor(k, k2, modes[rows_.offset(row) + i]);
            }
        }
    };

    for (int a = 0; velocity != nullptr && a < rows_.dimensions(); ++a)
    {
        for (int b = a; b < rows_.dimensions(); ++b)
        {
            std::ranges::transform((*velocity)[a], (*velocity)[b], real_[0].begin(), std::multiplies{});
            const double twice = a == b ? 1 : 2;
            addTransform([a = static_cast<std::size_t>(a), b = static_cast<std::size_t>(b),
                          twice](const std::array<double, 3>& k, double k2, const std::complex<double>& c)
                         { return (-twice * (k[a] / k2) * k[b]) * c; });
        }
    }
    for (int a = 0; force != nullptr && a < rows_.dimensions(); ++a)
    {
        std::ranges::copy((*force)[a], real_[0].begin());
        addTransform(
            [a = static_cast<std::size_t>(a)](const std::array<double, 3>& k, double k2, const std::complex<double>& c)
            { return std::complex<double>(k[a] / k2 * c.imag(), -k[a] / k2 * c.real()); });
    }

    transform_.backward(sum_, pressure);
    const double scale = 1.0 / static_cast<double>(transform_.points());
    for (double& value : pressure[0]) { value *= scale; }
}

} // namespace isph
