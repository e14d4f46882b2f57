#pragma once

#include "core/Timings.hpp"

namespace isph::test
{

/// Seconds of processor time, of all threads, that a piece of work takes.
template<class Work>
double processorSecondsOf(Work work)
{
    const double start = cpuSeconds();
    work();
    return cpuSeconds() - start;
}

} // namespace isph::test
