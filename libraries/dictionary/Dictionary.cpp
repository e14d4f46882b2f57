#include "dictionary/Dictionary.hpp"

#include "core/nearestWord.hpp"
#include "dictionary/KeyPattern.hpp"
#include "dictionary/Lexer.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace isph
{

const Entry* Dictionary::find(std::string_view key) const
{
    const Entry* exact = nullptr;
    for (const Entry& entry : entries_)
    {
        if (entry.keyword() == key && (exact == nullptr || !entry.isPattern())) { exact = &entry; }
    }
    if (exact != nullptr) { return exact; }
    for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry)
    {
        if (entry->isPattern() && KeyPattern(entry->keyword()).matches(key)) { return &*entry; }
    }
    return nullptr;
}

Entry* Dictionary::find(std::string_view key) { return const_cast<Entry*>(std::as_const(*this).find(key)); }

const Entry* Dictionary::findScoped(std::string_view key) const
{
    // A keyword may hold a dot itself, so every place to cut is tried: the shortest first word first, the whole last.
    for (std::size_t cut = key.find_first_of("./"); cut != std::string_view::npos;
         cut = key.find_first_of("./", cut + 1))
    {
        const Entry* first = find(key.substr(0, cut));
        if (first != nullptr && first->isDictionary())
        {
            if (const Entry* found = first->dictionary().findScoped(key.substr(cut + 1))) { return found; }
        }
    }
    return find(key);
}

bool Dictionary::hasDictionary(std::string_view key) const
{
    const Entry* entry = find(key);
    return entry != nullptr && entry->isDictionary();
}

std::string Dictionary::scopedName(std::string_view key) const
{
    return origin_.entry.empty() ? std::string(key) : fmt::format("{}.{}", origin_.entry, key);
}

Error Dictionary::error(std::string_view key, std::string what, std::string advice) const
{
    const Entry* entry = find(key);
    Origin origin = entry != nullptr ? entry->origin() : origin_;
    origin.entry = scopedName(key);
    return Error(Fault::input, std::move(origin), std::move(what), std::move(advice));
}

const Entry& Dictionary::required(std::string_view key, std::string_view shape) const
{
    if (const Entry* entry = find(key)) { return *entry; }
    std::vector<std::string> present;
    for (const Entry& entry : entries_) { present.push_back(entry.keyword()); }
    const std::optional<std::string> nearest = nearestWord(key, present);
    throw error(key, fmt::format("is missing, {} is needed", shape),
                nearest ? fmt::format("is '{}' in line {} meant for it?", *nearest, find(*nearest)->origin().line)
                        : "");
}

std::string shownValue(const Entry& entry)
{
    constexpr std::size_t longest = 60;
    if (entry.isDictionary()) { return "a dictionary"; }
    if (entry.tokens().empty()) { return "empty"; }
    std::string text;
    bool glue = true;
    for (const Token& token : entry.tokens())
    {
        const bool closing = token.kind == Token::Kind::bracket && (token.text == ")" || token.text == "]");
        if (!glue && !closing) { text += ' '; }
        text += token.kind == Token::Kind::string ? '"' + token.text + '"' : token.text;
        glue = token.kind == Token::Kind::bracket && !closing;
        if (text.size() > longest) { return text.substr(0, longest) + " ..."; }
    }
    return text;
}

Error Dictionary::mismatch(const Entry& entry, const std::string& shape) const
{
    // The next line's words in a value are the sign of a forgotten semicolon.
    std::string advice;
    for (std::size_t i = 1; i < entry.tokens().size() && advice.empty(); ++i)
    {
        const Token& before = entry.tokens()[i - 1];
        const bool newLine = entry.tokens()[i].line > before.line;
        if (newLine && before.kind != Token::Kind::bracket)
        {
            advice = fmt::format("is the ';' missing at the end of line {}?", before.line);
        }
    }
    return Error(Fault::input, entry.origin(), fmt::format("is {} but must be {}", shownValue(entry), shape),
                 std::move(advice));
}

double Dictionary::number(std::string_view key) const
{
    const Entry& entry = required(key, "a number");
    const std::vector<Token>& tokens = entry.tokens();
    if (tokens.size() != 1 || tokens[0].kind != Token::Kind::number) { throw mismatch(entry, "a number"); }
    return tokens[0].number;
}

int Dictionary::integer(std::string_view key) const
{
    const Entry& entry = required(key, "a whole number");
    const std::vector<Token>& tokens = entry.tokens();
    using Limits = std::numeric_limits<int>;
    const bool isNumber = tokens.size() == 1 && tokens[0].kind == Token::Kind::number;
    if (!isNumber || tokens[0].number != std::trunc(tokens[0].number)) { throw mismatch(entry, "a whole number"); }
    if (tokens[0].number < Limits::min() || tokens[0].number > Limits::max())
    {
        throw mismatch(entry, fmt::format("a whole number from {} to {}", Limits::min(), Limits::max()));
    }
    return static_cast<int>(tokens[0].number);
}

