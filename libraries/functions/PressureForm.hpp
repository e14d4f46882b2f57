#pragma once

#include <string>

namespace isph
{

/// How the pressure is written; flows have it kinematic, with zero mean.
struct PressureForm
{
    double scale = 1;           ///< what kinematic pressure is multiplied by: 1, or rho for Pa
    std::string unit = "m2/s2"; ///< or "Pa"
    bool fixed = false;         ///< somewhere on the boundary: then its mean means something
};

} // namespace isph
