#pragma once

namespace isph
{

/// Whether a transform of this length is fast: a product of 2, 3, 5 and 7, with at most one factor 11 or 13. Other
/// lengths work, several times slower (FFTW manual, "Real-data DFTs").
bool isFastCount(long n);

/// The nearest fast lengths not above and not below n.
/// \param n at least 1
long fastCountBelow(long n);
long fastCountAbove(long n);

/// Whether n is a product of 2, 3, 5 and 7: fast also for the transforms between walls, of n intervals.
bool isSmoothCount(long n);

/// The nearest such numbers not above and not below n.
/// \param n at least 1
long smoothCountBelow(long n);
long smoothCountAbove(long n);

/// Length of a line of n points between walls with its new points, where schemes leave their number open: at least 25,
/// more until the length is four times a product of 2, 3, 5 and 7. A real transform of odd length takes 2.5 to 3 times
/// as long a point, one of twice an odd length 1.3 times (docs/theory/continuation.md).
long continuedCount(long n);

} // namespace isph
