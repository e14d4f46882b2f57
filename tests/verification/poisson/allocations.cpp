#include "allocations.hpp"

#include <cstdlib>
#include <new>

namespace
{

long calls = 0;

} // namespace

long isph::test::allocations() { return calls; }

void* operator new(std::size_t size)
{
    ++calls;
    if (void* p = std::malloc(size)) { return p; }
    throw std::bad_alloc();
}

void* operator new(std::size_t size, std::align_val_t alignment)
{
    ++calls;
    const auto a = static_cast<std::size_t>(alignment);
    if (void* p = std::aligned_alloc(a, (size + a - 1) / a * a)) { return p; }
    throw std::bad_alloc();
}

void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
