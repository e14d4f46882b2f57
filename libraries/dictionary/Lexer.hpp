#pragma once

#include "core/Error.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace isph
{

/// The smallest piece of a dictionary's text.
struct Lexeme
{
    enum class Kind
    {
        word,
        string, ///< text is without its quotes
        number,
        bracket, ///< ( ) [ ]
        openBrace,
        closeBrace,
        semicolon,
        macro,     ///< $name or ${name}; text is the name
        directive, ///< #name; text is the name
        end,
    };

    Kind kind = Kind::end;
    std::string text;
    double number = 0;
    int line = 0;
    std::size_t begin = 0; ///< first byte in the text
    std::size_t end = 0;   ///< one past the last byte
};

/// Cuts text into lexemes by OpenFOAM's rules; comments and blanks fall away.
class Lexer
{
public:
    /// \param file as messages show it. The text must outlive the lexer.
    Lexer(std::string_view text, std::string file);

    /// \throws Error(input) for an open comment or string, a number no double holds, a character that means nothing.
    Lexeme next();
    const Lexeme& peek();

    /// The raw text between a '{' that is next and its '}' (for #eval{ ... }).
    std::string bracedText();

    /// Line of what was read last, and the byte behind it.
    int line() const { return line_; }
    std::size_t end() const { return end_; }

private:
    char at(std::size_t position) const { return position < text_.size() ? text_[position] : '\0'; }
    void skipBlanks();
    Lexeme read();
    void readString(Lexeme& lexeme);
    void readMacro(Lexeme& lexeme);
    void readDirective(Lexeme& lexeme);
    void readWordOrNumber(Lexeme& lexeme);
    [[noreturn]] void fail(int line, const std::string& what, const std::string& advice = "") const;

    std::string_view text_;
    std::string file_;
    std::size_t here_ = 0;
    int lineHere_ = 1; ///< of the next character
    int line_ = 1;
    std::size_t end_ = 0;
    std::optional<Lexeme> peeked_;
};

/// The number that the whole text spells as OpenFOAM writes numbers (1, -.5, +1e-3), or nothing; nan and inf are words.
/// Too large or too small for a double comes back as infinity.
std::optional<double> numberFrom(std::string_view text);

} // namespace isph
