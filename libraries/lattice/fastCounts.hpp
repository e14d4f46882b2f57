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

} // namespace isph
