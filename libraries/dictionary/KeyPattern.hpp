#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace isph
{

/// A key in quotes: a regular expression (POSIX extended, as in OpenFOAM) that must match a whole name.
class KeyPattern
{
public:
    /// Why a text cannot be a pattern, or nothing if it can. Patterns that would cost a match much time or memory
    /// (back references, repeats of repeats) are not allowed.
    static std::optional<std::string> fault(const std::string& text);

    /// Requires a text without fault.
    explicit KeyPattern(const std::string& text);
    ~KeyPattern();
    KeyPattern(const KeyPattern&) = delete;
    KeyPattern& operator=(const KeyPattern&) = delete;

    bool matches(std::string_view name) const;

private:
    struct Compiled;
    std::unique_ptr<Compiled> compiled_;
};

} // namespace isph
