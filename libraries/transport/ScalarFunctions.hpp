#pragma once

#include "core/Timings.hpp"
#include "functions/CsvOutput.hpp"
#include "functions/ErrorNorms.hpp"
#include "functions/ScheduledFunctions.hpp"
#include "sampling/Interpolator.hpp"
#include "sampling/SampleSet.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace isph
{

/// A scalar at the end of a step (or at the start of a run), as functions see it.
struct ScalarAtTime
{
    const RealField& T;
    const RealField& U; ///< what carries it [m/s]
    double time;        ///< [s]
    std::string name;   ///< of the time, e.g. "0.25"
    long step;          ///< index of the step
    double cpuTime;     ///< [s], of all runs so far
    double wallTime;    ///< [s]
};

using ScalarFunction = FunctionOn<ScalarAtTime>;
using ScalarFunctions = ScheduledFunctions<ScalarAtTime>;

/// The fields that can be sampled: T and U, by name, in the order asked for.
std::vector<NamedField> fieldsOf(const ScalarAtTime& now, const std::vector<std::string>& names,
                                 const std::string& unit);

/// errors.csv: norms of the difference of T to an exact solution, over the points of the lattice.
class ScalarErrorNorms : public ScalarFunction
{
public:
    /// \param unit of T
    ScalarErrorNorms(std::filesystem::path file, std::unique_ptr<const ExactField> exact, const std::string& unit);

    void execute(const ScalarAtTime& now) override;
    std::vector<ErrorNorm> errors() const override { return last_; }

private:
    std::unique_ptr<const ExactField> exact_;
    CsvOutput csv_;
    std::vector<ErrorNorm> last_;
};

/// probes.csv: T and U at points over time, columns as those of Probes.
class ScalarProbes : public ScalarFunction
{
public:
    ScalarProbes(std::filesystem::path file, const Lattice& lattice, Interpolator interpolator,
                 std::vector<std::string> fields, std::string unit);

    void execute(const ScalarAtTime& now) override;

private:
    Lattice lattice_;
    Interpolator interpolator_;
    std::vector<std::string> fields_;
    std::string unit_;
    CsvOutput csv_;
};

/// The lines and planes of system/sampleDict at run time.
class ScalarSampleLines : public ScalarFunction
{
public:
    /// \param folder <case>/postProcessing/<name>
    ScalarSampleLines(std::filesystem::path folder, SampleSet samples, std::string unit)
        : folder_(std::move(folder)), samples_(std::move(samples)), unit_(std::move(unit))
    {
    }

    void execute(const ScalarAtTime& now) override;

private:
    std::filesystem::path folder_;
    SampleSet samples_;
    std::string unit_;
};

} // namespace isph
