// checkCase: reads a whole case and says what isphFoam will make of it, before it runs.
//
//     checkCase -case taylorGreen2D                what is active, every choice, resolution, cost, stability, steps
//     checkCase -case taylorGreen2D -json          the same as one JSON object
//     checkCase -annotated schemes                 every entry of a dictionary with its default and meaning
//
// Writes nothing. Exit code 1 when the case cannot run, with every reason that was found.

#include "CaseCheck.hpp"
#include "reports.hpp"

#include "core/runApplication.hpp"
#include "flow/readFlowSettings.hpp"
#include "flow/readFluid.hpp"
#include "functions/flowListings.hpp"
#include "lattice/readLattice.hpp"
#include "sampling/readSampleSet.hpp"

#include <iostream>

using namespace isph;

/// The text of etc/annotated for a dictionary, as the schema has it.
static std::string annotated(const std::string& name)
{
    const std::vector<Schema> schemas{controlDictSchema(), latticeDictSchema(), sampleSchema(),
                                      schemesSchema(),     solutionSchema(),    transportPropertiesSchema()};
    std::vector<std::string> names;
    for (const Schema& schema : schemas)
    {
        if (schema.name() == name) { return schema.annotated(); }
        names.push_back(schema.name());
    }
    throw Error(Fault::usage, "-annotated: '" + name + "' is no dictionary of a case",
                "known are: " + listOfWords(name, names));
}

static void run(const CommandLine& line, Log& log)
{
    if (const auto name = line.value("annotated"))
    {
        std::cout << annotated(*name);
        return;
    }
    const CaseCheck check = checkCase(line.caseDirectory());
    if (line.has("json")) { std::cout << jsonReport(check).text(); }
    else { printReport(check, log); }
    if (!check.canRun()) { throw Error(Fault::input, check.reading.slips); }
}

int main(int argc, char** argv)
{
    const Application application{
        .name = "checkCase",
        .summary = "reads a whole case and says what the solver will make of it",
        .examples = "checkCase -case taylorGreen2D\ncheckCase -case taylorGreen2D -json\ncheckCase -annotated schemes",
        .options = {{"json", "", "print one JSON object and nothing else"},
                    {"annotated", "NAME",
                     "print a dictionary (schemes, controlDict, ...) with every default and meaning"}},
        .listings = flowListings(),
        .banner = false};
    return runApplication(application, argc, argv, run);
}
