#include "functions/Probes.hpp"

#include <fmt/format.h>
#include <utility>

namespace isph
{

Probes::Probes(std::filesystem::path file, const Lattice& lattice, Interpolator interpolator, FlowFields fields,
               std::vector<FlowQuantity> quantities)
    : lattice_(lattice),
      interpolator_(std::move(interpolator)),
      fields_(std::move(fields)),
      quantities_(std::move(quantities)),
      csv_(std::move(file), columns())
{
}

std::vector<CsvColumn> Probes::columns() const
{
    std::vector<CsvColumn> columns{{"time", "s"}};
    for (std::size_t probe = 0; probe < interpolator_.points(); ++probe)
    {
        for (const FlowQuantity quantity : quantities_)
        {
            const auto name = flowQuantities().nameOf(quantity);
            if (fields_.components(quantity) == 1)
            {
                columns.push_back({fmt::format("{}({})", name, probe), fields_.unit(quantity)});
                continue;
            }
            for (const char axis : {'x', 'y', 'z'})
            {
                columns.push_back({fmt::format("{}.{}({})", name, axis, probe), fields_.unit(quantity)});
            }
        }
    }
    return columns;
}

void Probes::execute(const FlowAtTime& now)
{
    // Found column by column, written row by row: a probe's columns follow each other.
    std::vector<std::vector<double>> found;
    for (const NamedField& field : fields_.at(now, quantities_))
    {
        const bool vector = field.values.components() > 1;
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

} // namespace isph
