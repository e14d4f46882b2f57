#pragma once

#include "continuation/ContinuedTransform.hpp"
#include "continuation/LineSymbol.hpp"

namespace isph
{

/// First and second derivative along one axis, bounded (by its continuation) or periodic (by none): one forward
/// transform of its lines, and one backward for each derivative. Holds at all points, those on walls included.
class ContinuedDerivative
{
public:
    /// \param transform along the axis
    /// \param symbol of a kernel on its extended lines
    ContinuedDerivative(ContinuedTransform transform, const LineSymbol& symbol);

    /// Derivatives of one component of a field, overwritten; an empty span is left out.
    void operator()(std::span<const double> values, std::span<double> first, std::span<double> second,
                    const EndData& data = {});

    /// rate += -carrier df + nu d2f for one component f of a field: its transport along the axis, in one pass, the
    /// derivatives never leaving the cache. An empty carrier, or nu = 0, leaves its term out.
    void addTransport(std::span<const double> values, std::span<const double> carrier, double nu,
                      std::span<double> rate, const EndData& data = {});

private:
    enum class Order
    {
        first,
        second
    };
    /// Fills transform_.result() from the modes of a batch.
    void differentiate(const SpectralField& modes, Order order);

    ContinuedTransform transform_;
    LineSymbol symbol_; ///< over the length, as transforms are not normalised
};

} // namespace isph
