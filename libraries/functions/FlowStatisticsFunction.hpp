#pragma once

#include "flow/flowDiagnostics.hpp"
#include "functions/CsvOutput.hpp"
#include "functions/EnstrophyBudget.hpp"
#include "functions/FunctionObject.hpp"

#include <filesystem>
#include <optional>

namespace isph
{

/// flow.csv: kinetic energy, enstrophy and palinstrophy of the box, the enstrophy its energy budget tells of (left out
/// where nu is 0), largest speed, Courant numbers of the last step, norms of the divergence.
class FlowStatisticsFunction : public FunctionObject
{
public:
    /// \param fluid must outlive this function
    /// \param boundary of the flow, which must outlive this function too, or null (see FlowDiagnostics)
    FlowStatisticsFunction(std::filesystem::path file, const Lattice& lattice, const Fluid& fluid,
                           const FlowBoundary* boundary = nullptr);

    void execute(const FlowAtTime& now) override;

private:
    Lattice lattice_;
    const Fluid& fluid_;
    const FlowBoundary* boundary_;
    CsvOutput csv_;
    std::optional<EnstrophyBudget> budget_;
    std::optional<FlowDiagnostics> diagnostics_; ///< from the first execution on
    RealField force_;
};

} // namespace isph
