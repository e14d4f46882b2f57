#include "transport/ScalarFunctions.hpp"

#include "fields/reductions.hpp"

#include <cmath>
#include <fmt/format.h>

namespace isph
{

namespace
{

std::vector<CsvColumn> errorColumns(const std::string& unit)
{
    return {{"time", "s"},   {"step"},        {"cpuTime", "s"},  {"wallTime", "s"},
            {"L1(T)", unit}, {"L2(T)", unit}, {"Linf(T)", unit}, {"relL2(T)"}};
}

std::vector<CsvColumn> probeColumns(std::size_t probes, const std::vector<std::string>& fields, const std::string& unit)
{
    std::vector<CsvColumn> columns{{"time", "s"}};
    for (std::size_t probe = 0; probe < probes; ++probe)
    {
        for (const std::string& field : fields)
        {
            if (field == "T") { columns.push_back({fmt::format("T({})", probe), unit}); }
            else
            {
                for (const char axis : {'x', 'y', 'z'})
                {
                    columns.push_back({fmt::format("{}.{}({})", field, axis, probe), "m/s"});
                }
            }
        }
    }
    return columns;
}

} // namespace

std::vector<NamedField> fieldsOf(const ScalarAtTime& now, const std::vector<std::string>& names,
                                 const std::string& unit)
{
    std::vector<NamedField> fields;
    for (const std::string& name : names)
    {
        fields.push_back(name == "T" ? NamedField{name, unit, now.T} : NamedField{name, "m/s", now.U});
    }
    return fields;
}

ScalarErrorNorms::ScalarErrorNorms(std::filesystem::path file, std::unique_ptr<const ExactField> exact,
                                   const std::string& unit)
    : exact_(std::move(exact)), csv_(std::move(file), errorColumns(unit))
{
}

void ScalarErrorNorms::execute(const ScalarAtTime& now)
{
    RealField error(1, now.T.size());
    exact_->evaluate(0, now.time, error[0]);
    const auto points = static_cast<double>(now.T.size());
    const double exactL2 = std::sqrt(sumOfSquares(error[0]) / points);
    for (std::size_t i = 0; i < now.T.size(); ++i) { error[0][i] = std::abs(now.T[0][i] - error[0][i]); }
    const double L1 = sum(error[0]) / points;
    const double L2 = std::sqrt(sumOfSquares(error[0]) / points);
    const double Linf = largestMagnitude(error[0]);
    const double relL2 = exactL2 > 0 ? L2 / exactL2 : L2;
    csv_.row(
        std::vector<double>{now.time, static_cast<double>(now.step), now.cpuTime, now.wallTime, L1, L2, Linf, relL2});
    last_ = {{"T", "L1", L1}, {"T", "L2", L2}, {"T", "Linf", Linf}, {"T", "relL2", relL2}};
}

ScalarProbes::ScalarProbes(std::filesystem::path file, const Lattice& lattice, Interpolator interpolator,
                           std::vector<std::string> fields, std::string unit)
    : lattice_(lattice),
      interpolator_(std::move(interpolator)),
      fields_(std::move(fields)),
      unit_(std::move(unit)),
      csv_(std::move(file), probeColumns(interpolator_.points(), fields_, unit_))
{
}

void ScalarProbes::execute(const ScalarAtTime& now)
{
    // Found column by column, written row by row: a probe's columns follow each other.
    std::vector<std::vector<double>> found;
    for (const NamedField& field : fieldsOf(now, fields_, unit_))
    {
        const bool vector = field.name == "U";
        int component = 0;
        for (int direction = 0; direction < (vector ? 3 : 1); ++direction)
        {
            std::vector<double>& values = found.emplace_back(interpolator_.points(), 0.0);
            if (vector && !lattice_.axis(direction).active()) { continue; }
            interpolator_(field.values[component++], values);
        }
    }
    std::vector<double> row{now.time};
    for (std::size_t probe = 0; probe < interpolator_.points(); ++probe)
    {
        for (const std::vector<double>& values : found) { row.push_back(values[probe]); }
    }
    csv_.row(row);
}

void ScalarSampleLines::execute(const ScalarAtTime& now)
{
    std::vector<std::string> names;
    for (const Word& word : samples_.fields()) { names.push_back(word.text); }
    writeSamples(samples_, fieldsOf(now, names, unit_), folder_ / now.name);
}

} // namespace isph
