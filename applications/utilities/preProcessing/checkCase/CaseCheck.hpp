#pragma once

#include "CaseReading.hpp"
#include "KernelResolution.hpp"
#include "SchemeChoices.hpp"
#include "StepForecast.hpp"

#include "flow/describeScene.hpp"

#include <optional>

namespace isph
{

/// All that checkCase has found out about a case; what slips keep out of sight is missing.
struct CaseCheck
{
    CaseReading reading;
    SchemeChoices choices;
    std::optional<SceneDescription> scene;
    std::optional<KernelResolution> kernel;
    std::optional<StepForecast> steps;
    std::optional<double> memory; ///< that the solver will need [bytes]

    bool canRun() const { return reading.slips.empty(); }
};

CaseCheck checkCase(const std::filesystem::path& directory);

} // namespace isph
