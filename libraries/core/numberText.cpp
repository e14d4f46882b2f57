#include "core/numberText.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace isph
{

std::string numberText(double value)
{
    std::array<char, 32> text{};
    // Whole numbers as one writes them: the shortest form of 100000 would be 1e+05.
    const bool whole = std::abs(value) < 1e15 && value == std::trunc(value) && !(value == 0 && std::signbit(value));
    const auto result = whole ? std::to_chars(text.data(), text.data() + text.size(), static_cast<long long>(value))
                              : std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), result.ptr};
}

} // namespace isph
