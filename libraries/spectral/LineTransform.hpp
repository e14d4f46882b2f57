#pragma once

#include "fields/Field.hpp"
#include "spectral/FourierTransform.hpp"

#include <memory>

namespace isph
{

/// Real Fourier transforms of single lines: a batch of lines is a field whose components are the lines.
///
/// A line of length real values has length/2 + 1 modes, those of the non-negative wavenumbers. Neither direction is
/// normalised: backward(forward(f)) = length * f. Plans are made in the constructor, on their own scratch; transforming
/// allocates nothing and runs on the thread that calls.
class LineTransform
{
public:
    /// Plans for fields of this many lines, each of this many values.
    LineTransform(int length, int lines, PlanEffort effort = PlanEffort::estimated);
    ~LineTransform();
    LineTransform(LineTransform&&) noexcept;
    LineTransform& operator=(LineTransform&&) noexcept;

    /// Transforms every line; real stays as it is.
    void forward(const RealField& real, SpectralField& modes) const;

    /// Overwrites modes with scratch.
    void backward(SpectralField& modes, RealField& real) const;

    int length() const;
    int lines() const;

    /// Fields of the right shape, all zero.
    RealField realLines() const;
    SpectralField modesOfLines() const;

private:
    struct Plans;
    std::unique_ptr<Plans> plans_;
};

} // namespace isph
