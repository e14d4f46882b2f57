#include "dictionary/Parser.hpp"

#include "core/numberText.hpp"
#include "expression/Expression.hpp"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>

namespace isph
{

namespace
{

constexpr std::size_t mostMacros = 10'000;
constexpr std::size_t longestName = 1000;

} // namespace

Entry* Parser::findOutwards(std::string_view key, std::size_t scope) const
{
    for (std::size_t i = scope + 1; i-- > 0;)
    {
        if (Entry* entry = scopes_[i]->find(key)) { return entry; }
    }
    return nullptr;
}

Entry* Parser::findDotted(std::string_view name, std::size_t scope, bool outwards) const
{
    const auto findFirst = [&](std::string_view key)
    { return outwards ? findOutwards(key, scope) : scopes_[scope]->find(key); };
    // a.b is b inside of a, or a keyword with a dot; as in OpenFOAM, the shortest first word comes first.
    for (std::size_t cut = name.find('.'); cut != std::string_view::npos; cut = name.find('.', cut + 1))
    {
        Entry* first = findFirst(name.substr(0, cut));
        if (first == nullptr || !first->isDictionary()) { continue; }
        if (const Entry* found = first->dictionary().findScoped(name.substr(cut + 1)))
        {
            first->usedByMacro = true;
            return const_cast<Entry*>(found); // of a dictionary that is being read, so not constant
        }
    }
    return findFirst(name);
}

Entry* Parser::macroEntry(std::string_view name)
{
    if (name.size() > longestName) { fail(lexer_->line(), "has a macro with too long a name"); }
    if (++macros_ > mostMacros) { fail(lexer_->line(), fmt::format("has more than {} macros", mostMacros)); }
    Entry* entry = nullptr;
    if (name.starts_with(':')) { entry = findDotted(name.substr(1), 0, false); }
    else if (name.starts_with('.'))
    {
        // One dot is this dictionary, each further one a parent.
        const std::size_t dots = std::min(name.find_first_not_of('.'), name.size());
        if (dots > scopes_.size())
        {
            fail(lexer_->line(), fmt::format("has the macro ${}, which leads out of the dictionary", name));
        }
        entry = findDotted(name.substr(dots), scopes_.size() - dots, false);
    }
    else { entry = findDotted(name, scopes_.size() - 1, true); }
    if (entry != nullptr) { entry->usedByMacro = true; }
    return entry;
}

std::vector<Token> Parser::expandMacro(const Lexeme& macro)
{
    if (const Entry* entry = macroEntry(macro.text))
    {
        if (entry->isDictionary())
        {
            fail(macro.line, fmt::format("uses the dictionary ${} as a value", macro.text),
                 "only \"key $name;\" and \"$name;\" may name a dictionary");
        }
        std::vector<Token> tokens = entry->tokens();
        for (Token& token : tokens) { token.line = macro.line; }
        return tokens;
    }
    if (const char* variable = std::getenv(macro.text.c_str()))
    {
        const std::optional<double> number = numberFrom(variable);
        const bool finite = number && *number - *number == 0;
        return {Token{finite ? Token::Kind::number : Token::Kind::string, variable, finite ? *number : 0, macro.line}};
    }
    fail(macro.line, fmt::format("uses ${}, which is neither an entry so far nor in the environment", macro.text));
}

void Parser::parseMacroStatement(const Lexeme& macro, Dictionary& target)
{
    const Entry* entry = macroEntry(macro.text);
    if (entry != nullptr && entry->isDictionary())
    {
        count(*entry);
        const Dictionary merged = entry->dictionary(); // a copy: the target may hold the entry itself
        for (const Entry& inner : merged.entries()) { add(inner, target); }
        return;
    }
    if (entry == nullptr || lexer_->peek().kind == Lexeme::Kind::semicolon)
    {
        fail(macro.line, fmt::format("has ${} where a key should be, but it is {}", macro.text,
                                     entry == nullptr ? "not an entry so far" : "not a dictionary"));
    }
    // A macro may also spell the key.
    const std::vector<Token> tokens = entry->tokens();
    if (tokens.size() != 1 || (tokens[0].kind != Token::Kind::word && tokens[0].kind != Token::Kind::string))
    {
        fail(macro.line, fmt::format("has ${} where a key should be, but it is {}", macro.text, shownValue(*entry)));
    }
    Lexeme key = macro;
    key.kind = Lexeme::Kind::word;
    key.text = tokens[0].text;
    parseEntry(key, target);
}

std::string Parser::withMacros(std::string_view text, int line, bool numbers)
{
    const auto isNameCharacter = [](char c)
    {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        return letter || (c >= '0' && c <= '9') || c == '_' || c == '.' || c == ':';
    };
    std::string result;
    for (std::size_t i = 0; i < text.size();)
    {
        if (text[i] != '$')
        {
            result += text[i++];
            continue;
        }
        Lexeme macro;
        macro.line = line;
        ++i;
        if (i < text.size() && text[i] == '{')
        {
            const std::size_t close = std::min(text.find('}', i), text.size());
            macro.text = text.substr(i + 1, close - i - 1);
            i = std::min(close + 1, text.size());
        }
        else
        {
            const std::size_t begin = i;
            while (i < text.size() && isNameCharacter(text[i])) { ++i; }
            macro.text = text.substr(begin, i - begin);
        }
        if (macro.text.empty()) { fail(line, "has a '$' without a name behind it"); }
        const std::vector<Token> tokens = expandMacro(macro);
        if (numbers)
        {
            if (tokens.empty() || tokens.back().kind != Token::Kind::number || (tokens.size() > 1 && tokens.size() < 9))
            {
                fail(line, fmt::format("uses ${} in a formula, but that is not a number", macro.text));
            }
            result += fmt::format("({})", numberText(tokens.back().number)); // in parentheses: it may be negative
        }
        else if (tokens.size() == 1) { result += tokens[0].text; }
        else { fail(line, fmt::format("uses ${} in a name, but that is not a single word", macro.text)); }
    }
    return result;
}

Token Parser::valueOfEval(int line)
{
    std::string text;
    if (lexer_->peek().kind == Lexeme::Kind::openBrace) { text = lexer_->bracedText(); }
    else if (lexer_->peek().kind == Lexeme::Kind::string) { text = lexer_->next().text; }
    else { fail(line, "has an #eval without a formula", "write #eval{ 2*pi() } or #eval \"2*pi()\""); }

    const auto constant = [this](const std::string& name) -> std::optional<double>
    {
        const Entry* entry = macroEntry(name);
        return entry != nullptr ? scalarValue(*entry) : std::nullopt;
    };
    const Origin origin = here(line);
    const Expression formula(withMacros(text, line, true), constant, origin);
    if (formula.dependsOnSpace() || formula.dependsOnTime())
    {
        fail(line, fmt::format("has \"{}\" in an #eval, which knows no x, y, z, t and noise", formula.text()));
    }
    const double value = formula(0, 0, 0, 0);
    return Token{Token::Kind::number, numberText(value), value, line};
}

} // namespace isph
