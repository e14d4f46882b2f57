#include "caseFields/unitOf.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <string_view>

namespace isph
{

std::string unitOf(const std::array<int, 7>& dimensions)
{
    constexpr std::array<int, 7> pascal{1, -1, -2, 0, 0, 0, 0};
    if (dimensions == pascal) { return "Pa"; }

    constexpr std::array<std::string_view, 7> names{"kg", "m", "s", "K", "mol", "A", "cd"};
    std::string above;
    std::string below;
    for (std::size_t i = 0; i < names.size(); ++i)
    {
        const int exponent = std::abs(dimensions[i]);
        const std::string power = exponent > 1 ? fmt::format("{}{}", names[i], exponent) : std::string(names[i]);
        if (dimensions[i] > 0) { above += (above.empty() ? "" : " ") + power; }
        if (dimensions[i] < 0) { below += "/" + power; }
    }
    return (above.empty() ? "1" : above) + below;
}

} // namespace isph
