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

void ContinuedDerivative::differentiate(const SpectralField& modes, Order order)
{
    SpectralField& result = transform_.result();
    const std::size_t count = modes.size();
    for (int line = 0; line < modes.components(); ++line)
    {
        const auto* in = reinterpret_cast<const double*>(modes[line].data());
        auto* out = reinterpret_cast<double*>(result[line].data());
        if (order == Order::first)
        {
            for (std::size_t m = 0; m < count; ++m)
            {
                out[2 * m] = -symbol_.first[m] * in[2 * m + 1];
                out[2 * m + 1] = symbol_.first[m] * in[2 * m];
            }
        }
        else
        {
            for (std::size_t m = 0; m < count; ++m)
            {
                out[2 * m] = -symbol_.second[m] * in[2 * m];
                out[2 * m + 1] = -symbol_.second[m] * in[2 * m + 1];
            }
        }
    }
}

void ContinuedDerivative::operator()(std::span<const double> values, std::span<double> first, std::span<double> second,
                                     const EndData& data)
{
    for (std::size_t batch = 0; batch < transform_.batches(); ++batch)
    {
        const SpectralField& modes = transform_.forward(batch, values, data);
        if (!first.empty())
        {
            differentiate(modes, Order::first);
            transform_.backward(batch, first);
        }
        if (!second.empty())
        {
            differentiate(modes, Order::second);
            transform_.backward(batch, second);
        }
    }
}

void ContinuedDerivative::addTransport(std::span<const double> values, std::span<const double> carrier, double nu,
                                       std::span<double> rate, const EndData& data)
{
    for (std::size_t batch = 0; batch < transform_.batches(); ++batch)
    {
        const SpectralField& modes = transform_.forward(batch, values, data);
        if (!carrier.empty())
        {
            differentiate(modes, Order::first);
            transform_.backward(batch, [&](std::size_t point, double slope) { rate[point] -= carrier[point] * slope; });
        }
        if (nu > 0)
        {
            differentiate(modes, Order::second);
            transform_.backward(batch, [&](std::size_t point, double curvature) { rate[point] += nu * curvature; });
        }
    }
}

} // namespace isph
