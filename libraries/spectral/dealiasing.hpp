#pragma once

#include "core/Selection.hpp"
#include "lattice/Lattice.hpp"

#include <array>
#include <cstddef>

namespace isph
{

enum class Dealiasing
{
    none,
    twoThirds, ///< keep |m| < n/3 on each axis: quadratic products then alias onto modes that are dropped
};

const Selection<Dealiasing>& dealiasings();

/// The modes that a flow keeps.
class RetainedModes
{
public:
    RetainedModes(const Lattice& lattice, Dealiasing dealiasing);

    /// Modes kept at the start of a kept row.
    std::size_t length() const { return length_; }

    /// Whether index i on axis d (1 or 2) is kept.
    bool index(int d, std::size_t i) const
    {
        const auto axis = static_cast<std::size_t>(d);
        return i <= largest_[axis] || count_[axis] - i <= largest_[axis];
    }

private:
    std::array<std::size_t, 3> count_{1, 1, 1};
    std::array<std::size_t, 3> largest_{0, 0, 0}; ///< largest |m| that is kept
    std::size_t length_;
};

} // namespace isph
