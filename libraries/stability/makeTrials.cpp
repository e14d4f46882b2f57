#include "stability/makeTrials.hpp"

#include "caseFields/FieldsOfTime.hpp"
#include "core/Error.hpp"
#include "fields/reductions.hpp"
#include "flow/sceneSymbols.hpp"
#include "flow/VolumeBalance.hpp"
#include "stability/sceneModes.hpp"
#include "stability/trialFlows.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <utility>

namespace isph
{

namespace
{

/// The modes of lines are not quite those of a flow, whose pressure couples them.
constexpr double sharpnessOfLines = 1.2;
constexpr double doubtOfLines = 10;
constexpr double onlySufficient = std::numeric_limits<double>::infinity();

class Planner
{
public:
    Planner(const Case& flowCase, std::string time, const std::vector<double>& fractions)
        : case_(flowCase), time_(std::move(time)), fractions_(fractions), scene_(flowCase, time_)
    {
        FieldsOfTime fields(case_, time_);
        start_ = fields.time();
        scene_.boundary.update(start_);
        velocity_ = fields.read("U", scene_.lattice);
        scene_.boundary.impose(velocity_);
    }

    TrialPlan plan()
    {
        if (!periodic()) { measureAtRest(); }
        addConvective();
        addViscous();
        addOwnStart();
        return std::move(plan_);
    }

private:
    const Lattice& lattice() const { return scene_.lattice; }
    bool periodic() const { return lattice().periodic(); }
    bool filters() const { return scene_.settings.filter.type != FilterSettings::Type::none; }
    /// Forward Euler bears convection only with viscosity beside it.
    bool needsViscosity() const { return scene_.settings.time->imaginaryLimit == 0; }

    /// The scene without forces, whose faces prescribe a flow.
    StabilityTrial trialOf(std::string term, const FlowOfPlace& flow)
    {
        StabilityTrial trial;
        trial.term = std::move(term);
        trial.scene = std::make_unique<Scene>(case_, time_);
        trial.scene->fluid.bodyForce.reset();
        trial.scene->boundary = boundaryFor(lattice(), scene_.boundary, flow);
        trial.base = fieldOf(lattice(), flow);
        trial.prediction.scheme = trial.scene->settings.time;
        trial.prediction.growthAtRest = plan_.growthAtRest.value_or(0);
        trial.fractions = fractions_;
        return trial;
    }

    /// The limit that the solver itself finds for a trial's flow.
    static double limitOf(StabilityTrial& trial)
    {
        Timings timings;
        trial.scene->boundary.update(trial.time);
        const auto flow = makeFlow(*trial.scene, timings, PlanEffort::estimated);
        flow->start(trial.base, true);
        return largestStableStep(*trial.scene->settings.time, flow->rates());
    }

    /// The modes of a prediction are those of lines.
    static void takeLines(Prediction& prediction)
    {
        prediction.sharpness = sharpnessOfLines;
        prediction.doubt = doubtOfLines;
    }

    void measureAtRest();
    void addConvective();
    void addViscous();
    void addImplicit(double explicitLimit);
    bool choosesImplicit() const;
    void addOwnStart();
    double speedOfCase() const;
    void leaveOut(std::string_view term, std::string_view why)
    {
        plan_.leftOut.push_back(fmt::format("{}: {}", term, why));
    }

