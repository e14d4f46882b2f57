// checkStability: puts the schemes of a case on the rack.
//
//     checkStability -case cavity                      spectra, limits, and trials at fractions of each limit
//     checkStability -case cavity -noTrials            spectra and limits only
//     checkStability -table                            what every kernel, continuation and scheme bears, without a case
//     checkStability -case cavity -fractions '(0.9 1.1)' -steps 500
//
// Writes nothing into the case. Exit code 1 when a trial contradicts its prediction.

#include "schemeTables.hpp"
#include "StabilityReport.hpp"

#include "case/readTimeControl.hpp"
#include "core/Error.hpp"
#include "core/runApplication.hpp"
#include "fields/threads.hpp"
#include "flow/sceneSymbols.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <iostream>
#include <sstream>

using namespace isph;

/// A positive number of the list behind -fractions.
static double fractionOf(const std::string& text)
{
    double value = 0;
    const auto [end, slip] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (slip != std::errc() || end != text.data() + text.size() || !(value > 0) || std::isinf(value))
    {
        throw Error(Fault::usage, fmt::format("-fractions: '{}' is no positive number", text));
    }
    return value;
}

/// -fractions '(0.5 0.98 1.03)', ascending.
static std::vector<double> fractionsOf(const CommandLine& line)
{
    const auto text = line.value("fractions");
    if (!text) { return {0.5, 0.9, 0.98, 1.03, 2}; }
    std::string words = *text;
    std::ranges::replace_if(
        words, [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
    std::istringstream stream(words);
    std::vector<double> fractions;
    for (std::string word; stream >> word;) { fractions.push_back(fractionOf(word)); }
    if (fractions.empty()) { throw Error(Fault::usage, "-fractions: the list is empty", "write '(0.9 1.1)'"); }
    std::ranges::sort(fractions);
    return fractions;
}

static void run(const CommandLine& line, Log& log)
{
    if (line.has("table"))
    {
        if (line.has("json")) { std::cout << schemeTables().text(); }
        else { printSchemeTables(log); }
        return;
    }
    const std::vector<double> fractions = fractionsOf(line);
    constexpr int least = 60; // fewer show nothing of the modes that grow slowest
    const int steps = line.wholeNumber("steps", least, 400);
    useRequestedThreads();
    const Case flowCase(line.caseDirectory());
    const Dictionary controlDict = controlDictSchema().complete(flowCase.dictionary("system/controlDict"));
    if (controlDict.text("application") == "scalarTransportFoam")
    {
        throw controlDict.error("application", "checkStability tries flows, not scalars",
                                "checkCase prints the limits of scalarTransportFoam");
    }
    const StartFolder start = findStart(flowCase, readTimeSettings(controlDict));
    const Scene scene(flowCase, start.folder.name);

    StabilityReport report;
    report.caseName = flowCase.name();
    report.time = scene.settings.time;
    report.scheme = timeSchemes().nameOf(scene.settings.time);
    report.tried = !line.has("noTrials");
    report.spectra = sceneSpectra(scene.lattice, scene.fluid, scene.settings, scene.boundary);
    report.numbers =
        stableNumbers(scene.lattice, scene.fluid, scene.settings, boundsOf(scene.lattice, scene.fluid, scene.settings));
    TrialPlan plan = makeTrials(flowCase, start.folder.name, fractions);
    report.leftOut = plan.leftOut;
    report.growthAtRest = plan.growthAtRest;
    const bool asText = !line.has("json");
    if (asText) { printPrediction(report, log); }
    Timings timings;
    for (StabilityTrial& trial : plan.trials)
    {
        trial.modesGrow = report.modesMayGrow();
        TrialResult result;
        const auto progress = [&](double fraction)
        {
            if (asText) { log.status(fmt::format("{}: {:.4g} of the limit", trial.term, fraction)); }
        };
        if (report.tried) { result = runFractions(trial, steps, timings, progress); }
        report.trials.push_back(summaryOf(trial, std::move(result)));
        if (asText) { printTrial(report.trials.back(), log); }
    }
    if (asText) { printVerdict(report, log); }
    else { std::cout << jsonOf(report).text(); }
    if (!report.agrees())
    {
        throw Error(Fault::input, "trials contradict what was predicted of them",
                    "look for NO in the table; docs/theory/stability.md says how trials are judged");
    }
}

int main(int argc, char** argv)
{
    const Application application{
        .name = "checkStability",
        .summary = "predicts how large steps the schemes of a case bear, and tries it",
        .examples = "checkStability -case cavity\ncheckStability -case cavity -noTrials -json",
        .options = {{"noTrials", "", "spectra and limits only"},
                    {"steps", "N", "steps of a trial (400); more where modes grow slowly"},
                    {"fractions", "'(0.5 0.9 0.98 1.03 2)'", "of the limits, to be tried"},
                    {"table", "", "what every kernel, continuation and scheme bears; needs no case"},
                    {"json", "", "print one JSON object and nothing else"}},
        .banner = false};
    return runApplication(application, argc, argv, run);
}