bool Dictionary::flag(std::string_view key) const
{
    const Entry& entry = required(key, "yes or no");
    if (entry.tokens().size() == 1)
    {
        const std::string& text = entry.tokens()[0].text;
        if (text == "yes" || text == "on" || text == "true") { return true; }
        if (text == "no" || text == "off" || text == "false") { return false; }
    }
    throw mismatch(entry, "yes or no (on/off, true/false)");
}

Word Dictionary::word(std::string_view key) const
{
    const Entry& entry = required(key, "a word");
    const std::vector<Token>& tokens = entry.tokens();
    if (tokens.size() != 1 || tokens[0].kind != Token::Kind::word) { throw mismatch(entry, "a word"); }
    return Word{tokens[0].text, entry.origin()};
}

std::string Dictionary::text(std::string_view key) const
{
    const Entry& entry = required(key, "a word or a quoted string");
    const std::vector<Token>& tokens = entry.tokens();
    const bool isText =
        tokens.size() == 1 && (tokens[0].kind == Token::Kind::word || tokens[0].kind == Token::Kind::string);
    if (!isText) { throw mismatch(entry, "a word or a quoted string"); }
    return tokens[0].text;
}

namespace
{

bool isBracket(const Token& token, char bracket)
{
    return token.kind == Token::Kind::bracket && token.text[0] == bracket;
}

/// The tokens between the outer parentheses of a flat list, perhaps behind their count; nothing for another shape.
std::optional<std::vector<Token>> flatList(const std::vector<Token>& tokens)
{
    const bool counted = !tokens.empty() && tokens[0].kind == Token::Kind::number;
    const std::size_t first = counted ? 1 : 0;
    if (tokens.size() < first + 2 || !isBracket(tokens[first], '(') || !isBracket(tokens.back(), ')'))
    {
        return std::nullopt;
    }
    std::vector<Token> items(tokens.begin() + static_cast<std::ptrdiff_t>(first) + 1, tokens.end() - 1);
    const bool nested = std::ranges::any_of(items, [](const Token& t) { return t.kind == Token::Kind::bracket; });
    if (nested || (counted && tokens[0].number != static_cast<double>(items.size()))) { return std::nullopt; }
    return items;
}

/// Seven whole exponents from tokens "[ ... ]" that begin at `first`; five count as seven with zeros behind.
std::optional<std::array<int, 7>> exponents(const std::vector<Token>& tokens, std::size_t first, std::size_t last)
{
    const std::size_t count = last - first + 1;
    if (count != 9 && count != 7) { return std::nullopt; }
    std::array<int, 7> result{};
    for (std::size_t i = 0; i + 2 < count; ++i)
    {
        const Token& token = tokens[first + 1 + i];
        const bool whole = token.kind == Token::Kind::number && std::abs(token.number) < 100 &&
                           token.number == static_cast<int>(token.number);
        if (!whole) { return std::nullopt; }
        result[i] = static_cast<int>(token.number);
    }
    return result;
}

/// What stands before the last number of "nu [0 2 -1 0 0 0 0] 0.01".
struct Prefix
{
    std::size_t open = 0;  ///< of '[' among the tokens
    std::size_t close = 0; ///< of ']'; 0: there are no dimensions
};

/// Nothing unless the tokens are a number, perhaps behind dimensions, perhaps behind a name.
std::optional<Prefix> dimensionedPrefix(const std::vector<Token>& tokens)
{
    if (tokens.empty() || tokens.back().kind != Token::Kind::number) { return std::nullopt; }
    if (tokens.size() == 1) { return Prefix{}; }
    const std::size_t open = tokens[0].kind == Token::Kind::word ? 1 : 0;
    const std::size_t close = tokens.size() - 2;
    if (open >= close || !isBracket(tokens[open], '[') || !isBracket(tokens[close], ']')) { return std::nullopt; }
    return Prefix{open, close};
}

std::string dimensionText(const std::array<int, 7>& dimensions)
{
    return fmt::format("[{}]", fmt::join(dimensions, " "));
}

} // namespace

std::array<double, 3> Dictionary::vector(std::string_view key) const
{
    const Entry& entry = required(key, "a vector of three numbers");
    const auto items = flatList(entry.tokens());
    const auto isNumber = [](const Token& token) { return token.kind == Token::Kind::number; };
    if (!items || items->size() != 3 || !std::ranges::all_of(*items, isNumber))
    {
        throw mismatch(entry, "a vector of three numbers, e.g. (1 0 0)");
    }
    return {(*items)[0].number, (*items)[1].number, (*items)[2].number};
}

