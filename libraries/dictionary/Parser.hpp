#pragma once

#include "dictionary/Dictionary.hpp"
#include "dictionary/Lexer.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace isph
{

/// Reads one dictionary, with all that it includes. Macros and directives are expanded as they come, by what was read
/// up to there (as in OpenFOAM).
class Parser
{
public:
    /// A text and where it comes from.
    struct Source
    {
        std::string shownAs;          ///< in messages
        std::filesystem::path file;   ///< empty for text that is no file
        std::filesystem::path folder; ///< that #include is relative to; empty: nothing may be included
    };

    Dictionary parse(std::string_view text, const Source& source);

private:
    enum class InputMode
    {
        merge,
        overwrite,
        protect,
        error
    };

    // Statements (Parser.cpp)
    void parseText(std::string_view text, const Source& source, Dictionary& target);
    void parseStatements(Dictionary& target, const Lexeme* openBrace);
    void parseEntry(const Lexeme& key, Dictionary& target);
    Dictionary parseBlock(const std::string& keyword);
    std::vector<Token> parseValue(const std::string& keyword, int line);
    void add(Entry entry, Dictionary& target);
    void count(const Entry& entry);
    void countTokens(std::size_t number, int line);

    // Macros (macros.cpp)
    void parseMacroStatement(const Lexeme& macro, Dictionary& target);
    std::vector<Token> expandMacro(const Lexeme& macro);
    Entry* macroEntry(std::string_view name);
    Entry* findOutwards(std::string_view key, std::size_t scope) const;
    Entry* findDotted(std::string_view name, std::size_t scope, bool outwards) const;
    std::string withMacros(std::string_view text, int line, bool numbers);
    Token valueOfEval(int line);

    // Directives (directives.cpp)
    void executeDirective(const Lexeme& directive, Dictionary& target, std::vector<int>& conditions);
    void include(const Lexeme& directive, Dictionary& target);
    std::filesystem::path caseFolder() const;
    void setInputMode(int line);
    void removeEntries(int line, Dictionary& target);
    std::vector<Token> parseToken(const std::string& directive, int line);
    bool condition(const Lexeme& directive);
    bool skipBranch(int line, bool stopAtElse);

    Origin here(int line, std::string_view keyword = "") const;
    [[noreturn]] void fail(int line, const std::string& what, const std::string& advice = "") const;
    [[noreturn]] void failAt(const Origin& origin, const std::string& what, const std::string& advice = "") const;
    void inheritConstants(Dictionary& dictionary, const std::vector<std::pair<std::string, double>>& outer);

    Lexer* lexer_ = nullptr;          ///< of the innermost file
    std::vector<Source> sources_;     ///< the file being read, behind those that include it
    std::vector<Dictionary*> scopes_; ///< the dictionary being read, behind its parents
    InputMode mode_ = InputMode::merge;
    std::size_t entries_ = 0; ///< made so far, macros included
    std::size_t tokens_ = 0;
    std::size_t patterns_ = 0;
    std::size_t macros_ = 0;
    std::size_t inherited_ = 0;
    std::size_t included_ = 0;
};

} // namespace isph
