#include "SceneRun.hpp"

#include "case/Case.hpp"

namespace isph::test
{

namespace
{

Functions functionsOf(const Case& theCase, const Scene& scene)
{
    const Dictionary controlDict = theCase.dictionary("system/controlDict");
    if (!controlDict.hasDictionary("functions")) { return {}; }
    return Functions(controlDict.dictionary("functions"), {.theCase = theCase,
                                                           .lattice = scene.lattice,
                                                           .fluid = scene.fluid,
                                                           .startTime = "0",
                                                           .pressureScale = scene.files.pressureScale,
                                                           .pressureUnit = scene.files.pressureUnit,
                                                           .pressureFixed = scene.boundary.fixesPressure(),
                                                           .boundary = &scene.boundary});
}

} // namespace

SceneRun::SceneRun(const std::filesystem::path& folder, PlanEffort effort)
    : case_(folder),
      control_(readTimeControl(case_)),
      scene_(case_, "0"),
      functions_(functionsOf(case_, scene_)),
      flow_(makeFlow(scene_, timings_, effort))
{
    readFlow(case_, "0", false, scene_, *flow_);
    rates_ = flow_->rates();
    observe();
}

void SceneRun::observe()
{
    if (functions_.empty()) { return; }
    const TimeState state = control_.state();
    functions_.execute(control_.event(), {.flow = *flow_,
                                          .time = state.time,
                                          .name = control_.timeName(),
                                          .step = state.index,
                                          .cpuTime = state.cpuTime,
                                          .wallTime = state.wallTime,
                                          .timings = timings_,
                                          .dt = control_.lastStep()});
}

void SceneRun::step()
{
    const double dt = control_.timeStep(
        stepLimits(scene_.lattice, scene_.fluid, *scene_.settings.time, rates_, functions_.nextTime()));
    advance(*scene_.settings.time, *flow_, control_.time(), dt);
    rates_ = flow_->rates();
    control_.advance();
    observe();
}

} // namespace isph::test
