#pragma once

#include "Results.hpp"

namespace isph
{

/// What became of the pictures of a sweep, by name.
struct Drawing
{
    bool gnuplot = false; ///< is installed
    std::vector<std::string> drawn;
    std::vector<std::string> empty; ///< without a point; files of an earlier sweep are removed
};

/// Draws the pictures of a sweep as SVG and PNG, beside the script that gnuplot ran. Where gnuplot is not installed
/// only the scripts are written. \throws Error(input) if gnuplot fails.
Drawing writePictures(const Results& results, const std::filesystem::path& folder);

} // namespace isph
