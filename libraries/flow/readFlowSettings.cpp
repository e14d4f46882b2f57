#include "flow/readFlowSettings.hpp"

#include "continuation/continuationSelection.hpp"
#include "core/Error.hpp"
#include "flow/IteratedPressure.hpp"
#include "flow/projectionRatio.hpp"
#include "kernels/kernelSelection.hpp"
#include "lattice/memoryEstimate.hpp"
#include "operators/continuedBounds.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace isph
{

namespace
{

bool wrote(const Dictionary& dictionary, std::string_view key)
{
    const Entry* entry = dictionary.find(key);
    return entry != nullptr && !entry->isDefault;
}

FilterSettings readFilter(const Dictionary& filter)
{
    return {filters()[filter.word("type")], filter.number("strength"), filter.number("order"),
            filter.number("fraction")};
}

std::optional<IterationSettings> readIteration(const Dictionary& p)
{
    const PressureSolver solver = pressureSolvers()[p.word("solver")];
    if (!iterative(solver)) { return std::nullopt; }
    return IterationSettings{.solver = solver,
                             .preconditioner = preconditioners()[p.word("preconditioner")],
                             .krylov = {p.number("tolerance"), p.integer("maxIter")}};
}

/// What makes the Laplacian of samples stronger: points that are as far apart on every axis, and sampled more densely.
std::string weakLaplacianAdvice(const Lattice& lattice, const KernelSettings& kernel)
{
    std::vector<double> spacings;
    for (int d = 0; d < lattice.dimensions(); ++d) { spacings.push_back(lattice.activeAxis(d).spacing()); }
    const bool stretched = std::ranges::max(spacings) > 1.5 * std::ranges::min(spacings);
    const std::string cure = stretched ? "take the same spacing on every axis"
                             : kernel.smoothingLength >= 2
                                 ? "write a lower order in kernel"
                                 : "write a larger smoothingLength (2), or a lower order, in kernel";
    return cure + "; or solver fft; eigenvalues consistent;";
}

/// What the Morris Laplacian over neighbours needs: a kernel that has some, and room for the matrix.
void checkMatrix(const Dictionary& p, const Lattice& lattice, const FlowSettings& settings)
{
    const bool mirrored =
        !lattice.periodic() && settings.eigenvalues == Eigenvalues::morris && !settings.directPressure;
    if (!settings.iteration && !mirrored) { return; }
    const std::string key = settings.iteration ? "solver" : "eigenvalues";
    if (settings.kernel.exact())
    {
        throw p.error(key, p.word(key).text + " sums over neighbours, and the exact derivative has none",
                      "write solver fft; eigenvalues consistent; or choose another kernel");
    }
    try
    {
        const KernelSamples samples(lattice, settings.kernel, LaplacianForm::morris);
        const double ratio = largestProjectionRatio(lattice, settings);
        if (ratio >= 2)
        {
            throw Error(Fault::input,
                        fmt::format("the Laplacian of this kernel's samples is too weak for its gradient, whose "
                                    "divergence is up to {:.3g} times as large: beyond 2 the flow grows without limit",
                                    ratio),
                        weakLaplacianAdvice(lattice, settings.kernel));
        }
        if (!settings.iteration) { return; }
        requireCountable(lattice, samples);
        const double bytes =
            iterationMemory(lattice, samples.offsets.size(), settings.iteration->solver, *settings.time);
        requireMemory(bytes, machineMemory(), {});
    }
    catch (const Error& error)
    {
        const Complaint& slip = error.complaints().front();
        throw p.error(key, slip.what, slip.advice);
    }
}

/// What acts on modes of a periodic box. Neighbour summation knows none: there it is off unless it was asked for, and
/// then refused.
void readPeriodic(const Dictionary& schemes, const Dictionary& solution, const Fluid& fluid, FlowSettings& settings)
{
    const ViscousTreatment viscous = viscousTreatments()[schemes.word("viscous")];
    if (viscous == ViscousTreatment::crankNicolson)
    {
        throw schemes.error("viscous", "CrankNicolson is of bounded axes, and every axis is periodic",
                            "write viscous integratingFactor; which is exact and limits nothing");
    }
    if (pressureSolvers()[solution.dictionary("p").word("solver")] == PressureSolver::direct)
    {
        throw solution.dictionary("p").error("solver", "direct is of bounded axes, and every axis is periodic",
                                             "write solver fft;");
    }
    const bool thirdOrder = settings.time->order == 3;
    settings.integratingFactor = viscous == ViscousTreatment::integratingFactor ||
                                 (viscous == ViscousTreatment::automatic && thirdOrder && !settings.directSum);
    settings.exactMeanFlow =
        schemes.word("meanFlow").text == "exact" && (!settings.directSum || wrote(schemes, "meanFlow"));
    settings.dealiasing = !settings.directSum || wrote(schemes, "dealiasing")
                              ? dealiasings()[schemes.word("dealiasing")]
                              : Dealiasing::none;
    if (!settings.directSum) { return; }

    if (settings.kernel.symbol != KernelSettings::Symbol::sampled)
    {
        throw schemes.error("operators", "directSum needs a kernel that is sampled",
                            "write symbol sampled; in kernel, or operators spectral;");
    }
    if (settings.laplacian == LaplacianForm::exact && fluid.nu > 0)
    {
        throw schemes.error("laplacian", "exact is no sum over neighbours", "choose morris or secondDerivative");
    }
    if (settings.integratingFactor)
    {
        throw schemes.error("viscous", "integratingFactor acts on modes, operators directSum has none",
                            "write viscous explicit;");
    }
    if (settings.exactMeanFlow)
    {
        throw schemes.error("meanFlow", "exact acts on modes, operators directSum has none", "write meanFlow none;");
    }
    if (settings.dealiasing != Dealiasing::none || settings.filter.type != FilterSettings::Type::none)
    {
        throw schemes.error(settings.dealiasing != Dealiasing::none ? "dealiasing" : "filter",
                            "acts on modes, operators directSum has none", "write none");
    }
}

/// How a step treats its walls; on staggered axes no point lies on them.
WallTreatment readWalls(const Dictionary& schemes, const Lattice& lattice)
{
    const WallTreatment walls = wallTreatments()[schemes.word("walls")];
    const bool needsWallPoints =
        walls == WallTreatment::consistent || walls == WallTreatment::slip || walls == WallTreatment::pressurePoisson;
    if (lattice.staggered() && needsWallPoints)
    {
        throw schemes.error("walls",
                            std::string(wallTreatments().nameOf(walls)) +
                                " needs points on the walls, but the lattice is staggered",
                            "write walls paper; or arrangement collocated; in system/latticeDict");
    }
    return walls;
}

std::string describeContinuation(const Dictionary& continuation)
{
    const std::string type = continuation.word("type").text;
    if (type == "mirror") { return type; }
    const bool automatic = continuation.find("degree")->tokens().front().kind != Token::Kind::number;
    return type + ", degree " + std::to_string(automatic ? automaticDegree(type) : continuation.integer("degree"));
}

/// A kernel that is sampled has to fit on every line.
void checkReach(const Dictionary& schemes, const Lattice& lattice, const FlowSettings& settings)
{
    try
    {
        continuedBounds(lattice, settings.continuations, settings.kernel, settings.laplacian);
    }
    catch (const Error& error)
    {
        const Complaint& slip = error.complaints().front();
        throw schemes.error("kernel", slip.what, slip.advice);
    }
}

/// What acts along lines between walls, and what does not.
void readBounded(const Dictionary& schemes, const Dictionary& solution, const Lattice& lattice, FlowSettings& settings)
{
    const Dictionary& p = solution.dictionary("p");
    const ViscousTreatment viscous = viscousTreatments()[schemes.word("viscous")];
    if (settings.directSum)
    {
        throw schemes.error("operators", "directSum knows periodic boxes only, but an axis is bounded",
                            "write operators spectral;");
    }
    if (settings.convection != ConvectionForm::advective && settings.convection != ConvectionForm::none)
    {
        throw schemes.error("convection",
                            std::string(convectionForms().nameOf(settings.convection)) +
                                " is of periodic boxes, but an axis is bounded",
                            "write convection advective;");
    }
    if (viscous == ViscousTreatment::integratingFactor)
    {
        throw schemes.error("viscous", "integratingFactor is of periodic boxes, but an axis is bounded",
                            "write viscous CrankNicolson; which limits the step as little");
    }
    if (schemes.word("meanFlow").text == "exact")
    {
        throw schemes.error("meanFlow", "exact is of periodic boxes, but an axis is bounded", "write meanFlow none;");
    }
    if (dealiasings()[schemes.word("dealiasing")] != Dealiasing::none)
    {
        throw schemes.error("dealiasing", "acts in periodic boxes only, but an axis is bounded",
                            "write dealiasing none; and a filter where small scales are not resolved");
    }
    if (settings.eigenvalues == Eigenvalues::secondOrder || settings.eigenvalues == Eigenvalues::fourthOrder)
    {
        throw p.error("eigenvalues",
                      std::string(eigenvalueForms().nameOf(settings.eigenvalues)) +
                          " is of periodic boxes, but an axis is bounded",
                      "write consistent or exact, which are the same here, or morris");
    }
    if (settings.incremental)
    {
        throw solution.dictionary("coupling")
            .error("type", "incremental is of periodic boxes, but an axis is bounded",
                   "write walls incremental; in system/schemes");
    }
    const Dictionary& continuation = schemes.dictionary("continuation");
    settings.continuations = selectContinuations(continuation, lattice);
    settings.continuation = describeContinuation(continuation);
    settings.extended = continuation.flag("extended");
    settings.walls = readWalls(schemes, lattice);
    settings.integratingFactor = false;
    settings.exactMeanFlow = false;
    settings.dealiasing = Dealiasing::none;
    settings.crankNicolson = viscous == ViscousTreatment::crankNicolson;
    settings.automaticViscous = viscous == ViscousTreatment::automatic && !settings.extended;
    settings.directPressure = pressureSolvers()[p.word("solver")] == PressureSolver::direct;
    if (settings.directPressure && lattice.staggered())
    {
        throw p.error("solver", "direct needs points on the walls, but the lattice is staggered",
                      "write solver fft; or arrangement collocated; in system/latticeDict");
    }
    if (settings.crankNicolson && settings.extended)
    {
        throw schemes.error("viscous", "CrankNicolson works line by line, continuation.extended does not",
                            "write viscous explicit; or extended no;");
    }
    if (settings.crankNicolson && settings.walls != WallTreatment::consistent)
    {
        throw schemes.error("viscous",
                            "CrankNicolson goes with walls consistent only, but walls is " +
                                std::string(wallTreatments().nameOf(settings.walls)),
                            "write viscous explicit; or walls consistent;");
    }
    checkReach(schemes, lattice, settings);
}

} // namespace

ViscousTreatment viscousTreatment(const FlowSettings& settings)
{
    return settings.integratingFactor  ? ViscousTreatment::integratingFactor
           : settings.crankNicolson    ? ViscousTreatment::crankNicolson
           : settings.automaticViscous ? ViscousTreatment::automatic
                                       : ViscousTreatment::explicitTerm;
}

FlowSettings readFlowSettings(const Dictionary& writtenSchemes, const Dictionary& writtenSolution,
                              const Lattice& lattice, const Fluid& fluid)
{
    const Dictionary schemes = completedSchemes(writtenSchemes, lattice);
    const Dictionary solution = completedSolution(writtenSolution, writtenSchemes);

    FlowSettings settings;
    settings.kernel = selectKernel(schemes.dictionary("kernel"));
    settings.directSum = schemes.word("operators").text == "directSum";
    settings.convection = convectionForms()[schemes.word("convection")];
    settings.laplacian = laplacians()[schemes.word("laplacian")];
    settings.time = timeSchemes()[schemes.word("time")];
    settings.eigenvalues = eigenvalueForms()[solution.dictionary("p").word("eigenvalues")];
    settings.iteration = readIteration(solution.dictionary("p"));
    // The matrix is that operator, whatever else is written.
    if (settings.iteration) { settings.eigenvalues = Eigenvalues::morris; }
    settings.incremental = solution.dictionary("coupling").word("type").text == "incremental";
    settings.initialProjection = solution.flag("initialProjection");
    settings.filter = readFilter(schemes.dictionary("filter"));
    if (lattice.periodic()) { readPeriodic(schemes, solution, fluid, settings); }
    else { readBounded(schemes, solution, lattice, settings); }
    checkMatrix(solution.dictionary("p"), lattice, settings);
    if (settings.time->imaginaryLimit == 0 && fluid.nu == 0 && settings.convection != ConvectionForm::none)
    {
        throw schemes.error("time", "firstOrderProjection has no stable step for an inviscid flow",
                            "its step must stay below 2 nu/|u|^2, which is 0 here: write time RK3;");
    }
    return settings;
}

} // namespace isph
