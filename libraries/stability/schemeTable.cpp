#include "stability/schemeTable.hpp"

#include "continuation/Mirror.hpp"
#include "continuation/Polynomial.hpp"
#include "continuation/SmoothGram.hpp"
#include "flow/sceneSymbols.hpp"
#include "flow/stableNumbers.hpp"
#include "kernels/ExactKernel.hpp"
#include "kernels/Gaussian.hpp"
#include "kernels/QuinticSpline.hpp"
#include "stability/sceneModes.hpp"
#include "stability/StabilityTrial.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <numbers>

namespace isph
{

namespace
{

constexpr int quintic = -1;
constexpr int exactDerivative = 0;

/// \param order of a Gaussian, or one of the above
KernelSettings kernelOf(int order, double smoothingLength)
{
    KernelSettings settings;
    settings.smoothingLength = smoothingLength;
    if (order == quintic)
    {
        settings.kernel = std::make_unique<QuinticSpline>();
        settings.symbol = KernelSettings::Symbol::sampled;
    }
    else if (order == exactDerivative) { settings.kernel = std::make_unique<ExactKernel>(); }
    else { settings.kernel = std::make_unique<Gaussian>(order); }
    settings.supportRadius = settings.kernel->supportRadius();
    return settings;
}

std::string nameOf(int order)
{
    return order == quintic ? "quinticSpline" : order == exactDerivative ? "exact" : fmt::format("gaussian {}", order);
}

/// A square of side 1 with the same conditions at both ends of an axis.
Lattice squareOf(int xIntervals, bool xBounded, int yIntervals, bool yBounded)
{
    const auto axisOf = [](char name, int intervals, bool bounded)
    {
        return Axis{.name = name,
                    .extent = 1,
                    .count = intervals + (bounded ? 1 : 0),
                    .ends = bounded ? Axis::Ends::bounded : Axis::Ends::periodic};
    };
    const auto typeOf = [](bool bounded) { return bounded ? Patch::Type::patch : Patch::Type::periodic; };
    return Lattice({axisOf('x', xIntervals, xBounded), axisOf('y', yIntervals, yBounded), Axis{.name = 'z'}},
                   {{"sides", typeOf(xBounded), {"xMin", "xMax"}}, {"walls", typeOf(yBounded), {"yMin", "yMax"}}});
}

FaceCondition wall()
{
    FaceCondition face;
    face.velocity = VelocityCondition::value;
    face.pressure = PressureCondition::zeroGradient;
    return face;
}

FaceCondition outlet()
{
    FaceCondition face;
    face.velocity = VelocityCondition::outflow;
    face.pressure = PressureCondition::value;
    return face;
}

struct ContinuationChoice
{
    std::string name;
    std::function<std::unique_ptr<Continuation>(int points)> make;
};

std::vector<ContinuationChoice> continuationChoices()
{
    std::vector<ContinuationChoice> choices;
    for (const int degree : {3, 4, 5})
    {
        choices.push_back({fmt::format("smoothGram {}", degree),
                           [degree](int n) { return std::make_unique<SmoothGram>(automaticNewPoints(n), degree); }});
    }
    static constexpr int degree = 5;
    choices.push_back(
        {"polynomial 5, 8 points", [](int n) { return std::make_unique<Polynomial>((n - 1) / 4, degree, 8); }});
    choices.push_back({"polynomial 5, a quarter", [](int n) {
                           return std::make_unique<Polynomial>((n - 1) / 4, degree, Polynomial::automaticPoints(n - 1));
                       }});
    choices.push_back({"mirror", [](int n) { return std::make_unique<Mirror>(n - 2, false); }});
    return choices;
}

/// What a scene between walls has by default, with this kernel and continuation.
FlowSettings settingsBetweenWalls(const Lattice& lattice, int order, double h, const ContinuationChoice& continuation)
{
    FlowSettings settings;
    settings.kernel = kernelOf(order, h);
    settings.convection = ConvectionForm::advective;
    settings.laplacian = LaplacianForm::secondDerivative;
    settings.time = timeSchemes()[Word{"RK3", {}}];
    settings.integratingFactor = false;
    settings.exactMeanFlow = false;
    settings.dealiasing = Dealiasing::none;
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const Axis& axis = lattice.activeAxis(d);
        if (axis.periodic()) { continue; }
        settings.continuations[static_cast<std::size_t>(lattice.direction(d))] = continuation.make(axis.count);
    }
    return settings;
}

double largestReal(const LineSpectra::Spectrum& values)
{
    double largest = values.front().real();
    for (const auto& value : values) { largest = std::max(largest, value.real()); }
    return largest;
}

bool isReal(const LineSpectra::Spectrum& values)
{
    constexpr double rounding = 1e-9;
    double largest = 0;
    for (const auto& value : values) { largest = std::max(largest, std::abs(value)); }
    return std::ranges::all_of(values, [&](const auto& value) { return std::abs(value.imag()) <= rounding * largest; });
}

/// \param limits whose names are filled in
void measureLines(int order, double h, const ContinuationChoice& continuation, WallLimits& limits)
{
    constexpr int intervals = 64;
    constexpr double dx = 1.0 / intervals;
    const Lattice box = squareOf(intervals, true, intervals, true);
    FlowSettings settings = settingsBetweenWalls(box, order, h, continuation);
    std::array<std::array<FaceCondition, 2>, 3> faces;
    faces[0] = {wall(), outlet()};
    faces[1] = {wall(), wall()};
    const FlowBoundary boundary(box, std::move(faces));
    const LineSpectra spectra(box, settings, boundary);
    limits.flowGrowth = largestReal(*spectra.convection(1, 0, 1)) * dx;
    const auto diffusion = *spectra.diffusion(0, 1);
    limits.viscousGrowth = largestReal(diffusion) * dx * dx;
    limits.realModes = isReal(diffusion) && limits.viscousGrowth < 0;
    const Fluid fluid{.nu = 1};
    const StableNumbers numbers = stableNumbers(box, fluid, settings, boundsOf(box, fluid, settings));
    limits.courant = numbers.courant.value_or(0);
    limits.viscous = numbers.viscous.value_or(0);
}

void measureProjection(int order, double h, const ContinuationChoice& continuation, WallLimits& limits)
{
    const Lattice channel = squareOf(32, false, 64, true);
    FlowSettings settings = settingsBetweenWalls(channel, order, h, continuation);
    settings.convection = ConvectionForm::none;
    std::array<std::array<FaceCondition, 2>, 3> faces;
    faces[1] = {wall(), wall()};
    FlowBoundary boundary(channel, std::move(faces));
    limits.atRest = std::exp(growthOfProjection(channel, settings, boundary));
}

} // namespace

