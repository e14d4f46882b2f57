#pragma once

#include "continuation/ContinuedTransform.hpp"

namespace isph
{

/// A low-pass filter along one axis, bounded (by its continuation) or periodic.
class ContinuedFilter
{
public:
    /// \param transform along the axis
    /// \param factors of the modes 0 ... length/2 of an extended line
    ContinuedFilter(ContinuedTransform transform, std::vector<double> factors);

    /// Filters one component of a field in place, values on walls included.
    void operator()(std::span<double> values, const EndData& data = {});

private:
    ContinuedTransform transform_;
    std::vector<double> factors_; ///< over the length, as transforms are not normalised
};

} // namespace isph
