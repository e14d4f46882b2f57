// The allocation functions of the C library, counted. operator new in all its forms ends here, and so does what
// libraries allocate by themselves.

#include "countedAllocations.hpp"

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <dlfcn.h>

extern "C"
{
    void* __libc_malloc(std::size_t size);
    void* __libc_calloc(std::size_t count, std::size_t size);
    void* __libc_realloc(void* old, std::size_t size);
    void* __libc_memalign(std::size_t alignment, std::size_t size);
}

namespace
{

std::atomic<bool> counting{false};
std::atomic<long> allocations{0};

void count(void* caller)
{
    if (!counting.load(std::memory_order_relaxed)) { return; }
    Dl_info place{};
    const bool known = dladdr(caller, &place) != 0;
    for (const char* library : {"libgomp", "libfftw3"})
    {
        if (known && std::strstr(place.dli_fname, library) != nullptr) { return; }
    }
    allocations.fetch_add(1, std::memory_order_relaxed);
}

} // namespace

extern "C"
{
    void* malloc(std::size_t size) noexcept
    {
        count(__builtin_return_address(0));
        return __libc_malloc(size);
    }
    void* calloc(std::size_t number, std::size_t size) noexcept
    {
        count(__builtin_return_address(0));
        return __libc_calloc(number, size);
    }
    void* realloc(void* old, std::size_t size) noexcept
    {
        count(__builtin_return_address(0));
        return __libc_realloc(old, size);
    }
    void* memalign(std::size_t alignment, std::size_t size) noexcept
    {
        count(__builtin_return_address(0));
        return __libc_memalign(alignment, size);
    }
    void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept
    {
        count(__builtin_return_address(0));
        return __libc_memalign(alignment, size);
    }
    int posix_memalign(void** result, std::size_t alignment, std::size_t size) noexcept
    {
        count(__builtin_return_address(0));
        void* memory = __libc_memalign(alignment, size);
        if (memory == nullptr) { return ENOMEM; }
        *result = memory;
        return 0;
    }
}

namespace isph::test
{

CountedAllocations::CountedAllocations()
{
    allocations = 0;
    counting = true;
}

CountedAllocations::~CountedAllocations() { counting = false; }

long CountedAllocations::count() const { return allocations; }

} // namespace isph::test
