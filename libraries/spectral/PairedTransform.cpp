#include "spectral/PairedTransform.hpp"

#include "fields/AlignedAllocator.hpp"

#include <cmath>
#include <numbers>

namespace isph
{

namespace
{

constexpr std::size_t lanes = PairedTransform::lanes;

} // namespace

FftwPlan planRows(std::size_t count, int direction, unsigned rigor)
{
    AlignedVector<double> in(count * lanes);
    AlignedVector<double> out(count * lanes);
    constexpr int width = lanes / 2;
    const auto n = static_cast<int>(count);
    return FftwPlan(fftw_plan_many_dft(1, &n, width, reinterpret_cast<fftw_complex*>(in.data()), nullptr, width, 1,
                                       reinterpret_cast<fftw_complex*>(out.data()), nullptr, width, 1, direction,
                                       rigor | FFTW_DESTROY_INPUT));
}

void executeRows(const FftwPlan& plan, double* in, double* out)
{
    fftw_execute_dft(plan.get(), reinterpret_cast<fftw_complex*>(in), reinterpret_cast<fftw_complex*>(out));
}

PairedTransform::PairedTransform(std::size_t count, Kind kind, unsigned rigor)
    : count_(count),
      kind_(kind),
      forward_(planRows(count, FFTW_FORWARD, rigor)),
      backward_(planRows(count, FFTW_BACKWARD, rigor))
{
    for (std::size_t k = 0; 2 * k <= count; ++k)
    {
        const double angle = std::numbers::pi * static_cast<double>(k) / static_cast<double>(2 * count);
        cosine_.push_back(std::cos(angle));
        sine_.push_back(std::sin(angle));
    }
}

std::size_t PairedTransform::valueRow(std::size_t j) const
{
    if (kind_ == Kind::fourier) { return j; }
    return j % 2 == 0 ? j / 2 : count_ - 1 - j / 2;
}

void PairedTransform::analyse(double* in, double* rows) const
{
    executeRows(forward_, in, rows);
    const bool fourier = kind_ == Kind::fourier;
    if (!fourier)
    {
        for (std::size_t c = 0; c < lanes; ++c) { rows[c] *= 2; }
    }
    // A Fourier transform of even count has its last real part in place.
    const std::size_t end = fourier ? (count_ + 1) / 2 : count_ / 2 + 1;
    for (std::size_t k = 1; k < end; ++k)
    {
        // Twice the transforms of the two lines: told apart by the symmetry of real transforms.
        double* v = rows + k * lanes;
        double* w = rows + (count_ - k) * lanes;
        const double cosine = cosine_[k];
        const double sine = sine_[k];
        for (std::size_t c = 0; c < lanes; c += 2)
        {
            const double realA = v[c] + w[c];
            const double imaginaryA = v[c + 1] - w[c + 1];
            const double realB = v[c + 1] + w[c + 1];
            const double imaginaryB = w[c] - v[c];
            w[c] = fourier ? 0.5 * imaginaryA : sine * realA - cosine * imaginaryA;
            w[c + 1] = fourier ? 0.5 * imaginaryB : sine * realB - cosine * imaginaryB;
            // Last: in the middle the two rows are one.
            v[c] = fourier ? 0.5 * realA : cosine * realA + sine * imaginaryA;
            v[c + 1] = fourier ? 0.5 * realB : cosine * realB + sine * imaginaryB;
        }
    }
}

void PairedTransform::synthesise(double* rows, double* out) const
{
    const bool fourier = kind_ == Kind::fourier;
    const std::size_t end = fourier ? (count_ + 1) / 2 : count_ / 2 + 1;
    for (std::size_t k = 1; k < end; ++k)
    {
        double* v = rows + k * lanes;
        double* w = rows + (count_ - k) * lanes;
        const double cosine = cosine_[k];
        const double sine = sine_[k];
        for (std::size_t c = 0; c < lanes; c += 2)
        {
            const double realA = fourier ? v[c] : cosine * v[c] + sine * w[c];
            const double imaginaryA = fourier ? w[c] : sine * v[c] - cosine * w[c];
            const double realB = fourier ? v[c + 1] : cosine * v[c + 1] + sine * w[c + 1];
            const double imaginaryB = fourier ? w[c + 1] : sine * v[c + 1] - cosine * w[c + 1];
            w[c] = realA + imaginaryB;
            w[c + 1] = realB - imaginaryA;
            v[c] = realA - imaginaryB;
            v[c + 1] = realB + imaginaryA;
        }
    }
    executeRows(backward_, rows, out);
}

} // namespace isph
