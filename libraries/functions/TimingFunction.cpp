#include "functions/TimingFunction.hpp"

#include <string>
#include <utility>
#include <vector>

namespace isph
{

namespace
{

std::vector<CsvColumn> columns()
{
    std::vector<CsvColumn> columns{{"time", "s"}, {"step"}};
    for (const std::string_view phase : phaseNames) { columns.push_back({std::string(phase), "s"}); }
    columns.insert(columns.end(), {{"other", "s"}, {"total", "s"}});
    return columns;
}

} // namespace

TimingFunction::TimingFunction(std::filesystem::path file) : csv_(std::move(file), columns()) {}

void TimingFunction::execute(const FlowAtTime& now)
{
    std::vector<double> row{now.time, static_cast<double>(now.step)};
    for (std::size_t phase = 0; phase < phaseNames.size(); ++phase)
    {
        row.push_back(now.timings.seconds(static_cast<Phase>(phase)));
    }
    row.insert(row.end(), {now.timings.other(), now.timings.total()});
    csv_.row(row);
}

} // namespace isph
