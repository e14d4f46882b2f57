#pragma once

#include "core/Error.hpp"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isph
{

/// A piece of an entry's value, after macros and #eval were expanded.
struct Token
{
    enum class Kind
    {
        word,
        string,
        number,
        bracket
    }; ///< bracket: one of ( ) [ ]

    Kind kind;
    std::string text;  ///< as written; a string without its quotes
    double number = 0; ///< of a number
    int line = 0;

    bool operator==(const Token&) const = default;
};

class Dictionary;

/// A keyword with its tokens, or with a sub-dictionary.
class Entry
{
public:
    Entry(std::string keyword, bool pattern, Origin origin, std::vector<Token> tokens);
    Entry(std::string keyword, bool pattern, Origin origin, Dictionary dictionary);
    Entry(const Entry&);
    Entry(Entry&&) noexcept;
    Entry& operator=(Entry);
    ~Entry();

    const std::string& keyword() const { return keyword_; }
    bool isPattern() const { return pattern_; } ///< written in quotes: a regular expression
    const Origin& origin() const { return origin_; }
    bool isDictionary() const { return dictionary_ != nullptr; }
    const Dictionary& dictionary() const; ///< requires isDictionary()
    Dictionary& dictionary();
    const std::vector<Token>& tokens() const { return tokens_; }

    /// Whether a macro ($name) read this entry: how users define constants, so it is never "unknown".
    bool usedByMacro = false;

    /// Whether a schema put it there because the user left it out.
    bool isDefault = false;

private:
    std::string keyword_;
    bool pattern_;
    Origin origin_;
    std::vector<Token> tokens_;
    std::unique_ptr<Dictionary> dictionary_;
};

/// A dictionary in OpenFOAM's grammar (contract, section 1): a value type, read completely before anything is asked.
///
/// Typed access throws Error(input) with file:line:entry when the key is missing or its value has another type.
/// Defaults are not given here but by Schema::complete.
class Dictionary
{
public:
    Dictionary() = default;
    explicit Dictionary(Origin origin) : origin_(std::move(origin)) {}

    /// Reads a file, expanding directives and macros.
    /// \param shownAs the path that messages use (relative to the case); empty: the path itself
    /// \throws Error(input) if the file is missing, unreadable, or breaks the grammar.
    static Dictionary read(const std::filesystem::path& file, const std::string& shownAs = "");

    /// Parses text; #include is relative to folder. An empty folder: the text stands alone, including is an error.
    static Dictionary parse(std::string_view text, const std::string& shownAs,
                            const std::filesystem::path& folder = ".");

    /// File and line of the opening brace, and the scoped name of this dictionary.
    const Origin& origin() const { return origin_; }

    /// Entry of a key: an exact keyword first, else the last pattern that matches it; null if there is none.
    const Entry* find(std::string_view key) const;
    Entry* find(std::string_view key);
    bool has(std::string_view key) const { return find(key) != nullptr; }
    bool hasDictionary(std::string_view key) const;

    /// Entry of a scoped key, "kernel.order" or "kernel/order"; keywords may hold dots themselves. Null: there is none.
    const Entry* findScoped(std::string_view key) const;
    const std::vector<Entry>& entries() const { return entries_; }

    double number(std::string_view key) const;
    int integer(std::string_view key) const;
    bool flag(std::string_view key) const; ///< yes/no, on/off, true/false
    Word word(std::string_view key) const;
    std::string text(std::string_view key) const; ///< word or quoted string
    std::array<double, 3> vector(std::string_view key) const;
    std::vector<double> numbers(std::string_view key) const; ///< ( 1 2 3 )
    std::vector<Word> words(std::string_view key) const;     ///< ( U p ), or a lone word
    const Dictionary& dictionary(std::string_view key) const;

    /// A number that may be written behind dimensions, or behind its own name and dimensions as OpenFOAM does:
    /// "nu [0 2 -1 0 0 0 0] 0.01;" or "nu nu [0 2 -1 0 0 0 0] 0.01;".
    /// \throws Error(input) if dimensions are given and differ from the expected exponents (kg m s K mol A cd).
    double dimensionedNumber(std::string_view key, const std::array<int, 7>& dimensions) const;

    /// The seven exponents of an entry like "dimensions [0 1 -1 0 0 0 0];".
    std::array<int, 7> dimensions(std::string_view key) const;

    /// The scoped name that a key of this dictionary has in messages: "kernel.order".
    std::string scopedName(std::string_view key) const;

    /// The error for an entry, at its line, for readers that find a value impossible.
    Error error(std::string_view key, std::string what, std::string advice = "") const;

    /// The scalar entries of this dictionary and its parents as constants of an expression.
    std::optional<double> constant(const std::string& name) const;

    /// Adds an entry, or replaces one with the same keyword; two dictionaries merge.
    void set(Entry entry);
    void remove(std::string_view keyword); ///< of exactly this spelling; nothing happens if there is none

    friend class Parser;

private:
    const Entry& required(std::string_view key, std::string_view shape) const;
    Error mismatch(const Entry& entry, const std::string& shape) const;

    Origin origin_;
    std::vector<Entry> entries_;
    std::vector<std::pair<std::string, double>> inherited_; ///< scalar entries of the parents, inner ones last
};

/// The value of an entry as a user would write it, shortened for messages.
std::string shownValue(const Entry& entry);

/// The value of an entry that holds one number, perhaps behind dimensions; nothing for any other.
std::optional<double> scalarValue(const Entry& entry);

} // namespace isph
