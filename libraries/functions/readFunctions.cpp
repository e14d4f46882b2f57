#include "functions/readFunctions.hpp"

#include "case/CsvWriter.hpp"
#include "functions/FlowStatisticsFunction.hpp"

namespace isph
{

namespace
{

std::vector<Key> noKeys() { return {}; }

std::unique_ptr<FunctionObject> makeFlowStatistics(const std::string& name, const Dictionary&,
                                                   const FunctionSurroundings& surroundings)
{
    return std::make_unique<FlowStatisticsFunction>(outputFile(name, "flow.csv", surroundings), surroundings.lattice,
                                                    surroundings.fluid);
}

} // namespace

const FunctionType flowStatisticsType{noKeys, makeFlowStatistics};

std::filesystem::path outputFile(const std::string& name, const std::string& file,
                                 const FunctionSurroundings& surroundings)
{
    return postProcessingFile(surroundings.theCase.directory(), name, surroundings.startTime, file);
}

PressureForm pressureForm(const FunctionSurroundings& surroundings)
{
    return {surroundings.pressureScale, surroundings.pressureUnit, surroundings.pressureFixed};
}

} // namespace isph
