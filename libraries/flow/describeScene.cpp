#include "flow/describeScene.hpp"

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

} // namespace

SceneDescription describeScene(const Lattice& lattice, const Fluid& fluid, const FlowSettings& settings)
{
    SceneDescription scene{};
    const auto choose = [&scene](bool active, const std::string& yes, const std::string& no)
    {
        if (active) { scene.active.push_back(yes); }
        else if (!no.empty()) { scene.leftOut.push_back(no); }
    };
    const int dimensions = lattice.dimensions();
    const bool convects = settings.convection != ConvectionForm::none;
    const bool viscous = fluid.nu > 0;
    scene.active.push_back(fmt::format("{} velocity components", dimensions));
    choose(dimensions == 3, "three axes", "third component (an axis is left out)");
    choose(convects, fmt::format("convection: {}", convectionForms().nameOf(settings.convection)), "convection");
    choose(viscous,
           fmt::format("viscous term: {}, {}", laplacians().nameOf(settings.laplacian),
                       settings.integratingFactor ? "integrating factor" : "explicit"),
           "viscous term (nu is 0)");
    choose(fluid.bodyForce != nullptr, "body force", "body force");
    choose(settings.dealiasing != Dealiasing::none, "dealiasing: two thirds", "dealiasing");
    choose(settings.filter.type != FilterSettings::Type::none, "filter: " + describeFilter(settings.filter), "filter");
    choose(settings.exactMeanFlow && convects, "mean flow carried exactly", "exact mean flow");
    choose(settings.incremental, "old pressure in the predictor", "old pressure in the predictor");
    scene.leftOut.emplace_back("continuation (every axis is periodic)");
    scene.leftOut.emplace_back("pressure in steps that write none");

    const std::string_view time = timeSchemes().nameOf(settings.time);
    scene.schemes = {{"kernel", describeKernel(settings.kernel)},
                     {"operators", settings.directSum ? "directSum" : "spectral"},
                     {"convection", std::string(convectionForms().nameOf(settings.convection))},
                     {"laplacian", viscous ? std::string(laplacians().nameOf(settings.laplacian)) : "none"},
                     {"time", std::string(time)},
                     {"viscous", !viscous                     ? "none"
                                 : settings.integratingFactor ? "integratingFactor"
                                                              : "explicit"},
                     {"meanFlow", settings.exactMeanFlow ? "exact" : "none"},
                     {"dealiasing", std::string(dealiasings().nameOf(settings.dealiasing))},
                     {"filter", describeFilter(settings.filter)},
                     {"eigenvalues", std::string(eigenvalueForms().nameOf(settings.eigenvalues))},
                     {"coupling", settings.incremental ? "incremental" : "nonIncremental"}};

    if (settings.directSum) { scene.transformsPerSubstep = 2; }
    else
    {
        const auto convection =
            makeConvection(settings.convection, dimensions, settings.eigenvalues == Eigenvalues::consistent);
        scene.transformsPerSubstep = convection ? convection->inputs() + convection->products() : 0;
        if (fluid.bodyForce && fluid.bodyForce->dependsOnTime()) { scene.transformsPerSubstep += dimensions; }
    }
    return scene;
}

} // namespace isph
