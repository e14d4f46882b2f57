#pragma once

#include "core/Selection.hpp"

#include <filesystem>
#include <string>

namespace isph
{

/// How times are written as names.
enum class TimeFormat
{
    general,
    fixed,
    scientific
};
const Selection<TimeFormat>& timeFormats();

/// The name of a time, with as many digits beyond the precision as it takes to read back within a tenth of a step:
/// no two steps of a run have the same name.
/// \param step length of the step [s] that led there; 0: all digits that the precision does not show are round-off
std::string timeName(double time, double step, TimeFormat format = TimeFormat::general, int precision = 6);

/// timeName with still more digits where a folder of that name holds another time (its uniform/time says so).
std::string unusedTimeName(const std::filesystem::path& caseDirectory, double time, double step, TimeFormat format,
                           int precision);

} // namespace isph
