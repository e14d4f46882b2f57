#pragma once

#include <cstdint>

namespace isph
{

/// While it lives, results below the least normal number, 2.2e-308, are zero, in this thread and in those that it
/// starts.
///
/// Processors take ten to a hundred times as long for such numbers, so that a flow which has long come to rest would be
/// marched several times slower than one that moves. Where the processor has no such mode nothing changes.
class FlushDenormals
{
public:
    FlushDenormals();
    ~FlushDenormals();
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

private:
    std::uint64_t before_; ///< control register of the floating-point unit
};

} // namespace isph
