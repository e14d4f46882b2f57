#pragma once

#include "core/CommandLine.hpp"

#include <vector>

namespace isph
{

/// The tables behind -listKernels and its like: the words that the dictionaries of a flow may choose.
std::vector<Listing> flowListings();

} // namespace isph