    const Case& case_;
    std::string time_;
    std::vector<double> fractions_;
    Scene scene_;
    RealField velocity_;
    double start_ = 0;
    TrialPlan plan_;
};

/// Largest component of the start, without a mean that the scheme carries exactly; 1 m/s for a fluid at rest.
double Planner::speedOfCase() const
{
    double largest = 0;
    for (int c = 0; c < velocity_.components(); ++c)
    {
        const double mean =
            scene_.settings.exactMeanFlow ? sum(velocity_[c]) / static_cast<double>(velocity_.size()) : 0;
        for (const double u : velocity_[c]) { largest = std::max(largest, std::abs(u - mean)); }
    }
    return largest > 0 ? largest : 1;
}

void Planner::measureAtRest()
{
    StabilityTrial trial = trialOf("at rest", atRest());
    FlowSettings& settings = trial.scene->settings;
    settings.convection = ConvectionForm::none;
    settings.crankNicolson = settings.automaticViscous = false;
    plan_.growthAtRest = growthOfProjection(lattice(), settings, trial.scene->boundary);
}

void Planner::addConvective()
{
    if (scene_.settings.convection == ConvectionForm::none) { return leaveOut("convective", "nothing is convected"); }
    const double speed = speedOfCase();
    std::optional<Passage> passage;
    if (periodic())
    {
        const auto derivative = boundsOf(lattice(), scene_.fluid, scene_.settings).derivative;
        const auto steepest = std::max_element(derivative.begin(), derivative.begin() + lattice().dimensions());
        passage = Passage{static_cast<int>(steepest - derivative.begin()), 1, Passage::Kind::around};
    }
    else { passage = passageOf(lattice(), scene_.boundary); }

    if (!passage) { return leaveOut("convective", "a uniform flow along any axis would pass through a mirror"); }
    StabilityTrial trial = trialOf("convective", uniformFlow(lattice().direction(passage->d), passage->sign * speed));
    Scene& scene = *trial.scene;
    scene.settings.exactMeanFlow = false;
    if (!needsViscosity())
    {
        scene.fluid.nu = 0;
        scene.settings.integratingFactor = false;
    }
    if (!periodic()) { scene.settings.automaticViscous = scene.settings.crankNicolson = false; }
    trial.prediction.limit = limitOf(trial);
    trial.what = fmt::format("uniform flow of {:.4g} m/s along {}{}{}", speed, lattice().activeAxis(passage->d).name,
                             periodic()                                ? ""
                             : passage->kind == Passage::Kind::through ? ", from the inlet to the outlet"
                             : passage->kind == Passage::Kind::around  ? ", walls that move with it"
                                                                       : ", walls that let it pass",
                             needsViscosity() ? ", viscosity beside it" : "");
    if (periodic())
    {
        std::array<double, 3> velocity{};
        velocity[static_cast<std::size_t>(passage->d)] = speed;
        trial.prediction.modes = periodicModes(lattice(), scene.fluid, scene.settings, velocity);
    }
    else if (!needsViscosity() && !filters())
    {
        const LineSpectra spectra(lattice(), scene.settings, scene.boundary);
        trial.prediction.modes = carriedModes(lattice(), spectra, passage->d, passage->sign * speed);
        takeLines(trial.prediction);
    }
    // Along a periodic axis nothing is continued: its modes are waves.
    if (passage->kind == Passage::Kind::around)
    {
        trial.prediction.sharpness = Prediction().sharpness;
        trial.prediction.doubt = Prediction().doubt;
    }
    if (trial.prediction.modes.empty()) { trial.prediction.sharpness = onlySufficient; }
    plan_.trials.push_back(std::move(trial));
}

void Planner::addViscous()
{
    if (scene_.fluid.nu == 0) { return leaveOut("viscous", "the fluid has no viscosity"); }
    StabilityTrial trial = trialOf("viscous", atRest());
    FlowSettings& settings = trial.scene->settings;
    settings.convection = ConvectionForm::none;
    settings.exactMeanFlow = false;
    settings.integratingFactor = settings.crankNicolson = settings.automaticViscous = false;
    trial.what = "fluid at rest";
    trial.prediction.mayDamp = true;
    trial.prediction.limit = limitOf(trial);
    if (periodic()) { trial.prediction.modes = periodicModes(lattice(), trial.scene->fluid, settings, {0, 0, 0}); }
    else if (!filters())
    {
        trial.prediction.modes =
            dampedModes(lattice(), LineSpectra(lattice(), settings, trial.scene->boundary), trial.scene->fluid.nu);
        takeLines(trial.prediction);
    }
    if (trial.prediction.modes.empty()) { trial.prediction.sharpness = onlySufficient; }
    const double limit = trial.prediction.limit;
    const bool marchesExplicitly = !scene_.settings.integratingFactor && !scene_.settings.crankNicolson;
    if (marchesExplicitly) { plan_.trials.push_back(std::move(trial)); }
    if (choosesImplicit() && std::isfinite(limit)) { addImplicit(limit); }
}

/// Whether a step of this case may take its viscous term implicitly, as BoundedFlow decides it.
bool Planner::choosesImplicit() const
{
    const FlowSettings& settings = scene_.settings;
    if (settings.integratingFactor || settings.crankNicolson) { return true; }
    return settings.automaticViscous && settings.walls == WallTreatment::consistent &&
           !VolumeBalance::concerns(lattice(), scene_.boundary) && !scene_.boundary.flowsThroughCorners();
}

/// Steps of 1, 100 and 10000 times what an explicit term bears.
void Planner::addImplicit(double explicitLimit)
{
    StabilityTrial trial = trialOf("implicit viscous", atRest());
    FlowSettings& settings = trial.scene->settings;
    settings.convection = ConvectionForm::none;
    settings.exactMeanFlow = false;
    settings.crankNicolson = !settings.integratingFactor;
    settings.automaticViscous = false;
    trial.what = fmt::format("fluid at rest, {}; fractions of what an explicit term bears",
                             settings.integratingFactor ? "the integrating factor" : "Crank-Nicolson");
    trial.unit = explicitLimit;
    trial.prediction.mayDamp = true;
    trial.fractions = {1, 100, 1e4};
    try
    {
        Timings timings;
        trial.scene->boundary.update(trial.time);
        makeFlow(*trial.scene, timings, PlanEffort::estimated);
    }
    catch (const Error&)
    {
        // `viscous auto` stays explicit where there are no real eigenvectors; a case that asks for more is refused.
        if (!scene_.settings.automaticViscous) { throw; }
        return leaveOut("implicit viscous", "the second derivative has no real eigenvectors: auto stays explicit");
    }
    plan_.trials.push_back(std::move(trial));
}

void Planner::addOwnStart()
{
    StabilityTrial trial;
    trial.term = "own start";
    trial.scene = std::make_unique<Scene>(case_, time_);
    trial.base = copyOf(velocity_);
    trial.time = start_;
    trial.prediction.scheme = trial.scene->settings.time;
    trial.prediction.limit = limitOf(trial);
    if (!std::isfinite(trial.prediction.limit)) { return leaveOut("own start", "nothing limits its step"); }
    trial.what = "the case as it starts, all terms; the limit of each step's velocity is only sufficient";
    trial.steady = false;
    trial.prediction.sharpness = onlySufficient;
    trial.stretching = largestStretching(lattice(), velocity_);
    trial.fractions = fractions_;
    plan_.trials.push_back(std::move(trial));
}

} // namespace

TrialPlan makeTrials(const Case& flowCase, const std::string& time, const std::vector<double>& fractions)
{
    return Planner(flowCase, time, fractions).plan();
}

} // namespace isph
