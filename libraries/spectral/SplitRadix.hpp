#pragma once

#include "spectral/PairedTransform.hpp"

#include <cstddef>
#include <vector>

namespace isph
{

/// DCT-I and DST-I of a few real lines at once. Internal to spectral.
///
/// A line of N intervals is split into its even samples, which are such a transform of half the size, and its odd ones,
/// whose DCT-II is one Fourier transform of N/2 values; two lines share a complex transform. Unlike the cosine
/// transforms that divide by sines, this loses no digits, and all levels together transform little more than N values
/// (Makhoul 1980 for the DCT-II; the splitting is that of FFTW's own).
class SplitRadix
{
public:
    enum class Parity
    {
        even, ///< DCT-I: rows 0 ... N
        odd,  ///< DST-I: rows 1 ... N - 1; the two others are ignored
    };

    /// Lines transformed together: a row holds one sample of each.
    static constexpr std::size_t lanes = PairedTransform::lanes;

    /// To be called by withPlanner. \param rigor flag of FFTW
    SplitRadix(std::size_t intervals, Parity parity, unsigned rigor);

    /// Doubles that transform needs, 64-byte aligned.
    std::size_t scratchSize() const { return scratchRows_ * lanes; }

    /// Transforms rows in place, in the scaling of FFTW. Both pointers are 64-byte aligned.
    void transform(double* rows, double* scratch) const { transform(0, rows, 1, rows, scratch); }

    bool planned() const;

private:
    /// One splitting: intervals = 2 half.
    struct Level
    {
        std::size_t half;
        std::vector<double> cosine; ///< of pi k/(2 half), k <= half/2
        std::vector<double> sine;
        FftwPlan odd; ///< of half values
    };

    void transform(std::size_t level, const double* in, std::size_t stride, double* out, double* scratch) const;
    void gatherOdd(const Level& level, const double* in, std::size_t stride, double* odd) const;
    void combine(const Level& level, const double* even, const double* odd, double* out) const;
    void transformSmallest(const double* in, std::size_t stride, double* out, double* scratch) const;

    Parity parity_;
    std::vector<Level> levels_;
    std::size_t smallest_; ///< intervals that are not split
    FftwPlan extension_;   ///< of 2 smallest_ values
    std::size_t scratchRows_ = 0;
};

} // namespace isph
