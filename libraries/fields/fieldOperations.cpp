#include "fields/fieldOperations.hpp"

#include <algorithm>

namespace isph
{

void copyInto(const RealField& from, RealField& to)
{
    for (int c = 0; c < from.components(); ++c) { std::ranges::copy(from[c], to[c].begin()); }
}

void addScaled(double factor, const RealField& b, RealField& a)
{
    for (int c = 0; c < b.components(); ++c)
    {
        std::ranges::transform(a[c], b[c], a[c].begin(), [factor](double x, double y) { return x + factor * y; });
    }
}

} // namespace isph
