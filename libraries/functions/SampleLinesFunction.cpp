#include "functions/SampleLinesFunction.hpp"

#include <utility>

namespace isph
{

SampleLinesFunction::SampleLinesFunction(std::filesystem::path folder, SampleSet samples, FlowFields fields)
    : folder_(std::move(folder)), samples_(std::move(samples)), fields_(std::move(fields))
{
    for (const Word& word : samples_.fields()) { quantities_.push_back(flowQuantities()[word]); }
}

void SampleLinesFunction::execute(const FlowAtTime& now)
{
    writeSamples(samples_, fields_.at(now, quantities_), folder_ / now.name);
}

} // namespace isph
