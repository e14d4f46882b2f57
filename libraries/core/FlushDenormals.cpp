#include "core/FlushDenormals.hpp"

#if defined(__SSE2__)
#include <pmmintrin.h>
#endif

namespace isph
{

namespace
{

#if defined(__SSE2__)

constexpr std::uint64_t flush = _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON;
std::uint64_t controlRegister() { return _mm_getcsr(); }
void setControlRegister(std::uint64_t value) { _mm_setcsr(static_cast<unsigned>(value)); }

#elif defined(__aarch64__)

constexpr std::uint64_t flush = std::uint64_t{1} << 24;
std::uint64_t controlRegister()
{
    std::uint64_t value = 0;
    asm volatile("mrs %0, fpcr" : "=r"(value));
    return value;
}
void setControlRegister(std::uint64_t value) { asm volatile("msr fpcr, %0" : : "r"(value)); }

#else

constexpr std::uint64_t flush = 0;
std::uint64_t controlRegister() { return 0; }
void setControlRegister(std::uint64_t) {}

#endif

} // namespace

FlushDenormals::FlushDenormals() : before_(controlRegister()) { setControlRegister(before_ | flush); }

FlushDenormals::~FlushDenormals() { setControlRegister(before_); }

} // namespace isph