std::vector<double> Dictionary::numbers(std::string_view key) const
{
    const Entry& entry = required(key, "a list of numbers");
    const auto items = flatList(entry.tokens());
    const auto isNumber = [](const Token& token) { return token.kind == Token::Kind::number; };
    if (!items || !std::ranges::all_of(*items, isNumber)) { throw mismatch(entry, "a list of numbers, e.g. (1 2 3)"); }
    std::vector<double> result;
    for (const Token& token : *items) { result.push_back(token.number); }
    return result;
}

std::vector<Word> Dictionary::words(std::string_view key) const
{
    const Entry& entry = required(key, "a list of words");
    const auto isText = [](const Token& token)
    { return token.kind == Token::Kind::word || token.kind == Token::Kind::string; };
    const std::vector<Token>& tokens = entry.tokens();
    const auto items = tokens.size() == 1 ? std::optional(tokens) : flatList(tokens);
    if (!items || !std::ranges::all_of(*items, isText)) { throw mismatch(entry, "a list of words, e.g. (U p)"); }
    std::vector<Word> result;
    for (const Token& token : *items)
    {
        Origin origin = entry.origin();
        origin.line = token.line;
        result.push_back(Word{token.text, std::move(origin)});
    }
    return result;
}

const Dictionary& Dictionary::dictionary(std::string_view key) const
{
    const Entry& entry = required(key, "a dictionary { ... }");
    if (!entry.isDictionary()) { throw mismatch(entry, "a dictionary { ... }"); }
    return entry.dictionary();
}

double Dictionary::dimensionedNumber(std::string_view key, const std::array<int, 7>& expected) const
{
    const Entry& entry = required(key, "a number");
    const auto prefix = dimensionedPrefix(entry.tokens());
    if (!prefix) { throw mismatch(entry, "a number, perhaps behind dimensions"); }
    if (prefix->close > 0)
    {
        const auto given = exponents(entry.tokens(), prefix->open, prefix->close);
        if (!given) { throw mismatch(entry, "a number behind seven whole exponents"); }
        if (*given != expected)
        {
            throw error(
                key,
                fmt::format("has the dimensions {} but must have {}", dimensionText(*given), dimensionText(expected)),
                "they are the exponents of kg, m, s, K, mol, A and cd");
        }
    }
    return entry.tokens().back().number;
}

std::array<int, 7> Dictionary::dimensions(std::string_view key) const
{
    const Entry& entry = required(key, "a set of dimensions");
    const std::vector<Token>& tokens = entry.tokens();
    const bool enclosed = tokens.size() >= 2 && isBracket(tokens.front(), '[') && isBracket(tokens.back(), ']');
    const auto result = enclosed ? exponents(tokens, 0, tokens.size() - 1) : std::nullopt;
    if (!result) { throw mismatch(entry, "seven whole exponents, e.g. [0 1 -1 0 0 0 0]"); }
    return *result;
}

std::optional<double> scalarValue(const Entry& entry)
{
    const bool single = !entry.isDictionary() && dimensionedPrefix(entry.tokens());
    return single ? std::optional(entry.tokens().back().number) : std::nullopt;
}

std::optional<double> Dictionary::constant(const std::string& name) const
{
    const Entry* entry = find(name);
    const std::optional<double> own = entry != nullptr ? scalarValue(*entry) : std::nullopt;
    if (own) { return own; }
    const auto outer =
        std::ranges::find(inherited_.rbegin(), inherited_.rend(), name, &std::pair<std::string, double>::first);
    return outer != inherited_.rend() ? std::optional(outer->second) : std::nullopt;
}

void Dictionary::set(Entry entry)
{
    const auto existing = std::ranges::find_if(
        entries_, [&entry](const Entry& candidate)
        { return candidate.keyword() == entry.keyword() && candidate.isPattern() == entry.isPattern(); });
    if (existing == entries_.end())
    {
        entries_.push_back(std::move(entry));
        return;
    }
    const bool used = existing->usedByMacro || entry.usedByMacro;
    if (existing->isDictionary() && entry.isDictionary())
    {
        existing->isDefault = existing->isDefault && entry.isDefault;
        for (Entry& inner : entry.dictionary().entries_) { existing->dictionary().set(std::move(inner)); }
    }
    else { *existing = std::move(entry); }
    existing->usedByMacro = used;
}

void Dictionary::remove(std::string_view keyword)
{
    std::erase_if(entries_, [keyword](const Entry& entry) { return entry.keyword() == keyword; });
}

} // namespace isph
