#include "functions/FlowStatisticsFunction.hpp"

#include <string>
#include <utility>
#include <vector>

namespace isph
{

namespace
{

std::vector<CsvColumn> columnsOf(int dimensions, bool viscous)
{
    // In two dimensions integrals are per unit of length along the axis left out.
    const bool plane = dimensions == 2;
    const std::string enstrophyUnit = plane ? "m2/s2" : "m3/s2";
    std::vector<CsvColumn> columns{
        {"time", "s"}, {"step"}, {"kineticEnergy", plane ? "m4/s2" : "m5/s2"}, {"enstrophy", enstrophyUnit}};
    if (viscous) { columns.push_back({"enstrophyBudget", enstrophyUnit}); }
    columns.insert(columns.end(), {{"palinstrophy", plane ? "1/s2" : "m/s2"},
                                   {"maxSpeed", "m/s"},
                                   {"CoMean"},
                                   {"CoMax"},
                                   {"divL2", "1/s"},
                                   {"divLinf", "1/s"}});
    return columns;
}

} // namespace

FlowStatisticsFunction::FlowStatisticsFunction(std::filesystem::path file, const Lattice& lattice, const Fluid& fluid,
                                               const FlowBoundary* boundary)
    : lattice_(lattice),
      fluid_(fluid),
      boundary_(boundary),
      csv_(std::move(file), columnsOf(lattice.dimensions(), fluid.nu > 0))
{
    if (fluid.nu > 0) { budget_.emplace(fluid.nu); }
}

void FlowStatisticsFunction::execute(const FlowAtTime& now)
{
    if (!diagnostics_)
    {
        diagnostics_.emplace(lattice_, fluid_.nu, boundary_);
        if (fluid_.bodyForce) { force_ = RealField(lattice_.dimensions(), lattice_.points()); }
    }
    if (fluid_.bodyForce) { fluid_.bodyForce->evaluate(now.time, force_); }
    const FlowStatistics flow = diagnostics_->evaluate(now.flow, fluid_.bodyForce ? &force_ : nullptr, now.time);
    const StepRates rates = now.flow.rates();

    std::vector<double> row{now.time, static_cast<double>(now.step), flow.kineticEnergy, flow.enstrophy};
    if (budget_)
    {
        const double power = flow.forcePower + flow.boundaryPower;
        row.push_back(budget_->next(now.time, flow.kineticEnergy, power, flow.enstrophy));
    }
    row.insert(row.end(), {flow.palinstrophy, flow.maxSpeed, rates.meanCourant * now.dt, rates.courant * now.dt,
                           flow.divL2, flow.divLinf});
    csv_.row(row);
}

} // namespace isph
