#pragma once

#include "dictionary/Dictionary.hpp"
#include "dictionary/Schema.hpp"
#include "functions/FlowFields.hpp"
#include "functions/FunctionObject.hpp"
#include "functions/functionSelection.hpp"
#include "functions/PressureForm.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace isph
{

/// A type of function: the keys of its dictionary besides those that all have, and how it is made from them.
struct FunctionType
{
    std::vector<Key> (*keys)();

    /// \param name of the function, and so of the folder it writes to
    /// \param dictionary completed by the keys
    std::unique_ptr<FunctionObject> (*make)(const std::string& name, const Dictionary& dictionary,
                                            const FunctionSurroundings& surroundings);
};

extern const FunctionType errorNormsType;
extern const FunctionType flowStatisticsType;
extern const FunctionType sampleLinesType;
extern const FunctionType probesType;
extern const FunctionType fieldAverageType;
extern const FunctionType timingType;
extern const FunctionType wallProfileType;
extern const FunctionType forcesType;
extern const FunctionType patchFluxType;

/// <case>/postProcessing/<name>/<startTime>/<file>
std::filesystem::path outputFile(const std::string& name, const std::string& file,
                                 const FunctionSurroundings& surroundings);

/// <case>/postProcessing/<name>
std::filesystem::path outputFolder(const std::string& name, const FunctionSurroundings& surroundings);

/// The fields that a key lists, e.g. fields (U p).
/// \throws Error(input) at a field that a flow does not have, or a list of none.
std::vector<FlowQuantity> readQuantities(const Dictionary& dictionary, std::string_view key);

PressureForm pressureForm(const FunctionSurroundings& surroundings);

} // namespace isph
