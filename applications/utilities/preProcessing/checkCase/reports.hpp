#pragma once

#include "CaseCheck.hpp"

#include "core/Json.hpp"
#include "core/Log.hpp"

namespace isph
{

/// The report for a reader.
void printReport(const CaseCheck& check, Log& log);

/// The report for machines: what slips keep out of sight is null.
Json jsonReport(const CaseCheck& check);

} // namespace isph
