#include "operators/continuedBounds.hpp"

#include "continuation/ContinuedDerivative.hpp"
#include "operators/lineSymbolOf.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace isph
{

namespace
{

/// The largest and least values over the modes of a line.
struct LineBounds
{
    double first = 0;
    double second = 0;
    double leastSecond = 0;
    double firstOverSecond = 0; ///< largest first^2/second
};

LineBounds boundsOfSymbol(const LineSymbol& symbol)
{
    LineBounds bounds;
    for (std::size_t m = 1; m < symbol.second.size(); ++m)
    {
        const double first = std::abs(symbol.first[m]);
        const double second = symbol.second[m];
        bounds.first = std::max(bounds.first, first);
        bounds.second = std::max(bounds.second, second);
        bounds.leastSecond = std::min(bounds.leastSecond, second);
        if (second > 0) { bounds.firstOverSecond = std::max(bounds.firstOverSecond, first * first / second); }
    }
    return bounds;
}

/// The derivatives of one line whose ends are held at zero.
class HeldLine
{
public:
    HeldLine(const Axis& axis, const Continuation& continuation, const LineSymbol& symbol)
        : axis_(axis),
          derivative_(ContinuedTransform({1, static_cast<std::size_t>(axis.count), 1},
                                         LineContinuation(continuation, axis.count), axis.spacing()),
                      symbol)
    {
    }

    double first()
    {
        return radius([this](std::span<const double> in, std::span<double> out) { derivative_(in, out, {}); });
    }
    double second()
    {
        return radius([this](std::span<const double> in, std::span<double> out) { derivative_(in, {}, out); });
    }

    /// How far the second derivative's eigenvalues reach to the positive side.
    /// \param largest their magnitude
    double growth(double largest)
    {
        const auto shifted = [this, largest](std::span<const double> in, std::span<double> out)
        {
            derivative_(in, {}, out);
            for (std::size_t i = 0; i < in.size(); ++i) { out[i] += largest * in[i]; }
        };
        return radius(shifted) - largest;
    }

private:
    /// Spectral radius by the power method. What the largest symbol does not bound are single modes at the walls, which
    /// stand out and converge soon.
    template<class Apply>
    double radius(const Apply& apply)
    {
        constexpr int iterations = 120;
        constexpr int measured = 20; ///< the last ones: pairs of complex eigenvalues come to a mean growth
        std::vector<double> line(static_cast<std::size_t>(axis_.count));
        std::vector<double> image(line.size());
        std::minstd_rand random(1);
        for (double& value : line) { value = static_cast<double>(random()) / std::minstd_rand::max() - 0.5; }
        double growth = 0; // sum of logarithms
        for (int i = 0; i < iterations; ++i)
        {
            if (!axis_.staggered) { line.front() = line.back() = 0; }
            double norm2 = 0;
            for (const double value : line) { norm2 += value * value; }
            if (norm2 == 0) { return 0; }
            if (i > iterations - measured) { growth += 0.5 * std::log(norm2); }
            for (double& value : line) { value /= std::sqrt(norm2); }
            apply(line, image);
            std::swap(line, image);
        }
        return std::exp(growth / (measured - 1));
    }

    Axis axis_;
    ContinuedDerivative derivative_;
};

LineBounds boundsOf(const Axis& axis, const Continuation* continuation, const KernelSettings& kernel,
                    LaplacianForm form)
{
    const int length = axis.count + (continuation != nullptr ? continuation->newPoints() : 0);
    const LineSymbol symbol = lineSymbolOf(kernel, form, length, axis.spacing());
    LineBounds bounds = boundsOfSymbol(symbol);
    if (continuation == nullptr) { return bounds; }
    HeldLine line(axis, *continuation, symbol);
    bounds.first = std::max(bounds.first, line.first());
    bounds.second = std::max(bounds.second, line.second());
    // Below a hundredth it is the power method that has not come to its end.
    const double growth = line.growth(bounds.second);
    if (growth > 0.01 * bounds.second) { bounds.leastSecond = std::min(bounds.leastSecond, -growth); }
    return bounds;
}

} // namespace

OperatorBounds continuedBounds(const Lattice& lattice, const Continuations& continuations, const KernelSettings& kernel,
                               LaplacianForm form)
{
    OperatorBounds bounds;
    double magnitude2 = 0;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const Continuation* continuation = continuations[static_cast<std::size_t>(lattice.direction(d))].get();
        const LineBounds line = boundsOf(lattice.activeAxis(d), continuation, kernel, form);
        bounds.derivative[static_cast<std::size_t>(d)] = line.first;
        magnitude2 += line.first * line.first;
        bounds.laplacian += line.second;
        bounds.leastLaplacian += line.leastSecond;
        // Of all axes together the ratio is largest along one of them.
        bounds.derivativeOverLaplacian = std::max(bounds.derivativeOverLaplacian, line.firstOverSecond);
    }
    bounds.derivativeMagnitude = std::sqrt(magnitude2);
    return bounds;
}

} // namespace isph
