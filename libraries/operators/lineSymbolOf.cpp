#include "operators/lineSymbolOf.hpp"

#include <cmath>
#include <numbers>

namespace isph
{

namespace
{

/// Minus the symbol of sum_b -2 f(q_b)/h^2 (f_b - f_0) over the neighbours of a line, theta = k dx.
double sampledMorris(const KernelSettings& settings, double theta, double spacing)
{
    const double h = settings.smoothingLength * spacing;
    const int reach = static_cast<int>(std::floor(settings.supportRadius * settings.smoothingLength + 1e-9));
    double sum = 0;
    double moment = 0;
    for (int b = 1; b <= reach; ++b)
    {
        const double q = b / settings.smoothingLength;
        const double weight = -2 * settings.kernel->f(q, 1) / (settings.smoothingLength * h * h);
        sum += 2 * weight * (1 - std::cos(theta * b));
        moment += weight * std::pow(b * spacing, 2);
    }
    return settings.renormalise ? sum / moment : sum;
}

} // namespace

LineSymbol lineSymbolOf(const KernelSettings& kernel, LaplacianForm form, int length, double spacing)
{
    LineSymbol symbol = lineSymbol(kernel, length, spacing);
    if (form == LaplacianForm::secondDerivative) { return symbol; }
    const bool sampled = kernel.symbol == KernelSettings::Symbol::sampled;
    for (std::size_t m = 0; m < symbol.second.size(); ++m)
    {
        const double theta = 2 * std::numbers::pi * static_cast<double>(m) / length;
        const double k = theta / spacing;
        if (form == LaplacianForm::exact) { symbol.second[m] = k * k; }
        else if (sampled) { symbol.second[m] = sampledMorris(kernel, theta, spacing); }
        else
        {
            symbol.second[m] =
                k * k * kernel.kernel->morrisSymbol(0.25 * std::pow(k * kernel.smoothingLength * spacing, 2));
        }
    }
    return symbol;
}

} // namespace isph
