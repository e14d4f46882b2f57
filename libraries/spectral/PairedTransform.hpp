#pragma once

#include "spectral/FftwPlan.hpp"

#include <cstddef>
#include <vector>

namespace isph
{

/// Real transforms of a few lines at once, two lines to a complex Fourier transform. Internal to spectral.
///
/// A DCT-II is a Fourier transform of the line with its even samples first and its odd ones after them in reverse
/// (Makhoul 1980); a DST-II is the DCT-II of samples of alternating sign, in reverse. The caller, who copies lines into
/// rows anyway, puts values and modes where valueRow and modeRow say.
class PairedTransform
{
public:
    enum class Kind
    {
        fourier, ///< analysis: real parts, then imaginary ones in reverse; synthesis: its inverse
        cosine2, ///< analysis: DCT-II; synthesis: DCT-III
        sine2    ///< DST-II and DST-III
    };

    /// Lines transformed together: a row holds one sample of each.
    static constexpr std::size_t lanes = 8;

    /// To be called by withPlanner. \param rigor flag of FFTW
    PairedTransform(std::size_t count, Kind kind, unsigned rigor);

    std::size_t valueRow(std::size_t j) const;
    double valueSign(std::size_t j) const { return kind_ == Kind::sine2 && j % 2 == 1 ? -1 : 1; }
    std::size_t modeRow(std::size_t k) const { return kind_ == Kind::sine2 ? count_ - 1 - k : k; }

    /// Rows of values to rows of modes and back, in the scaling of FFTW. 64-byte aligned; the first are overwritten.
    void analyse(double* in, double* rows) const;
    void synthesise(double* rows, double* out) const;

    bool planned() const { return forward_ && backward_; }

private:
    std::size_t count_;
    Kind kind_;
    std::vector<double> cosine_; ///< of pi k/(2 count), k <= count/2
    std::vector<double> sine_;
    FftwPlan forward_;
    FftwPlan backward_;
};

/// A complex transform of rows of pairs of lines, which it overwrites; in place, FFTW would ask for memory each time.
FftwPlan planRows(std::size_t count, int direction, unsigned rigor);
void executeRows(const FftwPlan& plan, double* in, double* out);

} // namespace isph
