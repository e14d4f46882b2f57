#include "flow/describeScene.hpp"

#include "flow/readFlowSettings.hpp"
#include "lattice/fastCounts.hpp"
#include "lattice/memoryEstimate.hpp"
#include "neighbours/LatticeStencil.hpp"
#include "poisson/MorrisSystem.hpp"

#include <fmt/format.h>

namespace isph
{

namespace
{

std::string describeKernel(const KernelSettings& kernel)
{
    if (kernel.exact()) { return "exact"; }
    const bool sampled = kernel.symbol == KernelSettings::Symbol::sampled;
    const std::string type =
        kernel.kernel->closed() ? fmt::format("gaussian, order {}", kernel.kernel->order()) : "quinticSpline";
    return fmt::format("{}, h/dx {}, {}{}", type, kernel.smoothingLength,
                       sampled ? fmt::format("sampled, support {}h", kernel.supportRadius) : "closed",
                       kernel.renormalise && sampled ? ", renormalised" : "");
}

std::string describeFilter(const FilterSettings& filter)
{
    switch (filter.type)
    {
    case FilterSettings::Type::exponential:
        return fmt::format("exponential, strength {}, order {}", filter.strength, filter.order);
    case FilterSettings::Type::cutoff:
        return fmt::format("cutoff, fraction {}", filter.fraction);
    case FilterSettings::Type::none:
        break;
    }
    return "none";
}

/// "along y: smoothGram, degree 4, 31 new points make a period of 96, fast".
std::string describeContinuation(const Axis& axis, const Continuation& continuation, const FlowSettings& settings)
{
    const int period = axis.count + continuation.newPoints();
    return fmt::format("continuation along {}: {}, {} points at each end, {} new points make a period of {}, {}",
                       axis.name, settings.continuation, continuation.points(), continuation.newPoints(), period,
                       isFastCount(period) ? "fast" : "slow");
}

/// What a kernel whose symbol is closed has to become for a matrix.
std::string sampledFor(const KernelSettings& kernel)
{
    return kernel.symbol == KernelSettings::Symbol::closed
               ? fmt::format(", the kernel sampled to {}h", kernel.supportRadius)
               : std::string();
}

/// "pressure: BiCGStab, jacobi, tolerance 1e-10, at most 1000 iterations; 197 neighbours a point, matrix of 60.5 MB".
std::string describeIteration(const Lattice& lattice, const FlowSettings& settings)
{
    const IterationSettings& iteration = *settings.iteration;
    const KernelSettings& kernel = settings.kernel;
    const std::size_t neighbours = latticeStencil(lattice, kernel.smoothingLength, kernel.supportRadius).size();
    return fmt::format("pressure: {}, preconditioner {}, tolerance {}, at most {} iterations, {} neighbours a point{}, "
                       "matrix of {}",
                       pressureSolvers().nameOf(iteration.solver), preconditioners().nameOf(iteration.preconditioner),
                       iteration.krylov.tolerance, iteration.krylov.maxIterations, neighbours, sampledFor(kernel),
                       memoryText(morrisSystemBytes(lattice, neighbours)));
}

std::string_view solverName(const FlowSettings& settings)
{
    const PressureSolver transforms = settings.directPressure ? PressureSolver::direct : PressureSolver::fft;
    return pressureSolvers().nameOf(settings.iteration ? settings.iteration->solver : transforms);
}

/// Transforms of all lines along one axis, one component of the velocity, a substep.
int lineTransforms(int dimensions, bool convects, bool explicitViscosity, bool pressureByTransforms)
{
    const int derivatives = (convects ? 1 : 0) + (explicitViscosity ? 1 : 0);
    const int momentum = derivatives > 0 ? dimensions * dimensions * (1 + derivatives) : 0;
    constexpr int thereAndBack = 2; // divergence, pressure, gradient
    return momentum + thereAndBack * dimensions * (pressureByTransforms ? 3 : 2);
}

/// Transforms of the whole extended box; the pressure's count as two of them.
int extendedTransforms(int dimensions, bool convects, bool explicitViscosity, bool pressureByTransforms)
{
    const int derivatives = (convects ? 1 : 0) + (explicitViscosity ? 1 : 0);
    const int momentum = derivatives > 0 ? dimensions * (1 + dimensions * derivatives) : 0;
    const int gradient = 1 + dimensions;
    return momentum + 2 * dimensions + (pressureByTransforms ? 2 : 0) + gradient;
}

class Description
{
public:
    Description(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings)
        : lattice_(lattice),
          fluid_(fluid),
          settings_(settings),
          convects_(settings.convection != ConvectionForm::none),
          viscous_(fluid.nu > 0),
          bounded_(!lattice.periodic())
    {
        sortParts();
        listSchemes();
        countTransforms();
    }

    SceneDescription scene{};

private:
    void sortParts();
    void sortAxes();
    void listSchemes();
    void countTransforms();

    /// yes if it is active, else no is left out; an empty one is not said.
    void choose(bool active, const std::string& yes, const std::string& no)
    {
        auto& list = active ? scene.active : scene.leftOut;
        const std::string& part = active ? yes : no;
        if (!part.empty()) { list.push_back(part); }
    }

