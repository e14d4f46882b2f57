#include "stability/LineSpectra.hpp"

#include "continuation/ContinuedDerivative.hpp"
#include "continuation/matrixSpectrum.hpp"
#include "flow/faceConditions.hpp"
#include "operators/lineSymbolOf.hpp"

namespace isph
{

namespace
{

std::size_t at(int i) { return static_cast<std::size_t>(i); }

LineSymbol symbolAlong(const FlowSettings& settings, const Axis& axis, int length)
{
    return lineSymbolOf(settings.kernel, settings.laplacian, length, axis.spacing());
}

/// Rows and columns first ... last of a matrix of n rows.
std::vector<double> innerMatrix(const std::vector<double>& matrix, std::size_t n, std::size_t first, std::size_t last)
{
    std::vector<double> inner;
    inner.reserve((last - first + 1) * (last - first + 1));
    for (std::size_t row = first; row <= last; ++row)
    {
        for (std::size_t column = first; column <= last; ++column) { inner.push_back(matrix[row * n + column]); }
    }
    return inner;
}

} // namespace

std::optional<LineSpectra::Spectrum> LineSpectra::convection(int component, int d, int sign) const
{
    const Axis& axis = lattice_.activeAxis(d);
    if (!axis.periodic()) { return ofBoundedLine(component, d, sign); }
    Spectrum spectrum;
    for (const double k : symbolAlong(settings_, axis, axis.count).first)
    {
        spectrum.emplace_back(0, k);
        spectrum.emplace_back(0, -k);
    }
    return spectrum;
}

std::optional<LineSpectra::Spectrum> LineSpectra::diffusion(int component, int d) const
{
    const Axis& axis = lattice_.activeAxis(d);
    if (!axis.periodic()) { return ofBoundedLine(component, d, 0); }
    Spectrum spectrum;
    for (const double k2 : symbolAlong(settings_, axis, axis.count).second) { spectrum.emplace_back(-k2, 0); }
    return spectrum;
}

/// \param sign 0: the second derivative
std::optional<LineSpectra::Spectrum> LineSpectra::ofBoundedLine(int component, int d, int sign) const
{
    const int direction = lattice_.direction(d);
    const Axis& axis = lattice_.axis(direction);
    if (axis.count > longest) { return std::nullopt; }
    const bool normal = component == d;
    const FaceCondition& low = boundary_.face(direction, Side::low);
    const FaceCondition& high = boundary_.face(direction, Side::high);
    const LineContinuation line(*settings_.continuations[at(direction)], axis.count,
                                velocityEnd(low, normal, axis.staggered), velocityEnd(high, normal, axis.staggered));
    ContinuedDerivative derivative(ContinuedTransform({1, at(axis.count), 1}, line),
                                   symbolAlong(settings_, axis, line.extendedPoints()));

    const std::size_t n = at(axis.count);
    std::vector<double> matrix(n * n);
    std::vector<double> unit(n);
    std::vector<double> image(n);
    for (std::size_t column = 0; column < n; ++column)
    {
        unit[column] = 1;
        if (sign == 0) { derivative(unit, {}, image); }
        else { derivative(unit, image, {}); }
        unit[column] = 0;
        for (std::size_t row = 0; row < n; ++row) { matrix[row * n + column] = (sign == 0 ? 1 : -sign) * image[row]; }
    }
    const auto leaves = [&](const FaceCondition& face) { return face.velocity == VelocityCondition::outflow; };
    const auto replaceOutlet = [&](std::size_t row, bool atHigh)
    {
        std::fill_n(matrix.begin() + static_cast<std::ptrdiff_t>(row * n), n, 0.0);
        if (sign == 0 || (sign > 0) != atHigh) { return; }
        for (std::size_t k = 0; k < outletDifference.size(); ++k)
        {
            matrix[row * n + (atHigh ? row - k : row + k)] = -outletDifference[k] / axis.spacing();
        }
    };
    if (!axis.staggered && leaves(low)) { replaceOutlet(0, false); }
    if (!axis.staggered && leaves(high)) { replaceOutlet(n - 1, true); }
    const std::size_t first = !axis.staggered && holdsValue(low, normal) ? 1 : 0;
    const std::size_t last = n - (!axis.staggered && holdsValue(high, normal) ? 2 : 1);
    return eigenvaluesOf(innerMatrix(matrix, n, first, last), last - first + 1);
}

} // namespace isph
