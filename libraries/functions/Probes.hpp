#pragma once

#include "functions/CsvOutput.hpp"
#include "functions/FlowFields.hpp"
#include "functions/FunctionObject.hpp"
#include "sampling/Interpolator.hpp"

#include <filesystem>
#include <vector>

namespace isph
{

/// probes.csv: values at points over time, a row an execution: "time [s]", then for each probe its fields, "U.x(0)
/// [m/s]", ..., "p(0) [m2/s2]", "U.x(1) [m/s]". A vector has three columns, zero along an axis that is left out.
class Probes : public FunctionObject
{
public:
    Probes(std::filesystem::path file, const Lattice& lattice, Interpolator interpolator, FlowFields fields,
           std::vector<FlowQuantity> quantities);

    void execute(const FlowAtTime& now) override;

private:
    std::vector<CsvColumn> columns() const;

    Lattice lattice_;
    Interpolator interpolator_;
    FlowFields fields_;
    std::vector<FlowQuantity> quantities_;
    CsvOutput csv_;
};

} // namespace isph
