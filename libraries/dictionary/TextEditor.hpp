#pragma once

#include "dictionary/Dictionary.hpp"
#include "dictionary/Lexer.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isph
{

/// Changes entries in the text of a dictionary and leaves everything else, comments and layout included, as it is.
///
/// Keys are scoped, "kernel.order" or "kernel/order"; a part in quotes is a pattern: boundaryField."x(Min|Max)".type.
/// After every change the text is read again: a change that would not parse, or would not be seen (#inputMode protect,
/// say), throws Error(input) and is not made.
class TextEditor
{
public:
    /// \param folder what #include is relative to
    /// \throws Error(input) if the text does not parse.
    TextEditor(std::string text, std::string shownAs, std::filesystem::path folder);

    /// Gives an entry another value, "2", "(1 0 0)" or "{ a 1; }"; adds the entry if there is none.
    /// \throws Error(input) if the dictionary that it would be in does not exist.
    void set(const std::string& key, const std::string& value);

    /// \throws Error(input) if there is one already.
    void add(const std::string& key, const std::string& value);

    /// Removes an entry, wherever it is given in this text.
    /// \throws Error(input) if there is none, or if it comes from an included file or a macro.
    void remove(const std::string& key);

    const std::string& text() const { return text_; }
    const Dictionary& dictionary() const { return dictionary_; }

    /// The entry of a scoped key, for reading.
    /// \throws Error(input) naming the nearest key if there is none.
    const Entry& entry(const std::string& key) const;

private:
    /// Where an entry stands in the text.
    struct Span
    {
        std::string keyword;
        bool pattern = false;
        bool isDictionary = false;
        std::size_t begin = 0;      ///< of the keyword
        std::size_t valueBegin = 0; ///< behind the keyword, where there is no value; else of the value or the '{'
        std::size_t valueEnd = 0;   ///< before the ';', or behind the '}'
        std::size_t end = 0;        ///< behind the ';' or the '}'
        std::vector<Span> entries;
    };

    /// A part of a key, as looked for.
    struct Name
    {
        std::string keyword;
        bool pattern = false;
    };

    static Span scan(const std::string& text, const std::string& shownAs);
    static void scanEntries(Lexer& lexer, Span& block);
    static Span scanEntry(Lexer& lexer, const Lexeme& key);
    static void skipDirective(Lexer& lexer, const Lexeme& directive);

    std::vector<Name> namesOf(const std::string& key) const;
    static void collect(const Span& block, const std::vector<Name>& names, std::size_t depth,
                        std::vector<const Span*>& found);
    std::string inserted(const Span& block, bool whole, const std::string& key, const std::string& value) const;
    void replace(std::string text, const std::string& key, bool expected);

    std::string text_;
    std::string shownAs_;
    std::filesystem::path folder_;
    Dictionary dictionary_;
};

} // namespace isph
