#pragma once

#include "spectral/FourierTransform.hpp"

#include <array>
#include <memory>
#include <span>

namespace isph
{

/// Functions that lines of real values are expanded in; n values at j, n coefficients at k, counted from 0. The
/// formulas are those of the forward transform; bounds of sums are 0 and n - 1 unless written.
enum class RealBasis
{
    fourier, ///< real parts of sum f_j exp(-2 pi i j k/n), k = 0 ... n/2, then imaginary ones, k = (n-1)/2 ... 1
    cosine1, ///< f_0 + (-1)^k f_{n-1} + 2 sum_1^{n-2} f_j cos(pi j k/(n-1))
    cosine2, ///< 2 sum f_j cos(pi (j + 1/2) k/n)
    cosine3, ///< f_0 + 2 sum_1^{n-1} f_j cos(pi j (k + 1/2)/n)
    cosine4, ///< 2 sum f_j cos(pi (j + 1/2)(k + 1/2)/n)
    sine1,   ///< 2 sum f_j sin(pi (j + 1)(k + 1)/(n+1))
    sine2,   ///< 2 sum f_j sin(pi (j + 1/2)(k + 1)/n)
    sine3,   ///< (-1)^k f_{n-1} + 2 sum_0^{n-2} f_j sin(pi (j + 1)(k + 1/2)/n)
    sine4,   ///< 2 sum f_j sin(pi (j + 1/2)(k + 1/2)/n)
};

/// Lines of a 3-D array, x fastest: all that run along an axis, from one index on.
struct Lines
{
    std::array<int, 3> extents; ///< of the array; 1 for an axis left out
    int axis;                   ///< 0, 1, 2
    int first = 0;              ///< index of a line's first value
    int count;                  ///< values of a line; those outside stay as they are
};

/// Real-to-real transform along one axis of a 3-D array, all lines at once, in place.
///
/// Neither direction is normalised: backward(forward(f)) = factor() * f. Plans are made in the constructor, on their
/// own scratch; transforming allocates nothing. Arrays are aligned to 64 bytes, as fields are. An object has one
/// scratch: its transforms are not for several threads at once, but use those there are.
///
/// Lines are transformed in blocks, two to a complex transform (PairedTransform, SplitRadix): FFTW's own cosine and
/// sine transforms cost one and a half to two times as much. cosine4 and sine4 still are FFTW's, which asks for a
/// buffer each time.
class RealTransform
{
public:
    /// \throws Error(input) if a line is too short (cosine1 needs two values, the others one)
    RealTransform(const Lines& lines, RealBasis basis, PlanEffort effort = PlanEffort::estimated);
    ~RealTransform();
    RealTransform(RealTransform&&) noexcept;
    RealTransform& operator=(RealTransform&&) noexcept;

    void forward(std::span<double> values) const;
    void backward(std::span<double> values) const;

    /// n (fourier), 2 (n - 1) (cosine1), 2 (n + 1) (sine1), 2 n (the others).
    double factor() const;

private:
    struct Plans;
    std::unique_ptr<Plans> plans_;
};

} // namespace isph
