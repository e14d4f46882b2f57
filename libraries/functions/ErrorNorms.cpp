#include "functions/ErrorNorms.hpp"

#include "fields/reductions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isph
{

namespace
{

std::vector<CsvColumn> columnsOf(const ExactFlow& exact, const PressureForm& pressure)
{
    std::vector<CsvColumn> columns{{"time", "s"}, {"step"}, {"cpuTime", "s"}, {"wallTime", "s"}};
    const auto add = [&columns](const std::string& field, const std::string& unit)
    {
        for (const char* norm : {"L1", "L2", "Linf"})
        {
            columns.push_back({std::string(norm) + "(" + field + ")", unit});
        }
        columns.push_back({"relL2(" + field + ")"});
    };
    if (exact.U) { add("U", "m/s"); }
    if (exact.p) { add("p", pressure.unit); }
    return columns;
}

double mean(std::span<const double> values) { return sum(values) / static_cast<double>(values.size()); }

double rootMeanSquare(std::span<const double> values)
{
    return std::sqrt(sumOfSquares(values) / static_cast<double>(values.size()));
}

} // namespace

ErrorNorms::ErrorNorms(std::filesystem::path file, const Lattice& lattice, ExactFlow exact, PressureForm pressure)
    : lattice_(lattice),
      exact_(std::move(exact)),
      pressure_(std::move(pressure)),
      csv_(std::move(file), columnsOf(exact_, pressure_))
{
}

void ErrorNorms::execute(const FlowAtTime& now)
{
    if (error_.components() == 0)
    {
        exactValues_ = RealField(1, lattice_.points());
        error_ = RealField(1, lattice_.points());
    }
    last_.clear();
    std::vector<double> row{now.time, static_cast<double>(now.step), now.cpuTime, now.wallTime};
    const auto add = [&](const std::string& field, const FieldNorms& norms)
    {
        row.insert(row.end(), {norms.L1, norms.L2, norms.Linf, norms.relL2});
        last_.insert(last_.end(), {{field, "L1", norms.L1},
                                   {field, "L2", norms.L2},
                                   {field, "Linf", norms.Linf},
                                   {field, "relL2", norms.relL2}});
    };
    if (exact_.U) { add("U", velocityNorms(now.flow.velocity(), now.time)); }
    if (exact_.p) { add("p", pressureNorms(now.flow.pressure(now.time), now.time)); }
    csv_.row(row);
}

std::vector<ErrorNorm> ErrorNorms::errors() const { return last_; }

FieldNorms ErrorNorms::velocityNorms(const RealField& velocity, double t)
{
    const std::span<double> error = error_[0];
    const std::span<double> exact = exactValues_[0];
    std::ranges::fill(error, 0.0);
    double exactSquares = 0;
    int component = 0;
    for (int direction = 0; direction < 3; ++direction)
    {
        exact_.U->evaluate(direction, t, exact);
        exactSquares += sumOfSquares(exact);
        if (!lattice_.axis(direction).active())
        {
            for (std::size_t n = 0; n < error.size(); ++n) { error[n] += exact[n] * exact[n]; }
            continue;
        }
        const std::span<const double> u = velocity[component++];
        for (std::size_t n = 0; n < error.size(); ++n) { error[n] += (u[n] - exact[n]) * (u[n] - exact[n]); }
    }
    for (double& value : error) { value = std::sqrt(value); }
    return normsOfError(std::sqrt(exactSquares / static_cast<double>(error.size())));
}

FieldNorms ErrorNorms::pressureNorms(const RealField& pressure, double t)
{
    const std::span<double> error = error_[0];
    const std::span<double> exact = exactValues_[0];
    const std::span<const double> p = pressure[0];
    exact_.p->evaluate(0, t, exact);
    const double exactMean = pressure_.fixed ? 0 : mean(exact);
    const double shift = pressure_.fixed ? 0 : pressure_.scale * mean(p);
    for (std::size_t n = 0; n < error.size(); ++n)
    {
        exact[n] -= exactMean;
        error[n] = std::abs(pressure_.scale * p[n] - shift - exact[n]);
    }
    // What is left of a constant after taking out its mean is round-off, and nothing to measure an error by.
    constexpr double roundOff = 1e-13;
    const double exactL2 = rootMeanSquare(exact);
    return normsOfError(exactL2 > roundOff * std::abs(exactMean) ? exactL2 : 0);
}

FieldNorms ErrorNorms::normsOfError(double exactL2) const
{
    const std::span<const double> error = error_[0];
    const double L2 = rootMeanSquare(error);
    return {mean(error), L2, largestMagnitude(error), exactL2 > 0 ? L2 / exactL2 : L2};
}

} // namespace isph
