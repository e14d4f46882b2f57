#pragma once

#include "Sweep.hpp"

namespace isph
{

/// Sets a run's entries in the dictionaries of its folder.
/// \throws Error(input) naming the entry of system/workPrecisionDict if a file is missing or an entry cannot be set.
void applySettings(const Run& run, const std::filesystem::path& folder);

/// What applySettings would refuse, told before any run is made; and quantities of functions and lines that the run's
/// dictionaries do not have.
/// \throws Error(input) as above.
void checkRun(const Run& run, const Sweep& sweep);

/// Everything that a run is made from, as a hash: settings, commands, and the files of the base case.
std::string settingsHash(const Run& run, const Sweep& sweep, const std::string& baseFiles);

/// Hash of the input files of the base case: 0, constant, system (without workPrecisionDict), and files of the case
/// that the commands name.
std::string baseHash(const Sweep& sweep);

/// A command line cut into words; quotes of both kinds hold words together.
std::vector<std::string> wordsOf(const std::string& command);

} // namespace isph
