#include "dictionary/Lexer.hpp"

#include <charconv>
#include <fmt/format.h>
#include <limits>

namespace isph
{

namespace
{

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v'; }

/// Characters that words may hold, brackets apart, which they may hold in pairs: div(U).
bool isWordCharacter(char c)
{
    const auto code = static_cast<unsigned char>(c);
    return code > ' ' && code != 0x7f && std::string_view("\"';{}()[]").find(c) == std::string_view::npos;
}

bool isNameCharacter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

} // namespace

std::optional<double> numberFrom(std::string_view text)
{
    const std::string_view unsignedText = !text.empty() && (text[0] == '-' || text[0] == '+') ? text.substr(1) : text;
    if (unsignedText.empty() || (unsignedText[0] != '.' && (unsignedText[0] < '0' || unsignedText[0] > '9')))
    {
        return std::nullopt;
    }
    double value = 0;
    const char* const last = unsignedText.data() + unsignedText.size();
    const auto [read, problem] = std::from_chars(unsignedText.data(), last, value);
    if (read != last || problem == std::errc::invalid_argument) { return std::nullopt; }
    if (problem == std::errc::result_out_of_range) { return std::numeric_limits<double>::infinity(); }
    return text[0] == '-' ? -value : value;
}

Lexer::Lexer(std::string_view text, std::string file) : text_(text), file_(std::move(file))
{
    if (text_.starts_with("\xEF\xBB\xBF")) { here_ = 3; } // byte-order mark
}

void Lexer::fail(int line, const std::string& what, const std::string& advice) const
{
    throw Error(Fault::input, Origin{file_, line, ""}, what, advice);
}

Lexeme Lexer::next()
{
    Lexeme lexeme = peeked_ ? std::move(*peeked_) : read();
    peeked_.reset();
    line_ = lexeme.line;
    end_ = lexeme.end;
    return lexeme;
}

const Lexeme& Lexer::peek()
{
    if (!peeked_) { peeked_ = read(); }
    return *peeked_;
}

void Lexer::skipBlanks()
{
    while (here_ < text_.size())
    {
        const char c = text_[here_];
        if (c == '\n') { ++lineHere_; }
        if (isBlank(c)) { ++here_; }
        else if (c == '/' && at(here_ + 1) == '/')
        {
            while (here_ < text_.size() && text_[here_] != '\n') { ++here_; }
        }
        else if (c == '/' && at(here_ + 1) == '*')
        {
            const int opened = lineHere_;
            const std::size_t close = text_.find("*/", here_ + 2);
            if (close == std::string_view::npos) { fail(opened, "opens a comment with '/*' that is never closed"); }
            for (; here_ < close + 2; ++here_)
            {
                if (text_[here_] == '\n') { ++lineHere_; }
            }
        }
        else { return; }
    }
}

Lexeme Lexer::read()
{
    skipBlanks();
    Lexeme lexeme;
    lexeme.line = lineHere_;
    lexeme.begin = here_;
    const char c = at(here_);
    if (here_ >= text_.size()) { lexeme.kind = Lexeme::Kind::end; }
    else if (c == '"') { readString(lexeme); }
    else if (c == '$') { readMacro(lexeme); }
    else if (c == '#') { readDirective(lexeme); }
    else if (isWordCharacter(c)) { readWordOrNumber(lexeme); }
    else
    {
        switch (c)
        {
        case '{':
            lexeme.kind = Lexeme::Kind::openBrace;
            break;
        case '}':
            lexeme.kind = Lexeme::Kind::closeBrace;
            break;
        case ';':
            lexeme.kind = Lexeme::Kind::semicolon;
            break;
        case '(':
        case ')':
        case '[':
        case ']':
            lexeme.kind = Lexeme::Kind::bracket;
            break;
        case '\'':
            fail(lineHere_, "has a single quote", "write strings in double quotes");
        default:
            fail(lineHere_, fmt::format("has the unprintable character 0x{:02x}", static_cast<unsigned char>(c)));
        }
        lexeme.text = std::string(1, c);
        ++here_;
    }
    lexeme.end = here_;
    return lexeme;
}

void Lexer::readString(Lexeme& lexeme)
{
    lexeme.kind = Lexeme::Kind::string;
    bool escaped = false;
    for (++here_; here_ < text_.size(); ++here_)
    {
        const char c = text_[here_];
        if (c == '"' && !escaped)
        {
            ++here_;
            return;
        }
        if (c == '\n')
        {
            if (!escaped) { break; }
            ++lineHere_;
        }
        // A backslash protects a quote or the end of a line and goes; before anything else it stays, as in OpenFOAM.
        if (escaped && (c == '"' || c == '\n')) { lexeme.text.pop_back(); }
        lexeme.text += c;
        escaped = c == '\\' && !escaped;
    }
    fail(lexeme.line, "opens a string that does not end on its line", "close it with a double quote");
}

void Lexer::readMacro(Lexeme& lexeme)
{
    lexeme.kind = Lexeme::Kind::macro;
    ++here_;
    if (at(here_) == '{')
    {
        const std::size_t close = text_.find_first_of("}\n", here_);
        if (close == std::string_view::npos || text_[close] != '}')
        {
            fail(lineHere_, "opens '${' but does not close it on its line");
        }
        lexeme.text = text_.substr(here_ + 1, close - here_ - 1);
        here_ = close + 1;
    }
    else
    {
        const std::size_t begin = here_;
        while (isWordCharacter(at(here_)) && at(here_) != '$' && at(here_) != ',') { ++here_; }
        lexeme.text = text_.substr(begin, here_ - begin);
    }
    if (lexeme.text.empty()) { fail(lineHere_, "has a '$' without a name behind it"); }
}

void Lexer::readDirective(Lexeme& lexeme)
{
    lexeme.kind = Lexeme::Kind::directive;
    const std::size_t begin = ++here_;
    while (isNameCharacter(at(here_))) { ++here_; }
    lexeme.text = text_.substr(begin, here_ - begin);
    if (lexeme.text.empty()) { fail(lineHere_, "has a '#' without a directive behind it"); }
}

void Lexer::readWordOrNumber(Lexeme& lexeme)
{
    const std::size_t begin = here_;
    const auto ends = [this] { return at(here_) == '/' && (at(here_ + 1) == '/' || at(here_ + 1) == '*'); };
    while (isWordCharacter(at(here_)) && !ends()) { ++here_; }
    const std::string_view plain = text_.substr(begin, here_ - begin);
    if (const std::optional<double> number = numberFrom(plain))
    {
        if (*number == std::numeric_limits<double>::infinity())
        {
            fail(lineHere_, fmt::format("has the number {}, which is too large or too small to hold", plain));
        }
        lexeme.kind = Lexeme::Kind::number;
        lexeme.number = *number;
        lexeme.text = plain;
        return;
    }

    // A word goes on over brackets that it opened itself: div(U), but not the last parenthesis of (U p).
    std::string open;
    while (!ends())
    {
        const char c = at(here_);
        const bool closes = !open.empty() && c == open.back();
        if (c == '(' || c == '[') { open += c == '(' ? ')' : ']'; }
        else if (closes) { open.pop_back(); }
        else if (!isWordCharacter(c)) { break; }
        ++here_;
    }
    lexeme.kind = Lexeme::Kind::word;
    lexeme.text = text_.substr(begin, here_ - begin);
    if (!open.empty()) { fail(lineHere_, fmt::format("has the word '{}' with an open bracket", lexeme.text)); }
}

std::string Lexer::bracedText()
{
    const Lexeme brace = next();
    const std::size_t begin = brace.end;
    int depth = 1;
    for (here_ = begin; here_ < text_.size(); ++here_)
    {
        const char c = text_[here_];
        if (c == '\n') { ++lineHere_; }
        if (c == '{') { ++depth; }
        if (c == '}') { --depth; }
        if (depth == 0)
        {
            end_ = ++here_;
            return std::string(text_.substr(begin, end_ - 1 - begin));
        }
    }
    fail(brace.line, "opens a '{' that is never closed");
}

} // namespace isph
