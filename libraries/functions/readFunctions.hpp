#pragma once

#include "dictionary/Dictionary.hpp"
#include "dictionary/Schema.hpp"
#include "functions/FunctionObject.hpp"
#include "functions/functionSelection.hpp"
#include "functions/PressureForm.hpp"

#include <filesystem>
#include <memory>
#include <string>
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

/// <case>/postProcessing/<name>/<startTime>/<file>
std::filesystem::path outputFile(const std::string& name, const std::string& file,
                                 const FunctionSurroundings& surroundings);

PressureForm pressureForm(const FunctionSurroundings& surroundings);

} // namespace isph
