#include "spectral/SplitRadix.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isph
{

namespace
{

constexpr std::size_t lanes = SplitRadix::lanes;

void copyRow(const double* from, double factor, double* to)
{
    for (std::size_t c = 0; c < lanes; ++c) { to[c] = factor * from[c]; }
}

} // namespace

SplitRadix::SplitRadix(std::size_t intervals, Parity parity, unsigned rigor) : parity_(parity), smallest_(intervals)
{
    // Below this the extension is cheaper than another splitting.
    constexpr std::size_t worthSplitting = 32;
    while (smallest_ % 2 == 0 && smallest_ >= worthSplitting)
    {
        const std::size_t half = smallest_ / 2;
        Level level{half, {}, {}, planRows(half, FFTW_FORWARD, rigor)};
        for (std::size_t k = 0; 2 * k <= half; ++k)
        {
            const double angle = std::numbers::pi * static_cast<double>(k) / static_cast<double>(2 * half);
            level.cosine.push_back(std::cos(angle));
            level.sine.push_back(std::sin(angle));
        }
        levels_.push_back(std::move(level));
        scratchRows_ += 3 * half + 1;
        smallest_ = half;
    }
    extension_ = planRows(2 * smallest_, FFTW_FORWARD, rigor);
    scratchRows_ += 4 * smallest_;
}

bool SplitRadix::planned() const
{
    return extension_ && std::all_of(levels_.begin(), levels_.end(), [](const Level& l) { return l.odd != nullptr; });
}

void SplitRadix::transform(std::size_t level, const double* in, std::size_t stride, double* out, double* scratch) const
{
    if (level == levels_.size())
    {
        transformSmallest(in, stride, out, scratch);
        return;
    }
    const Level& split = levels_[level];
    double* samples = scratch;
    double* odd = samples + split.half * lanes;
    double* even = odd + split.half * lanes;
    transform(level + 1, in, 2 * stride, even, even + (split.half + 1) * lanes);
    gatherOdd(split, in, stride, samples);
    executeRows(split.odd, samples, odd);
    combine(split, even, odd, out);
}

void SplitRadix::gatherOdd(const Level& level, const double* in, std::size_t stride, double* odd) const
{
    // Every other odd sample upwards, then the rest downwards: a DCT-II is the transform of that. A DST-II is the
    // DCT-II of samples of alternating sign, in reverse.
    const double sign = parity_ == Parity::even ? 1 : -1;
    for (std::size_t j = 0; j < level.half; ++j)
    {
        const double* sample = in + (2 * j + 1) * stride * lanes;
        const bool upwards = j % 2 == 0;
        copyRow(sample, upwards ? 1 : sign, odd + (upwards ? j / 2 : level.half - 1 - j / 2) * lanes);
    }
}

void SplitRadix::combine(const Level& level, const double* even, const double* odd, double* out) const
{
    const std::size_t half = level.half;
    const std::size_t intervals = 2 * half;
    // Row k of the DCT-II meets row k of the even samples (DST: row half - k, with the signs of a sine).
    const auto meet = [&](std::size_t k, const double* value)
    {
        if (parity_ == Parity::even)
        {
            const double* e = even + k * lanes;
            double* low = out + k * lanes;
            double* high = out + (intervals - k) * lanes;
            for (std::size_t c = 0; c < lanes; ++c)
            {
                low[c] = e[c] + value[c];
                high[c] = e[c] - value[c];
            }
            return;
        }
        const double* e = even + (half - k) * lanes;
        double* low = out + (half - k) * lanes;
        double* high = out + (half + k) * lanes;
        for (std::size_t c = 0; c < lanes; ++c)
        {
            low[c] = value[c] + e[c];
            high[c] = value[c] - e[c];
        }
    };

    double first[lanes];
    double second[lanes];
    copyRow(odd, 2, first);
    if (parity_ == Parity::even)
    {
        copyRow(even + half * lanes, 1, out + half * lanes);
        meet(0, first);
    }
    else { copyRow(first, 1, out + half * lanes); }
    for (std::size_t k = 1; 2 * k <= half; ++k)
    {
        const double cosine = level.cosine[k];
        const double sine = level.sine[k];
        const double* v = odd + k * lanes;
        const double* w = odd + (half - k) * lanes;
        // The two lines of a pair are told apart by the symmetry of real transforms.
        for (std::size_t c = 0; c < lanes; c += 2)
        {
            const double realA = v[c] + w[c];
            const double imaginaryA = v[c + 1] - w[c + 1];
            const double realB = v[c + 1] + w[c + 1];
            const double imaginaryB = w[c] - v[c];
            first[c] = cosine * realA + sine * imaginaryA;
            first[c + 1] = cosine * realB + sine * imaginaryB;
            second[c] = sine * realA - cosine * imaginaryA;
            second[c + 1] = sine * realB - cosine * imaginaryB;
        }
        meet(k, first);
        if (2 * k != half) { meet(half - k, second); }
    }
}

void SplitRadix::transformSmallest(const double* in, std::size_t stride, double* out, double* scratch) const
{
    const std::size_t n = smallest_;
    double* modes = scratch + 2 * n * lanes;
    const auto row = [&](std::size_t j) { return in + j * stride * lanes; };
    if (parity_ == Parity::even)
    {
        copyRow(row(0), 1, scratch);
        copyRow(row(n), 1, scratch + n * lanes);
        for (std::size_t j = 1; j < n; ++j)
        {
            copyRow(row(j), 1, scratch + j * lanes);
            copyRow(row(j), 1, scratch + (2 * n - j) * lanes);
        }
        executeRows(extension_, scratch, modes);
        // The transform of an even line is real: the two of a pair do not mix.
        std::copy_n(modes, (n + 1) * lanes, out);
        return;
    }
    std::fill_n(scratch, lanes, 0.0);
    std::fill_n(scratch + n * lanes, lanes, 0.0);
    for (std::size_t j = 1; j < n; ++j)
    {
        copyRow(row(j), 1, scratch + j * lanes);
        copyRow(row(j), -1, scratch + (2 * n - j) * lanes);
    }
    executeRows(extension_, scratch, modes);
    // That of an odd line is imaginary, -i times the sine transform.
    for (std::size_t k = 1; k < n; ++k)
    {
        for (std::size_t c = 0; c < lanes; c += 2)
        {
            out[k * lanes + c] = -modes[k * lanes + c + 1];
            out[k * lanes + c + 1] = modes[k * lanes + c];
        }
    }
}

} // namespace isph
