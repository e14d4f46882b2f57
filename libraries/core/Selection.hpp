#pragma once

#include "core/Error.hpp"
#include "core/nearestWord.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isph
{

/// A word a dictionary may choose, with one line on what it means: what -list<Family> prints.
struct ListedWord
{
    std::string name;
    std::string summary;
};

/// Throws the error for a word that no variant has: the known ones, the nearest first.
[[noreturn]] inline void throwUnknownWord(std::string_view family, const Word& word, std::span<const std::string> known)
{
    throw Error(Fault::input, word.origin, "'" + word.text + "' is not a known " + std::string(family),
                "known are: " + listOfWords(word.text, known));
}

/// The variants that a dictionary word may choose, each of type Value: an enumerator, or a function that makes one.
///
/// A registry is a constant table, not a side effect: nothing registers itself, nothing is lost by a linker.
template<class Value>
class Selection
{
public:
    struct Variant
    {
        std::string_view name;    ///< the word in the dictionary
        std::string_view summary; ///< one line for -list<Family>
        Value value;
    };

    constexpr Selection(std::string_view family, std::span<const Variant> variants)
        : family_(family), variants_(variants)
    {
    }

    /// The variant that the word names.
    /// \throws Error(input) at word.origin, listing the known words.
    const Value& operator[](const Word& word) const
    {
        for (const Variant& variant : variants_)
        {
            if (variant.name == word.text) { return variant.value; }
        }
        throwUnknownWord(family_, word, names());
    }

    /// The word of an enumerator, for logs.
    std::string_view nameOf(const Value& value) const
        requires requires(const Value& v) { v == v; }
    {
        for (const Variant& variant : variants_)
        {
            if (variant.value == value) { return variant.name; }
        }
        return "?";
    }

    std::string_view family() const { return family_; }

    std::vector<std::string> names() const
    {
        std::vector<std::string> result;
        for (const Variant& variant : variants_) { result.emplace_back(variant.name); }
        return result;
    }

    std::vector<ListedWord> words() const
    {
        std::vector<ListedWord> result;
        for (const Variant& variant : variants_)
        {
            result.push_back({std::string(variant.name), std::string(variant.summary)});
        }
        return result;
    }

private:
    std::string_view family_;
    std::span<const Variant> variants_;
};

/// For static_assert on a table: no two variants share a word.
constexpr bool distinct(const auto& table)
{
    for (std::size_t a = 0; a < table.size(); ++a)
    {
        for (std::size_t b = a + 1; b < table.size(); ++b)
        {
            if (table[a].name == table[b].name) { return false; }
        }
    }
    return true;
}

} // namespace isph
