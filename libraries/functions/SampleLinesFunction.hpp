#pragma once

#include "functions/FlowFields.hpp"
#include "functions/FunctionObject.hpp"
#include "sampling/SampleSet.hpp"

#include <filesystem>
#include <vector>

namespace isph
{

/// The lines and planes of system/sampleDict at run time: <folder>/<time>/<line>.csv, as the program sampleLines
/// writes.
class SampleLinesFunction : public FunctionObject
{
public:
    /// \param folder <case>/postProcessing/<name>
    /// \throws Error(input) at the name of a field that a flow does not have.
    SampleLinesFunction(std::filesystem::path folder, SampleSet samples, FlowFields fields);

    void execute(const FlowAtTime& now) override;

private:
    std::filesystem::path folder_;
    SampleSet samples_;
    FlowFields fields_;
    std::vector<FlowQuantity> quantities_;
};

} // namespace isph
