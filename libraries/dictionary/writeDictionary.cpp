#include "dictionary/writeDictionary.hpp"

#include "core/numberText.hpp"
#include "dictionary/Lexer.hpp"

#include <cmath>
#include <fmt/format.h>

namespace isph
{

namespace
{

constexpr std::size_t valueColumn = 16; // OpenFOAM's
constexpr std::size_t longestLine = 110;

/// Whether a text, put into a file, would be read as this one lexeme.
bool readsAs(Lexeme::Kind kind, const std::string& written, const std::string& text)
{
    try
    {
        Lexer lexer(written, "");
        const Lexeme first = lexer.next();
        return first.kind == kind && first.text == text && lexer.next().kind == Lexeme::Kind::end;
    }
    catch (const Error&)
    {
        return false;
    }
}

std::string quoted(const std::string& text)
{
    std::string result = "\"";
    for (const char c : text)
    {
        if (c == '"' || c == '\n') { result += '\\'; }
        result += c;
    }
    return result + '"';
}

std::string checked(Lexeme::Kind kind, const std::string& written, const std::string& text, const Origin& origin)
{
    if (readsAs(kind, written, text)) { return written; }
    throw Error(Fault::input, origin, fmt::format("holds '{}', which no dictionary can hold", text));
}

std::string tokenText(const Token& token, const Origin& origin)
{
    switch (token.kind)
    {
    case Token::Kind::word:
        return checked(Lexeme::Kind::word, token.text, token.text, origin);
    case Token::Kind::string:
        return checked(Lexeme::Kind::string, quoted(token.text), token.text, origin);
    case Token::Kind::number:
        // As the user wrote it, where that is the same number.
        if (!std::isfinite(token.number)) { throw Error(Fault::input, origin, "holds a number that is not finite"); }
        return numberFrom(token.text) == token.number ? token.text : numberText(token.number);
    case Token::Kind::bracket:
        break;
    }
    return token.text;
}

std::string tokensText(const Entry& entry, std::size_t indent)
{
    const std::string newLine = '\n' + std::string(indent + valueColumn, ' ');
    std::string text;
    std::size_t lineBegin = 0;
    bool glue = true; // no blank behind an opening bracket
    for (const Token& token : entry.tokens())
    {
        const bool closing = token.kind == Token::Kind::bracket && (token.text == ")" || token.text == "]");
        const std::string piece = tokenText(token, entry.origin());
        if (!glue && !closing)
        {
            if (text.size() - lineBegin + piece.size() + indent + valueColumn > longestLine)
            {
                text += newLine;
                lineBegin = text.size();
            }
            else { text += ' '; }
        }
        text += piece;
        glue = token.kind == Token::Kind::bracket && !closing;
    }
    return text;
}

std::string entriesText(const Dictionary& dictionary, std::size_t indent);

std::string blockText(const Dictionary& dictionary, std::size_t indent)
{
    const std::string margin(indent, ' ');
    return fmt::format("{0}{{\n{1}{0}}}", margin, entriesText(dictionary, indent + 4));
}

std::string entriesText(const Dictionary& dictionary, std::size_t indent)
{
    const std::string margin(indent, ' ');
    std::string text;
    for (const Entry& entry : dictionary.entries())
    {
        if (indent == 0 && entry.keyword() == "FoamFile") { continue; }
        const std::string& keyword = entry.keyword();
        const std::string key = entry.isPattern()
                                    ? checked(Lexeme::Kind::string, quoted(keyword), keyword, entry.origin())
                                    : checked(Lexeme::Kind::word, keyword, keyword, entry.origin());
        if (entry.isDictionary())
        {
            text += fmt::format("{}{}\n{}\n", margin, key, blockText(entry.dictionary(), indent));
        }
        else if (entry.tokens().empty()) { text += fmt::format("{}{};\n", margin, key); }
        else
        {
            const std::size_t blanks = key.size() < valueColumn ? valueColumn - key.size() : 1;
            text += fmt::format("{}{}{}{};\n", margin, key, std::string(blanks, ' '), tokensText(entry, indent));
        }
    }
    return text;
}

} // namespace

std::string foamHeader(const std::string& foamClass, const std::string& object)
{
    return fmt::format("FoamFile\n{{\n    version         2.0;\n    format          ascii;\n    class           {};\n"
                       "    object          {};\n}}\n\n",
                       foamClass, object);
}

std::string dictionaryText(const Dictionary& dictionary) { return entriesText(dictionary, 0); }

std::string valueText(const Entry& entry)
{
    return entry.isDictionary() ? blockText(entry.dictionary(), 0) : tokensText(entry, 0);
}

} // namespace isph
