#include "stability/sceneModes.hpp"

#include "flow/sceneSymbols.hpp"
#include "spectral/SpectralFilter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isph
{

namespace
{

std::size_t at(int i) { return static_cast<std::size_t>(i); }

} // namespace

std::vector<ModeRate> periodicModes(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings,
                                    const std::array<double, 3>& velocity)
{
    const DerivativeSymbol derivative = derivativeOf(lattice, settings.kernel);
    AlignedVector<double> laplacian;
    if (fluid.nu > 0) { laplacian = laplacianOf(lattice, settings.kernel, settings.laplacian); }
    const ModeRows& rows = derivative.rows();
    const RetainedModes retained(lattice, settings.dealiasing);
    const bool filters = settings.filter.type != FilterSettings::Type::none;
    const auto factors = filters ? filterFactors(lattice, settings.filter) : std::array<std::vector<double>, 3>{};

    std::vector<ModeRate> modes;
    std::array<std::vector<double>, 3> d;
    for (auto& values : d) { values.assign(rows.length(), 0.0); }
    for (std::size_t row = 0; row < rows.count(); ++row)
    {
        if (!retained.index(1, rows.index(row, 1)) || !retained.index(2, rows.index(row, 2))) { continue; }
        const std::size_t length = std::min(retained.length(), rows.length());
        derivative.row(row, 0, rows.length(), {d[0].data(), d[1].data(), d[2].data()});
        double ofRow = 1;
        for (int axis = 1; filters && axis < lattice.dimensions(); ++axis)
        {
            ofRow *= factors[at(axis)][rows.index(row, axis)];
        }
        for (std::size_t i = 0; i < length; ++i)
        {
            if (rows.checkerboard(row, i)) { continue; }
            double carried = 0;
            for (int axis = 0; axis < lattice.dimensions(); ++axis) { carried += velocity[at(axis)] * d[at(axis)][i]; }
            const double damped = laplacian.empty() ? 0 : fluid.nu * laplacian[rows.offset(row) + i];
            const double filter = filters ? ofRow * factors[0][i] : 1;
            modes.push_back({{settings.integratingFactor ? 0 : -damped, -carried},
                             settings.integratingFactor ? damped : 0,
                             filter});
        }
    }
    return modes;
}

std::vector<ModeRate> carriedModes(const Lattice& lattice, const LineSpectra& spectra, int d, double velocity)
{
    std::vector<ModeRate> modes;
    for (int c = 0; c < lattice.dimensions(); ++c)
    {
        const auto spectrum = spectra.convection(c, d, velocity < 0 ? -1 : 1);
        if (!spectrum) { return {}; }
        for (const auto& value : *spectrum) { modes.push_back({.explicitRate = std::abs(velocity) * value}); }
    }
    return modes;
}

std::vector<ModeRate> dampedModes(const Lattice& lattice, const LineSpectra& spectra, double nu)
{
    constexpr int directions = 64;
    std::vector<ModeRate> modes;
    for (int c = 0; c < lattice.dimensions(); ++c)
    {
        std::vector<LineSpectra::Spectrum> ofAxes;
        for (int d = 0; d < lattice.dimensions(); ++d)
        {
            auto spectrum = spectra.diffusion(c, d);
            if (!spectrum) { return {}; }
            ofAxes.push_back(std::move(*spectrum));
        }
        for (int i = 0; i < directions; ++i)
        {
            const double angle = 2 * std::numbers::pi * i / directions;
            const auto reach = [angle](const std::complex<double>& value)
            { return value.real() * std::cos(angle) + value.imag() * std::sin(angle); };
            std::complex<double> sum = 0;
            for (const auto& spectrum : ofAxes)
            {
                sum += *std::ranges::max_element(spectrum,
                                                 [&](const auto& a, const auto& b) { return reach(a) < reach(b); });
            }
            modes.push_back({.explicitRate = nu * sum});
        }
    }
    return modes;
}

} // namespace isph
