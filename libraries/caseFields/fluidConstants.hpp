#pragma once

#include "case/Case.hpp"

#include <string>
#include <utility>
#include <vector>

namespace isph
{

/// nu, rho and DT of constant/transportProperties, as far as they are given there: constants of every expression.
std::vector<std::pair<std::string, double>> fluidConstants(const Case& theCase);

} // namespace isph