std::vector<PeriodicLimits> periodicLimits()
{
    const double diagonal = 1 / std::numbers::sqrt2;
    constexpr int points = 64;
    const Lattice square = squareOf(points, false, points, false);
    const double dx = square.activeAxis(0).spacing();
    const TimeScheme& rungeKutta = *timeSchemes()[Word{"RK3", {}}];
    const TimeScheme& euler = *timeSchemes()[Word{"firstOrderProjection", {}}];
    std::vector<PeriodicLimits> table;
    for (const int order : {quintic, 2, 4, 6, 8, 10, 12, 16, 20, exactDerivative})
    {
        const bool exact = order == exactDerivative;
        for (const double h : exact ? std::vector<double>{1.5} : std::vector<double>{1.3, 1.5, 2.0})
        {
            FlowSettings settings;
            settings.kernel = kernelOf(order, h);
            settings.integratingFactor = settings.exactMeanFlow = false;
            settings.dealiasing = Dealiasing::none;
            const auto carried = [&](double ux, double uy) {
                return largestStableStep(rungeKutta, periodicModes(square, {}, settings, {ux, uy, 0})) / dx;
            };
            const auto damped = periodicModes(square, {.nu = 1}, settings, {0, 0, 0});
            PeriodicLimits row;
            row.kernel = nameOf(order);
            if (!exact) { row.smoothingLength = h; }
            row.axis = carried(1, 0);
            row.diagonal = carried(diagonal, diagonal);
            row.viscous = largestStableStep(rungeKutta, damped) / (dx * dx);
            row.viscousFirstOrder = largestStableStep(euler, damped) / (dx * dx);
            table.push_back(std::move(row));
        }
    }
    return table;
}

std::vector<WallLimits> wallLimits()
{
    struct KernelChoice
    {
        int order;
        double h;
    };
    std::vector<WallLimits> table;
    for (const auto& [order, h] : {KernelChoice{exactDerivative, 1.5}, KernelChoice{20, 1.5}, KernelChoice{8, 1.5},
                                   KernelChoice{4, 1.3}, KernelChoice{4, 2}, KernelChoice{quintic, 1.5}})
    {
        for (const ContinuationChoice& continuation : continuationChoices())
        {
            WallLimits row;
            row.kernel = nameOf(order);
            if (order != exactDerivative) { row.smoothingLength = h; }
            row.continuation = continuation.name;
            measureLines(order, h, continuation, row);
            measureProjection(order, h, continuation, row);
            table.push_back(std::move(row));
        }
    }
    return table;
}

} // namespace isph
