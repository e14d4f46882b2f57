#pragma once

#include "dictionary/Dictionary.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace isph
{

/// What one key of a dictionary may hold.
struct Key
{
    enum class Type
    {
        number,      ///< a finite number
        integer,     ///< a whole number
        flag,        ///< yes/no, on/off, true/false
        word,        ///< one of `words` if those are given
        text,        ///< a word or a quoted string
        vector,      ///< ( 1 2 3 )
        list,        ///< ( ... )
        dimensioned, ///< a number, perhaps behind dimensions
        function,    ///< uniform ... | expression ... | table ... (SpaceTimeFunction)
        dictionary,  ///< a sub-dictionary with `keys`
        any,         ///< checked by its reader
    };

    std::string name; ///< "*" stands for any name (patches, functions, lines)
    Type type = Type::any;
    std::string unit = "";
    std::optional<std::string> fallback = std::nullopt; ///< default as written in a dictionary; none: see `required`
    std::string meaning = "";                           ///< one line
    bool required = false;
    std::vector<std::string> words = {}; ///< a number or an integer may also be one of these ("auto")
    double minimum = -std::numeric_limits<double>::infinity();
    double maximum = std::numeric_limits<double>::infinity();
    bool positive = false;      ///< number must be > 0
    std::vector<Key> keys = {}; ///< of a dictionary
};

/// The keys of a dictionary that a program owns, with unit, default, range and meaning: one source for the checks, the
/// defaults that checkCase prints, and the annotated dictionaries in etc/.
class Schema
{
public:
    Schema(std::string name, std::vector<Key> keys);

    /// A copy with every default filled in (marked isDefault).
    /// \throws Error(input) with all slips at once: unknown keys (naming the nearest known one) unless a macro or an
    ///         expression in the same file uses them, missing required keys, wrong types, words and ranges.
    Dictionary complete(const Dictionary& dictionary) const;

    /// The dictionary with every key at its default and its meaning as a comment: text of etc/annotated/<name>.
    std::string annotated() const;

    const std::string& name() const { return name_; }
    const std::vector<Key>& keys() const { return keys_; }

private:
    std::string name_;
    std::vector<Key> keys_;
};

} // namespace isph
