#pragma once

#include "fits.hpp"
#include "RunRecord.hpp"
#include "Sweep.hpp"

#include <map>

namespace isph
{

/// The table of a sweep: one row a run, columns by name.
class Results
{
public:
    /// Collects the quantities of every run that is done.
    /// \throws Error(input) if one cannot be got.
    Results(const Sweep& sweep, const std::vector<RunRecord>& records, const std::filesystem::path& caseDirectory);

    /// A numeric column, not-a-number where a run has no such number.
    const std::vector<double>& column(const std::string& name) const { return columns_.at(name); }

    /// Values of a column along a line, in the order of its resolutions, of the runs that are done.
    std::vector<double> along(std::size_t line, const std::string& name) const;

    /// The power law that y follows with x along a line, within the range of `fit`.
    std::optional<Slope> slope(std::size_t line, const std::string& x, const std::string& y) const;

    /// The order of accuracy of a measure along a line: positive where the error falls as the runs become larger.
    std::optional<Slope> order(std::size_t line, const std::string& measure) const;

    /// A measure against the processor time: lines, then the external series that have both.
    std::vector<CostCurve> curves(const std::string& measure) const;

    const Sweep& sweep() const { return sweep_; }
    const std::vector<RunRecord>& records() const { return records_; }

private:
    void collect(std::size_t run, const std::filesystem::path& caseDirectory);

    const Sweep& sweep_;
    const std::vector<RunRecord>& records_;
    std::map<std::string, std::vector<double>> columns_;
};

/// A slope or an order for people: "3.96", and never "-0.00".
std::string slopeText(double slope);

/// The files workPrecision.csv, slopes.csv and cheapest.csv.
/// \throws Error(input) if the machine refuses.
void writeTables(const Results& results, const std::filesystem::path& folder);

/// The same for people: every run, the slopes, and the cheapest variants.
std::string runsText(const Results& results);
std::string slopesText(const Results& results);
std::string cheapestText(const Results& results);

} // namespace isph
