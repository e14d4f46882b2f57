#include "flow/BoundedFlow.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string_view>

namespace isph
{

namespace
{

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr std::uint64_t fnvStart = 0xcbf29ce484222325U;

/// FNV-1a of the bits of values.
void addBits(std::span<const double> values, std::uint64_t& hash)
{
    for (const double value : values)
    {
        hash ^= std::bit_cast<std::uint64_t>(value);
        hash *= 0x100000001b3U;
    }
}

std::string hexadecimal(std::uint64_t number)
{
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4) { text += digits[(number >> shift) & 0xfU]; }
    return text;
}

} // namespace

std::string BoundedFlow::probe()
{
    std::uint64_t hash = fnvStart;
    std::uint64_t state = 1;
    const auto refill = [&state](std::span<double> values)
    {
        for (double& value : values)
        {
            state = state * 6364136223846793005U + 1442695040888963407U;
            value = static_cast<double>(state >> 11U) * 0x1p-53 - 0.5;
        }
    };
    refill(source_[0]);
    for (ContinuedDerivative& along : derivatives_)
    {
        along(source_[0], scratch_[0], {});
        addBits(scratch_[0], hash);
    }
    for (ExtendedOperators& operators : extended_)
    {
        operators.take(source_[0]);
        for (int d = 0; d < dimensions_; ++d)
        {
            operators.derivative(d, scratch_[0]);
            addBits(scratch_[0], hash);
        }
    }
    for (ContinuedFilter& filter : filters_)
    {
        refill(scratch_[0]);
        filter(scratch_[0], {});
        addBits(scratch_[0], hash);
    }
    WallData walls;
    for (int d = 0; d < dimensions_; ++d)
    {
        if (!lattice_.activeAxis(d).periodic())
        {
            walls[at(lattice_.direction(d))] = {slopes_[at(d)][0], slopes_[at(d)][1]};
        }
    }
    if (direct_) { direct_->solve(0, -1, source_[0], walls, phi_[0]); }
    else if (mirrored_) { mirrored_->solve(source_, walls, phi_); }
    else if (poisson_) { poisson_->solve(source_, walls, phi_); }
    addBits(phi_[0], hash);
    std::ranges::fill(phi_[0], 0.0);
    return hexadecimal(hash);
}

} // namespace isph
