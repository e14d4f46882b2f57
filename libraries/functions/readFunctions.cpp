#include "functions/readFunctions.hpp"

#include "case/CsvWriter.hpp"
#include "functions/FlowStatisticsFunction.hpp"
#include "functions/SampleLinesFunction.hpp"
#include "functions/TimingFunction.hpp"
#include "sampling/readSampleSet.hpp"

namespace isph
{

namespace
{

std::vector<Key> noKeys() { return {}; }

std::unique_ptr<FunctionObject> makeFlowStatistics(const std::string& name, const Dictionary&,
                                                   const FunctionSurroundings& surroundings)
{
    return std::make_unique<FlowStatisticsFunction>(outputFile(name, "flow.csv", surroundings), surroundings.lattice,
                                                    surroundings.fluid, surroundings.boundary);
}

std::unique_ptr<FunctionObject> makeSampleLines(const std::string& name, const Dictionary&,
                                                const FunctionSurroundings& surroundings)
{
    return std::make_unique<SampleLinesFunction>(
        outputFolder(name, surroundings),
        readSampleSet(surroundings.theCase.dictionary("system/sampleDict"), surroundings.lattice),
        FlowFields(surroundings.lattice, pressureForm(surroundings)));
}

std::unique_ptr<FunctionObject> makeTiming(const std::string& name, const Dictionary&,
                                           const FunctionSurroundings& surroundings)
{
    return std::make_unique<TimingFunction>(outputFile(name, "timing.csv", surroundings));
}

} // namespace

const FunctionType flowStatisticsType{noKeys, makeFlowStatistics};
const FunctionType sampleLinesType{noKeys, makeSampleLines};
const FunctionType timingType{noKeys, makeTiming};

std::filesystem::path outputFile(const std::string& name, const std::string& file,
                                 const FunctionSurroundings& surroundings)
{
    const std::filesystem::path path =
        postProcessingFile(surroundings.theCase.directory(), name, surroundings.startTime, file);
    if (!surroundings.besideRun || !std::filesystem::exists(path)) { return path; }
    return path.parent_path() / (path.stem().string() + "_postProcess" + path.extension().string());
}

std::filesystem::path outputFolder(const std::string& name, const FunctionSurroundings& surroundings)
{
    return surroundings.theCase.path("postProcessing") / name;
}

std::vector<FlowQuantity> readQuantities(const Dictionary& dictionary, std::string_view key)
{
    std::vector<FlowQuantity> quantities;
    for (const Word& word : dictionary.words(key)) { quantities.push_back(flowQuantities()[word]); }
    if (quantities.empty()) { throw dictionary.error(key, "names no field", "write e.g. fields (U p);"); }
    return quantities;
}

PressureForm pressureForm(const FunctionSurroundings& surroundings)
{
    return {surroundings.pressureScale, surroundings.pressureUnit, surroundings.pressureFixed};
}

} // namespace isph
