#pragma once

#include <array>
#include <string>

namespace isph
{

/// "m/s", "m2/s2", "Pa", ... of seven exponents (kg m s K mol A cd); "1" without dimensions.
std::string unitOf(const std::array<int, 7>& dimensions);

} // namespace isph
