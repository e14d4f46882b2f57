#pragma once

#include "core/CommandLine.hpp"
#include "core/Log.hpp"

namespace isph
{

/// isphFoam -postProcess: runs the functions of controlDict on the times that are already written.
void postProcess(const CommandLine& line, Log& log);

} // namespace isph
