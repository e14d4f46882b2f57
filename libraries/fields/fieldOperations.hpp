#pragma once

#include "fields/Field.hpp"

namespace isph
{

/// to = from, fields of the same shape.
void copyInto(const RealField& from, RealField& to);

/// a += factor b, every component of b.
void addScaled(double factor, const RealField& b, RealField& a);

} // namespace isph
