#include "lattice/fastCounts.hpp"

#include <array>
#include <cassert>

namespace isph
{

namespace
{

/// n without its factors 2, 3, 5 and 7.
long withoutSmallFactors(long n)
{
    for (const long factor : std::array{2, 3, 5, 7})
    {
        while (n % factor == 0) { n /= factor; }
    }
    return n;
}

} // namespace

bool isFastCount(long n)
{
    if (n < 1) { return false; }
    const long rest = withoutSmallFactors(n);
    return rest == 1 || rest == 11 || rest == 13;
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

bool isSmoothCount(long n) { return n >= 1 && withoutSmallFactors(n) == 1; }

long smoothCountBelow(long n)
{
    assert(n >= 1);
    while (!isSmoothCount(n)) { --n; }
    return n;
}

long smoothCountAbove(long n)
{
    assert(n >= 1);
    while (!isSmoothCount(n)) { ++n; }
    return n;
}

long continuedCount(long n)
{
    constexpr long leastNewPoints = 25; // fewer cost digits
    const long least = n + leastNewPoints;
    return 4 * smoothCountAbove((least + 3) / 4);
}

} // namespace isph
