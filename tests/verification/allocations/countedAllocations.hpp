#pragma once

namespace isph::test
{

/// Calls of malloc and its kin made while counting, by our code or what it calls (operator new, muParser). Not counted
/// is what two libraries do by themselves: OpenMP keeps a record of the team of each parallel region, FFTW a buffer in
/// some of its plans.
class CountedAllocations
{
public:
    CountedAllocations();
    ~CountedAllocations();
    CountedAllocations(const CountedAllocations&) = delete;
    CountedAllocations& operator=(const CountedAllocations&) = delete;

    long count() const;
};

} // namespace isph::test
