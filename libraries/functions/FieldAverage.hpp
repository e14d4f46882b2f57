#pragma once

#include "functions/FlowFields.hpp"
#include "functions/FunctionObject.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isph
{

/// Time means and second moments of fields: <folder>/<time>/fields.h5 with UMean, UPrime2Mean.xx, .xy, ..., pMean,
/// pPrime2Mean.
///
/// A sample counts for the time since the one before, so that steps may differ in length; the first one only starts the
/// clock. Means and central moments are updated as weighted samples arrive (West 1979), without the cancellation of
/// <uu> - <u><u>. A run that starts from a time with averages goes on from them in the same bits.
class FieldAverage : public FunctionObject
{
public:
    /// \param folder <case>/postProcessing/<name>
    /// \param startTime name of the time that averages go on from, where the folder has it
    /// \param moments whether second moments are gathered besides the means
    FieldAverage(std::filesystem::path folder, std::string startTime, const Lattice& lattice, FlowFields fields,
                 std::vector<FlowQuantity> quantities, bool moments);

    void accumulate(const FlowAtTime& now) override;

    /// Writes the averages; nothing before there is time to average over.
    /// \throws Error(input) if they cannot be written; those of other times stay as they are.
    void execute(const FlowAtTime& now) override;

private:
    struct Average
    {
        std::string name;
        std::string unit;
        double duration = 0; ///< time averaged over [s]
        RealField mean;
        RealField moments; ///< upper triangle, row by row: xx xy xz yy yz zz
    };

    void begin();
    void restore(const std::filesystem::path& file);
    std::string momentName(const Average& average, int a, int b) const;

    std::filesystem::path folder_;
    std::string startTime_;
    Lattice lattice_;
    FlowFields fields_;
    std::vector<FlowQuantity> quantities_;
    bool moments_;
    std::vector<Average> averages_; ///< from the first sample on
    std::optional<double> last_;    ///< time of the last sample [s]
};

} // namespace isph
