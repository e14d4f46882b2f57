#include "reports.hpp"

#include "lattice/fastCounts.hpp"
#include "lattice/readLattice.hpp"

namespace isph
{

namespace
{

Json place(const Origin& origin)
{
    return Json::object({{"file", origin.file}, {"line", origin.line}, {"entry", origin.entry}});
}

Json ofSlips(const std::vector<Complaint>& slips)
{
    Json list = Json::array();
    for (const Complaint& slip : slips)
    {
        list.add(place(slip.origin).set("what", slip.what).set("advice", slip.advice));
    }
    return list;
}

Json ofLattice(const std::optional<Lattice>& lattice)
{
    if (!lattice) { return {}; }
    Json points = Json::array();
    Json spacings = Json::array();
    Json axes = Json::array();
    bool fast = true;
    for (int direction = 0; direction < 3; ++direction)
    {
        const Axis& axis = lattice->axis(direction);
        points.add(axis.count);
        if (!axis.active()) { continue; }
        spacings.add(axis.spacing());
        axes.add(toString(axis));
        fast = fast && isFastCount(axis.periodic() || axis.staggered ? axis.count : axis.count - 1);
    }
    return Json::object({{"points", points}, {"spacing", spacings}, {"axes", axes}, {"fastTransforms", fast}});
}

Json ofKernel(const std::optional<KernelResolution>& kernel, const CaseReading& reading)
{
    if (!kernel) { return {}; }
    Json h = Json::array();
    for (int d = 0; d < reading.lattice->dimensions(); ++d) { h.add(kernel->h[static_cast<std::size_t>(d)]); }
    Json waves = Json::array();
    for (const KernelResolution::Wave& wave : kernel->waves)
    {
        waves.add(Json::object({{"pointsPerWavelength", wave.pointsPerWavelength},
                                {"gradientError", wave.gradient},
                                {"laplacianError", wave.laplacian ? Json(*wave.laplacian) : Json()}}));
    }
    const bool exact = reading.settings->kernel.exact();
    return Json::object({{"smoothingLength", exact ? Json() : Json(reading.settings->kernel.smoothingLength)},
                         {"h", exact ? Json() : h},
                         {"supportPoints", kernel->supportPoints ? Json(*kernel->supportPoints) : Json()},
                         {"neighbours", kernel->supportPoints ? Json(kernel->neighbours) : Json()},
                         {"cutOff", kernel->cutOff ? Json(*kernel->cutOff) : Json()},
                         {"longWaveError", kernel->defect},
                         {"waves", waves}});
}

Json ofSteps(const std::optional<StepForecast>& steps, const CaseReading& reading)
{
    if (!steps) { return {}; }
    const auto orNull = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
    return Json::object(
        {{"courant", orNull(steps->numbers.courant)},
         {"viscousNumber", orNull(steps->numbers.viscous)},
         {"largestStableStep", steps->largestStable},
         {"deltaT", steps->step},
         {"automatic", !reading.control->settings().deltaT},
         {"ruling", steps->ruling},
         {"crankNicolson", reading.settings->crankNicolson || steps->crankNicolson},
         {"steps", steps->steps},
         {"courantAtStart", steps->step * steps->rates.courant},
         {"viscousNumberAtStart", steps->viscousNumber},
         {"margin", Json::object({{"convective", steps->margin.convective}, {"viscous", steps->margin.viscous}})}});
}

} // namespace

Json jsonReport(const CaseCheck& check)
{
    const CaseReading& reading = check.reading;
    Json schemes = Json::object();
    Json defaults = Json::array();
    for (const auto* choices : {&check.choices.schemes, &check.choices.solution})
    {
        for (const Choice& choice : *choices)
        {
            schemes.set(choice.key, choice.value);
            if (choice.isDefault) { defaults.add(choice.key); }
        }
    }
    Json idle = Json::array();
    for (const Idle& entry : check.choices.idle) { idle.add(place(entry.origin).set("why", entry.why)); }

    const bool described = check.scene.has_value();
    return Json::object({{"schema", 1},
                         {"case", reading.theCase ? Json(reading.theCase->name()) : Json()},
                         {"ok", check.canRun()},
                         {"errors", ofSlips(reading.slips)},
                         {"notLookedAt", Json::arrayOf(reading.unread)},
                         {"warnings", Json::arrayOf(reading.warnings)},
                         {"startFolder", reading.start ? Json(reading.start->folder.name) : Json()},
                         {"lattice", ofLattice(reading.lattice)},
                         {"active", described ? Json::arrayOf(check.scene->active) : Json()},
                         {"leftOut", described ? Json::arrayOf(check.scene->leftOut) : Json()},
                         {"schemes", reading.settings ? schemes : Json()},
                         {"defaults", reading.settings ? defaults : Json()},
                         {"withoutEffect", idle},
                         {"transformsPerSubstep", described ? Json(check.scene->transformsPerSubstep) : Json()},
                         {"substepsPerStep", reading.settings ? Json(reading.settings->time->substeps.size()) : Json()},
                         {"memory", check.memory ? Json(*check.memory) : Json()},
                         {"kernel", ofKernel(check.kernel, reading)},
                         {"stability", ofSteps(check.steps, reading)}});
}

} // namespace isph
