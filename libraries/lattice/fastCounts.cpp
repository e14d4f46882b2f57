#include "lattice/fastCounts.hpp"

#include <array>
#include <cassert>

namespace isph
{

bool isFastCount(long n)
{
    if (n < 1) { return false; }
    for (const long factor : std::array{2, 3, 5, 7})
    {
        while (n % factor == 0) { n /= factor; }
    }
    return n == 1 || n == 11 || n == 13;
}

long fastCountBelow(long n)
{
    assert(n >= 1);
    while (!isFastCount(n)) { --n; }
    return n;
}

long fastCountAbove(long n)
{
    assert(n >= 1);
    while (!isFastCount(n)) { ++n; }
    return n;
}

} // namespace isph
