#pragma once

#include "core/Json.hpp"
#include "core/Log.hpp"

namespace isph
{

/// Prints what kernels, continuations and schemes in time bear, without any case.
void printSchemeTables(Log& log);

/// The same for machines.
Json schemeTables();

} // namespace isph
