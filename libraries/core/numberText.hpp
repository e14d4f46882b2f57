#pragma once

#include <string>

namespace isph
{

/// A number in the shortest form that reads back as the same bits: "0.1", "1600", "1e-05", "-0", "nan", "inf".
std::string numberText(double value);

} // namespace isph
