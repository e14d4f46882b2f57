#include "operators/DerivativeSymbol.hpp"

#include <algorithm>
#include <cmath>

namespace isph
{

namespace
{

/// Calls visit(mode, s, k2) for every mode, s = sum (k_j h_j)^2/4.
template<class Visit>
void forEachMode(const Lattice& lattice, double smoothingLength, Visit visit)
{
    const ModeRows rows(lattice);
    const auto& k = rows.wavenumbers().k;
    std::array<double, 3> halfH{0, 0, 0};
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        halfH[static_cast<std::size_t>(d)] = 0.5 * smoothingLength * lattice.activeAxis(d).spacing();
    }
    for (std::size_t row = 0; row < rows.count(); ++row)
    {
        double sOfRow = 0;
        double k2OfRow = 0;
        for (int d = 1; d < lattice.dimensions(); ++d)
        {
            const double kd = rows.k(row, d);
            sOfRow += std::pow(kd * halfH[static_cast<std::size_t>(d)], 2);
            k2OfRow += kd * kd;
        }
        for (std::size_t i = 0; i < rows.length(); ++i)
        {
            visit(rows.offset(row) + i, std::pow(k[0][i] * halfH[0], 2) + sOfRow, k[0][i] * k[0][i] + k2OfRow);
        }
    }
}

} // namespace

AlignedVector<double> symbolOfWeights(const Lattice& lattice, FourierTransform& transform,
                                      const std::vector<std::array<int, 3>>& offsets,
                                      const std::vector<double>& weights, bool odd)
{
    RealField wrapped(1, lattice.points());
    for (std::size_t b = 0; b < offsets.size(); ++b)
    {
        std::size_t point = 0;
        for (int d = lattice.dimensions() - 1; d >= 0; --d)
        {
            const int n = lattice.activeAxis(d).count;
            const int index = ((offsets[b][static_cast<std::size_t>(d)] % n) + n) % n;
            point = point * static_cast<std::size_t>(n) + static_cast<std::size_t>(index);
        }
        wrapped[0][point] += weights[b];
    }
    SpectralField modes(1, transform.modes());
    transform.forward(wrapped, modes);
    AlignedVector<double> symbol(transform.modes());
    // The transform has exp(-ikx), a sum over neighbours exp(+ikx).
    std::ranges::transform(modes[0], symbol.begin(),
                           [odd](const std::complex<double>& c) { return odd ? -c.imag() : c.real(); });
    return symbol;
}

DerivativeSymbol::DerivativeSymbol(const Lattice& lattice, const KernelSettings& settings, const KernelSamples* samples)
    : rows_(lattice)
{
    if (settings.symbol == KernelSettings::Symbol::closed)
    {
        if (settings.exact()) { return; }
        smoothing_.resize(rows_.modes());
        forEachMode(lattice, settings.smoothingLength,
                    [this, &settings](std::size_t mode, double s, double)
                    { smoothing_[mode] = settings.kernel->symbol(s); });
        return;
    }

    FourierTransform transform(lattice, 1);
    sampled_ = RealField(lattice.dimensions(), rows_.modes());
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const auto symbol =
            symbolOfWeights(lattice, transform, samples->offsets, samples->gradient[static_cast<std::size_t>(d)], true);
        std::ranges::copy(symbol, sampled_[d].begin());
    }
    // Where a wavenumber is 0 or Nyquist the sum of sines is zero; the transform leaves round-off there.
    const auto& k = rows_.wavenumbers().derivative;
    for (std::size_t row = 0; row < rows_.count(); ++row)
    {
        const auto first = static_cast<std::ptrdiff_t>(rows_.offset(row));
        for (std::size_t i = 0; i < rows_.length(); ++i)
        {
            if (k[0][i] == 0) { sampled_[0][rows_.offset(row) + i] = 0; }
        }
        for (int d = 1; d < lattice.dimensions(); ++d)
        {
            if (rows_.derivative(row, d) != 0) { continue; }
            std::fill_n(sampled_[d].begin() + first, rows_.length(), 0.0);
        }
    }
}

