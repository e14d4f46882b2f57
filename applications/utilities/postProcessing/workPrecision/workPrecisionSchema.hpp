#pragma once

#include "dictionary/Schema.hpp"

namespace isph
{

/// system/workPrecisionDict.
const Schema& workPrecisionSchema();

/// A number that a run leaves behind: `error`, or an entry of `collect`.
const Schema& quantitySchema();

/// A picture of `plot`.
const Schema& pictureSchema();

} // namespace isph
