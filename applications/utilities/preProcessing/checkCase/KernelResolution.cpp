#include "KernelResolution.hpp"

#include "operators/KernelSamples.hpp"
#include "operators/lineSymbolOf.hpp"

#include <cmath>
#include <functional>
#include <numbers>

namespace isph
{

namespace
{

/// What an operator makes of a wave, over what the exact one does; theta = k dx in (0, pi] for waves on the lattice.
using Response = std::function<double(double theta)>;

/// The first wave of which half is left, in units of the Nyquist wavenumber.
std::optional<double> halfHeight(const Response& gradient, double largest)
{
    constexpr double step = std::numbers::pi / 256;
    const auto steps = static_cast<int>(largest / step);
    for (int n = 1; n <= steps; ++n)
    {
        if (gradient(n * step) > 0.5) { continue; }
        double above = (n - 1) * step;
        double below = n * step;
        for (int i = 0; i < 40; ++i)
        {
            const double middle = 0.5 * (above + below);
            (gradient(middle) > 0.5 ? above : below) = middle;
        }
        return below / std::numbers::pi;
    }
    return std::nullopt;
}

struct Responses
{
    Response gradient;
    Response laplacian; ///< empty: no viscous term
};

Responses closedResponses(const KernelSettings& settings, const std::optional<LaplacianForm>& form)
{
    const auto s = [h = settings.smoothingLength](double theta) { return 0.25 * h * h * theta * theta; };
    const Kernel& kernel = *settings.kernel;
    Responses responses{[&kernel, s](double theta) { return kernel.symbol(s(theta)); }, {}};
    if (form == LaplacianForm::morris)
    {
        responses.laplacian = [&kernel, s](double theta) { return kernel.morrisSymbol(s(theta)); };
    }
    else if (form == LaplacianForm::secondDerivative) { responses.laplacian = responses.gradient; }
    else if (form)
    {
        responses.laplacian = [](double) { return 1.0; };
    }
    return responses;
}

/// The samples must outlive the responses.
Responses sampledResponses(const KernelSamples& samples, double dx, const std::optional<LaplacianForm>& form)
{
    Responses responses;
    responses.gradient = [&samples, dx](double theta)
    {
        double sum = 0;
        for (std::size_t b = 0; b < samples.offsets.size(); ++b)
        {
            sum += samples.gradient[0][b] * std::sin(theta * samples.offsets[b][0]);
        }
        return sum * dx / theta;
    };
    if (form == LaplacianForm::exact)
    {
        responses.laplacian = [](double) { return 1.0; };
    }
    else if (form)
    {
        responses.laplacian = [&samples, dx](double theta)
        {
            double sum = 0;
            for (std::size_t b = 0; b < samples.offsets.size(); ++b)
            {
                const double half = std::sin(0.5 * theta * samples.offsets[b][0]);
                sum -= samples.laplacian[b] * 2 * half * half;
            }
            return -sum * dx * dx / (theta * theta);
        };
    }
    return responses;
}

/// Of a kernel on lines, the modes of a very long one standing for all waves. The symbol must outlive the responses.
Responses lineResponses(const LineSymbol& symbol, double dx, bool viscous)
{
    const auto at = [&symbol](double theta)
    {
        const auto last = static_cast<double>(symbol.first.size() - 1);
        return static_cast<std::size_t>(std::lround(theta / std::numbers::pi * last));
    };
    Responses responses{[&symbol, at, dx](double theta) { return symbol.first[at(theta)] * dx / theta; }, {}};
    if (viscous)
    {
        responses.laplacian = [&symbol, at, dx](double theta)
        { return symbol.second[at(theta)] * dx * dx / (theta * theta); };
    }
    return responses;
}

} // namespace

KernelResolution kernelResolution(const Lattice& lattice, const KernelSettings& settings,
                                  const std::optional<LaplacianForm>& laplacian)
{
    KernelResolution resolution;
    for (int d = 0; d < lattice.dimensions() && !settings.exact(); ++d)
    {
        resolution.h[static_cast<std::size_t>(d)] = settings.smoothingLength * lattice.activeAxis(d).spacing();
    }

    std::optional<KernelSamples> samples;
    std::optional<LineSymbol> line;
    Responses responses;
    double largest = 16 * std::numbers::pi; // closed symbols may have their cut-off beyond the lattice's last wave
    if (settings.symbol == KernelSettings::Symbol::sampled && !lattice.periodic())
    {
        constexpr int longLine = 1 << 16;
        const double dx = lattice.activeAxis(0).spacing();
        line = lineSymbolOf(settings, laplacian.value_or(LaplacianForm::exact), longLine, dx);
        responses = lineResponses(*line, dx, laplacian.has_value());
        largest = std::numbers::pi;
        resolution.supportPoints = settings.supportRadius * settings.smoothingLength;
        resolution.neighbours = 2 * static_cast<std::size_t>(*resolution.supportPoints + 1e-9) + 1;
        resolution.defect = std::abs(responses.gradient(2 * std::numbers::pi / longLine) - 1);
    }
    else if (settings.symbol == KernelSettings::Symbol::sampled)
    {
        samples.emplace(lattice, settings, laplacian.value_or(LaplacianForm::exact));
        const double dx = lattice.activeAxis(0).spacing();
        responses = sampledResponses(*samples, dx, laplacian);
        largest = std::numbers::pi;
        resolution.supportPoints = settings.supportRadius * settings.smoothingLength;
        resolution.neighbours = samples->offsets.size();
        double moment = 0;
        for (std::size_t b = 0; b < samples->offsets.size(); ++b)
        {
            moment += samples->gradient[0][b] * samples->offsets[b][0] * dx;
        }
        resolution.defect = std::abs(moment - 1);
    }
    else { responses = closedResponses(settings, laplacian); }

    if (!settings.exact()) { resolution.cutOff = halfHeight(responses.gradient, largest); }
    for (const int points : {4, 8, 16})
    {
        const double theta = 2 * std::numbers::pi / points;
        KernelResolution::Wave wave{points, std::abs(responses.gradient(theta) - 1), std::nullopt};
        if (responses.laplacian) { wave.laplacian = std::abs(responses.laplacian(theta) - 1); }
        resolution.waves.push_back(wave);
    }
    return resolution;
}

} // namespace isph