void DerivativeSymbol::wavevectorRow(std::size_t row, std::size_t begin, std::size_t end,
                                     const std::array<double*, 3>& out) const
{
    const double* k0 = rows_.wavenumbers().derivative[0].data();
    std::copy(k0 + begin, k0 + end, out[0]);
    for (int d = 1; d < rows_.dimensions(); ++d)
    {
        std::fill_n(out[static_cast<std::size_t>(d)], end - begin, rows_.derivative(row, d));
    }
}

void DerivativeSymbol::row(std::size_t row, std::size_t begin, std::size_t end, const std::array<double*, 3>& out) const
{
    const std::size_t first = rows_.offset(row) + begin;
    const std::size_t length = end - begin;
    if (!parallel())
    {
        for (int d = 0; d < rows_.dimensions(); ++d)
        {
            std::copy_n(sampled_[d].data() + first, length, out[static_cast<std::size_t>(d)]);
        }
        return;
    }
    wavevectorRow(row, begin, end, out);
    if (smoothing_.empty()) { return; }
    const double* q = smoothing_.data() + first;
    for (int d = 0; d < rows_.dimensions(); ++d)
    {
        double* symbol = out[static_cast<std::size_t>(d)];
        for (std::size_t i = 0; i < length; ++i) { symbol[i] *= q[i]; }
    }
}

AlignedVector<double> laplacianSymbol(const Lattice& lattice, const KernelSettings& settings, LaplacianForm form,
                                      const KernelSamples* samples)
{
    if (settings.symbol == KernelSettings::Symbol::sampled && form != LaplacianForm::exact)
    {
        FourierTransform transform(lattice, 1);
        auto symbol = symbolOfWeights(lattice, transform, samples->offsets, samples->laplacian, false);
        const double atRest = symbol[0]; // sum of the weights, zero by construction: its round-off, then
        for (double& value : symbol) { value = atRest - value; }
        return symbol;
    }
    AlignedVector<double> symbol(ModeRows(lattice).modes());
    forEachMode(lattice, settings.smoothingLength,
                [&](std::size_t mode, double s, double k2)
                {
                    const Kernel& kernel = *settings.kernel;
                    symbol[mode] = form == LaplacianForm::exact    ? k2
                                   : form == LaplacianForm::morris ? k2 * kernel.morrisSymbol(s)
                                                                   : k2 * kernel.symbol(s);
                });
    return symbol;
}

OperatorBounds operatorBounds(const DerivativeSymbol& derivative, std::span<const double> laplacian,
                              const RetainedModes& retained)
{
    const ModeRows& rows = derivative.rows();
    OperatorBounds bounds;
    std::array<std::vector<double>, 3> d;
    for (auto& values : d) { values.assign(rows.length(), 0.0); }
    const std::array<double*, 3> out{d[0].data(), d[1].data(), d[2].data()};
    for (std::size_t row = 0; row < rows.count(); ++row)
    {
        const bool kept = retained.index(1, rows.index(row, 1)) && retained.index(2, rows.index(row, 2));
        if (!kept) { continue; }
        derivative.row(row, 0, rows.length(), out);
        for (std::size_t i = 0; i < retained.length(); ++i)
        {
            if (rows.checkerboard(row, i)) { continue; } // flows carry none
            double magnitude2 = 0;
            for (std::size_t j = 0; j < 3; ++j)
            {
                bounds.derivative[j] = std::max(bounds.derivative[j], std::abs(d[j][i]));
                magnitude2 += d[j][i] * d[j][i];
            }
            bounds.derivativeMagnitude = std::max(bounds.derivativeMagnitude, std::sqrt(magnitude2));
            if (laplacian.empty()) { continue; }
            const double lambda = laplacian[rows.offset(row) + i];
            bounds.laplacian = std::max(bounds.laplacian, lambda);
            bounds.leastLaplacian = std::min(bounds.leastLaplacian, lambda);
            if (lambda > 0)
            {
                bounds.derivativeOverLaplacian = std::max(bounds.derivativeOverLaplacian, magnitude2 / lambda);
            }
        }
    }
    return bounds;
}

} // namespace isph
