#pragma once

#include "continuation/ContinuedDerivative.hpp"
#include "kernels/ExactKernel.hpp"
#include "kernels/Gaussian.hpp"

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace isph
{

inline KernelSettings exactKernel()
{
    KernelSettings settings;
    settings.kernel = std::make_unique<ExactKernel>();
    return settings;
}

inline KernelSettings gaussianKernel(int order, double smoothingLength = 1.3)
{
    KernelSettings settings;
    settings.kernel = std::make_unique<Gaussian>(order);
    settings.smoothingLength = smoothingLength;
    return settings;
}

/// Outward derivatives at both walls, for Neumann conditions.
struct WallSlopes
{
    double lower = 0;
    double upper = 0;
};

/// Derivatives on one line over [0, 1] with both walls among its points.
class BoundedLine
{
public:
    BoundedLine(int intervals, const Continuation& continuation, const KernelSettings& kernel,
                EndCondition condition = EndCondition::dirichlet)
        : BoundedLine(LineContinuation(continuation, intervals + 1, condition, condition), 1.0 / intervals, kernel)
    {
    }

    int points() const { return points_; }
    double x(int i) const { return i * spacing_; }

    struct Derivatives
    {
        std::vector<double> first;
        std::vector<double> second;
    };

    Derivatives of(std::span<const double> values, const WallSlopes& slopes = {})
    {
        Derivatives result{std::vector<double>(values.size()), std::vector<double>(values.size())};
        derivative_(values, result.first, result.second, {{&slopes.lower, 1}, {&slopes.upper, 1}});
        return result;
    }

    /// Root mean square errors of both derivatives.
    struct Errors
    {
        double first = 0;
        double second = 0;
    };

    using Function = std::function<double(double)>;
    Errors errors(const Function& f, const Function& df, const Function& d2f, const WallSlopes& slopes = {})
    {
        std::vector<double> values;
        for (int i = 0; i < points_; ++i) { values.push_back(f(x(i))); }
        const Derivatives found = of(values, slopes);
        Errors errors;
        for (int i = 0; i < points_; ++i)
        {
            const auto at = static_cast<std::size_t>(i);
            errors.first += std::pow(found.first[at] - df(x(i)), 2) / points_;
            errors.second += std::pow(found.second[at] - d2f(x(i)), 2) / points_;
        }
        return {std::sqrt(errors.first), std::sqrt(errors.second)};
    }

private:
    BoundedLine(const LineContinuation& continuation, double spacing, const KernelSettings& kernel)
        : points_(continuation.points()),
          spacing_(spacing),
          derivative_(ContinuedTransform({1, static_cast<std::size_t>(points_), 1}, continuation, spacing),
                      lineSymbol(kernel, continuation.extendedPoints(), spacing))
    {
    }

    int points_;
    double spacing_;
    ContinuedDerivative derivative_;
};

/// exp(y) sin 5y + 0.5 y^3, the function of Lin, Fourtakas & Rogers 2026, figure 6, with its derivatives.
inline double continuedExample(double y) { return std::exp(y) * std::sin(5 * y) + 0.5 * y * y * y; }
inline double continuedExampleFirst(double y)
{
    return std::exp(y) * (std::sin(5 * y) + 5 * std::cos(5 * y)) + 1.5 * y * y;
}
inline double continuedExampleSecond(double y)
{
    return std::exp(y) * (-24 * std::sin(5 * y) + 10 * std::cos(5 * y)) + 3 * y;
}

} // namespace isph
