#include "continuation/ContinuedDerivative.hpp"

#include <cassert>

namespace isph
{

ContinuedDerivative::ContinuedDerivative(ContinuedTransform transform, const LineSymbol& symbol)
    : transform_(std::move(transform)), symbol_(symbol)
{
    assert(symbol_.first.size() == static_cast<std::size_t>(transform_.length() / 2 + 1));
    for (double& value : symbol_.first) { value /= transform_.length(); }
    for (double& value : symbol_.second) { value /= transform_.length(); }
}

void ContinuedDerivative::operator()(std::span<const double> values, std::span<double> first, std::span<double> second,
                                     const WallData& data)
{
    const auto apply = [this](const SpectralField& modes, auto factor)
    {
        SpectralField& result = transform_.result();
        for (int line = 0; line < modes.components(); ++line)
        {
            const auto in = modes[line];
            const auto out = result[line];
            for (std::size_t m = 0; m < in.size(); ++m) { out[m] = factor(m, in[m]); }
        }
    };
    for (std::size_t batch = 0; batch < transform_.batches(); ++batch)
    {
        const SpectralField& modes = transform_.forward(batch, values, data);
        if (!first.empty())
        {
            apply(modes, [this](std::size_t m, const std::complex<double>& c)
                  { return std::complex<double>(-symbol_.first[m] * c.imag(), symbol_.first[m] * c.real()); });
            transform_.backward(batch, first);
        }
        if (!second.empty())
        {
            apply(modes, [this](std::size_t m, const std::complex<double>& c) { return -symbol_.second[m] * c; });
            transform_.backward(batch, second);
        }
    }
}

} // namespace isph
