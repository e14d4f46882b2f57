#include "continuation/LineSymbol.hpp"

#include "core/Error.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace isph
{

namespace
{

/// Weights of the neighbours at distance b = 1 ... of a line: the derivative is sum_b slope[b] (f_b - f_-b), the second
/// one sum_b curvature[b] (f_b + f_-b - 2 f_0). The lattice form of Fourtakas, Rogers & Nasar 2021 in one dimension.
struct Samples
{
    Samples(const KernelSettings& settings, double spacing)
    {
        const double h = settings.smoothingLength * spacing;
        const int reach = static_cast<int>(std::floor(settings.supportRadius * settings.smoothingLength + 1e-9));
        double slopeMoment = 0;
        double curvatureMoment = 0;
        for (int b = 1; b <= reach; ++b)
        {
            const double x = b * spacing;
            const double q = x / h;
            const double f = settings.kernel->f(q, 1) / settings.smoothingLength;
            const double g = settings.kernel->g(q, 1) / settings.smoothingLength;
            slope.push_back(-x * f / (h * h));
            curvature.push_back((f + q * q * g) / (h * h));
            slopeMoment += 2 * x * slope.back();
            curvatureMoment += x * x * curvature.back();
        }
        if (!settings.renormalise) { return; }
        for (double& weight : slope) { weight /= slopeMoment; }
        for (double& weight : curvature) { weight /= curvatureMoment; }
    }

    std::vector<double> slope;
    std::vector<double> curvature;
};

} // namespace

LineSymbol lineSymbol(const KernelSettings& settings, int length, double spacing)
{
    LineSymbol symbol;
    const bool sampled = settings.symbol == KernelSettings::Symbol::sampled;
    const Samples samples = sampled ? Samples(settings, spacing) : Samples({}, spacing);
    if (2 * samples.slope.size() >= static_cast<std::size_t>(length))
    {
        throw Error(Fault::input,
                    "the kernel reaches " + std::to_string(samples.slope.size()) +
                        " points to each side, too far for a line of " + std::to_string(length),
                    "take more points, or a smaller supportRadius");
    }
    const double h = settings.smoothingLength * spacing;
    for (int m = 0; m <= length / 2; ++m)
    {
        const double phase = 2 * std::numbers::pi * m / length; // k dx
        const double k = phase / spacing;
        double first = k;
        double second = k * k;
        if (sampled)
        {
            first = 0;
            second = 0;
            for (std::size_t b = 1; b <= samples.slope.size(); ++b)
            {
                first += 2 * samples.slope[b - 1] * std::sin(phase * static_cast<double>(b));
                second += 2 * samples.curvature[b - 1] * (1 - std::cos(phase * static_cast<double>(b)));
            }
        }
        else
        {
            const double smoothing = settings.kernel->symbol(0.25 * k * k * h * h);
            first *= smoothing;
            second *= smoothing;
        }
        symbol.first.push_back(m == 0 || 2 * m == length ? 0 : first);
        symbol.second.push_back(second);
    }
    return symbol;
}

} // namespace isph
