#pragma once

#include "Results.hpp"

namespace isph
{

/// The commands of gnuplot that draw a picture, data included; ready to be run by hand in the folder of the picture.
std::string pictureScript(const Results& results, const Picture& picture);

/// Draws the pictures of a sweep as SVG and PNG, beside the script that gnuplot ran. False where gnuplot is not
/// installed: then only the scripts are written. \throws Error(input) if gnuplot fails.
bool writePictures(const Results& results, const std::filesystem::path& folder);

} // namespace isph
