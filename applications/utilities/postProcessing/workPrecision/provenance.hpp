#pragma once

#include "Sweep.hpp"

namespace isph
{

/// Where results come from: suite version, commit where git knows it, compiler, processor, cores, threads, jobs, date
/// and command. No name of the machine.
void writeProvenance(const Sweep& sweep, const std::string& command, const std::filesystem::path& file);

} // namespace isph
