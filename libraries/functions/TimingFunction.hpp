#pragma once

#include "functions/CsvOutput.hpp"
#include "functions/FunctionObject.hpp"

#include <filesystem>

namespace isph
{

/// timing.csv: wall-clock seconds of this run so far by phase ("transforms [s]", ...), what no phase claims ("other
/// [s]") and their sum ("total [s]"), with the index of the step: differences of rows are the cost of the steps
/// between. The functions that run at this very time still count as other.
class TimingFunction : public FunctionObject
{
public:
    explicit TimingFunction(std::filesystem::path file);

    void execute(const FlowAtTime& now) override;

private:
    CsvOutput csv_;
};

} // namespace isph
