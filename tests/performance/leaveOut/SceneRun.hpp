#pragma once

#include "case/readTimeControl.hpp"
#include "flow/readFlow.hpp"
#include "flow/Scene.hpp"
#include "flow/stableNumbers.hpp"
#include "functions/functionSelection.hpp"
#include "schemes/TimeScheme.hpp"

#include <filesystem>
#include <memory>

namespace isph::test
{

/// A case on its way, as isphFoam marches it, a step at a time.
class SceneRun
{
public:
    explicit SceneRun(const std::filesystem::path& folder, PlanEffort effort);
    SceneRun(const SceneRun&) = delete; // the flow refers to its neighbours
    SceneRun& operator=(const SceneRun&) = delete;

    void step();

    int substeps() const { return static_cast<int>(scene_.settings.time->substeps.size()); }
    Scene& scene() { return scene_; }
    IncompressibleFlow& flow() { return *flow_; }
    double time() const { return control_.time(); }

private:
    void observe();

    Case case_;
    Timings timings_;
    TimeControl control_;
    Scene scene_;
    Functions functions_;
    std::unique_ptr<IncompressibleFlow> flow_;
    StepRates rates_;
};

} // namespace isph::test