    const Lattice& lattice_;
    const Fluid& fluid_;
    const FlowSettings& settings_;
    bool convects_;
    bool viscous_;
    bool bounded_;
};

void Description::sortParts()
{
    const int dimensions = lattice_.dimensions();
    const std::string_view viscous = viscousTreatments().nameOf(viscousTreatment(settings_));
    scene.active.push_back(fmt::format("{} velocity components", dimensions));
    choose(dimensions == 3, "three axes", "third component (an axis is left out)");
    choose(convects_, fmt::format("convection: {}", convectionForms().nameOf(settings_.convection)), "convection");
    choose(viscous_,
           fmt::format("viscous term: {}, {}", laplacians().nameOf(settings_.laplacian),
                       settings_.automaticViscous ? "explicit or CrankNicolson, whichever steps further" : viscous),
           "viscous term (nu is 0)");
    choose(fluid_.bodyForce != nullptr, "body force", "body force");
    choose(settings_.filter.type != FilterSettings::Type::none, "filter: " + describeFilter(settings_.filter),
           "filter");
    sortAxes();
}

void Description::sortAxes()
{
    if (bounded_)
    {
        for (int d = 0; d < lattice_.dimensions(); ++d)
        {
            const Axis& axis = lattice_.activeAxis(d);
            const auto& continuation = settings_.continuations[static_cast<std::size_t>(lattice_.direction(d))];
            choose(continuation != nullptr,
                   continuation ? describeContinuation(axis, *continuation, settings_) : std::string(),
                   fmt::format("continuation along {} (periodic)", axis.name));
        }
        choose(settings_.extended, "transforms of the whole extended box", "transforms of the whole extended box");
        scene.active.push_back(fmt::format("walls: {}", wallTreatments().nameOf(settings_.walls)));
        choose(settings_.directPressure, "pressure: diagonalised continuation operators", "");
        const bool mirrors = settings_.eigenvalues == Eigenvalues::morris && !settings_.directPressure;
        choose(mirrors && !settings_.iteration, "pressure: mirrored Morris Laplacian" + sampledFor(settings_.kernel),
               "");
    }
    else
    {
        choose(settings_.dealiasing != Dealiasing::none, "dealiasing: two thirds", "dealiasing");
        choose(settings_.exactMeanFlow && convects_, "mean flow carried exactly", "exact mean flow");
        choose(settings_.incremental, "old pressure in the predictor", "old pressure in the predictor");
        scene.leftOut.emplace_back("continuation (every axis is periodic)");
    }
    if (settings_.iteration) { scene.active.push_back(describeIteration(lattice_, settings_)); }
    scene.leftOut.emplace_back("pressure in steps that write none");
}

void Description::listSchemes()
{
    scene.schemes = {
        {"kernel", describeKernel(settings_.kernel)},
        {"operators", settings_.directSum ? "directSum" : "spectral"},
        {"convection", std::string(convectionForms().nameOf(settings_.convection))},
        {"laplacian", viscous_ ? std::string(laplacians().nameOf(settings_.laplacian)) : "none"},
        {"time", std::string(timeSchemes().nameOf(settings_.time))},
        {"viscous", viscous_ ? std::string(viscousTreatments().nameOf(viscousTreatment(settings_))) : "none"},
        {"meanFlow", settings_.exactMeanFlow ? "exact" : "none"},
        {"dealiasing", std::string(dealiasings().nameOf(settings_.dealiasing))},
        {"filter", describeFilter(settings_.filter)}};
    if (bounded_)
    {
        scene.schemes.insert(scene.schemes.end(),
                             {{"continuation", settings_.continuation + (settings_.extended ? ", extended" : "")},
                              {"walls", std::string(wallTreatments().nameOf(settings_.walls))}});
    }
    scene.schemes.emplace_back("solver", solverName(settings_));
    scene.schemes.emplace_back("eigenvalues", eigenvalueForms().nameOf(settings_.eigenvalues));
    if (!bounded_) { scene.schemes.emplace_back("coupling", settings_.incremental ? "incremental" : "nonIncremental"); }
}

void Description::countTransforms()
{
    const int dimensions = lattice_.dimensions();
    scene.transformsOfLines = bounded_ && !settings_.extended;
    if (bounded_)
    {
        bool anyPeriodic = false;
        for (int d = 0; d < dimensions; ++d) { anyPeriodic = anyPeriodic || lattice_.activeAxis(d).periodic(); }
        scene.transformsPerSubstep = (settings_.extended ? extendedTransforms : lineTransforms)(
            dimensions, convects_, viscous_ && !settings_.crankNicolson,
            !settings_.directPressure && !settings_.iteration);
        // The slope of the pressure along it comes with the pressure of the boxes' own Laplacian.
        const bool comes = !settings_.directPressure && settings_.eigenvalues != Eigenvalues::morris;
        if (anyPeriodic && scene.transformsOfLines && comes) { --scene.transformsPerSubstep; }
        return;
    }
    if (settings_.directSum)
    {
        scene.transformsPerSubstep = settings_.iteration ? 0 : 2;
        return;
    }
    const auto convection =
        makeConvection(settings_.convection, dimensions, settings_.eigenvalues == Eigenvalues::consistent);
    scene.transformsPerSubstep = convection ? convection->inputs() + convection->products() : 0;
    if (settings_.iteration) { scene.transformsPerSubstep += 2; } // the source to the points, and phi back
    if (fluid_.bodyForce && fluid_.bodyForce->dependsOnTime()) { scene.transformsPerSubstep += dimensions; }
}

} // namespace

SceneDescription describeScene(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings)
{
    return Description(lattice, fluid, settings).scene;
}

} // namespace isph
