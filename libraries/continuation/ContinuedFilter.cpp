#include "continuation/ContinuedFilter.hpp"

#include <cassert>
#include <utility>

namespace isph
{

ContinuedFilter::ContinuedFilter(ContinuedTransform transform, std::vector<double> factors)
    : transform_(std::move(transform)), factors_(std::move(factors))
{
    assert(factors_.size() == static_cast<std::size_t>(transform_.length() / 2 + 1));
    for (double& factor : factors_) { factor /= transform_.length(); }
}

void ContinuedFilter::operator()(std::span<double> values, const EndData& data)
{
    for (std::size_t batch = 0; batch < transform_.batches(); ++batch)
    {
        const SpectralField& modes = transform_.forward(batch, values, data);
        SpectralField& result = transform_.result();
        for (int line = 0; line < modes.components(); ++line)
        {
            for (std::size_t m = 0; m < modes.size(); ++m) { result[line][m] = factors_[m] * modes[line][m]; }
        }
        transform_.backward(batch, values);
    }
}

} // namespace isph
