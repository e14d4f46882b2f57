#include "dictionary/Parser.hpp"

#include "core/nearestWord.hpp"
#include "dictionary/KeyPattern.hpp"
#include "dictionary/readText.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace isph
{

namespace fs = std::filesystem;

namespace
{

constexpr std::size_t mostIncluded = 1000;
constexpr std::size_t deepestInclude = 32;

bool isThere(const fs::path& file)
{
    std::error_code ignored;
    return fs::exists(file, ignored);
}

bool sameFile(const fs::path& a, const fs::path& b)
{
    std::error_code ignored;
    return fs::equivalent(a, b, ignored);
}

} // namespace

void Parser::executeDirective(const Lexeme& directive, Dictionary& target, std::vector<int>& conditions)
{
    const std::string& name = directive.text;
    if (name == "include" || name == "includeIfPresent" || name == "sinclude" || name == "includeEtc")
    {
        include(directive, target);
    }
    else if (name == "inputMode") { setInputMode(directive.line); }
    else if (name == "remove") { removeEntries(directive.line, target); }
    else if (name == "if" || name == "ifeq")
    {
        // A branch that is not taken is skipped up to #else (then that one is read) or #endif.
        if (condition(directive) || skipBranch(directive.line, true)) { conditions.push_back(directive.line); }
    }
    else if (name == "else" || name == "endif")
    {
        if (conditions.empty()) { fail(directive.line, fmt::format("has an #{} without its #if", name)); }
        if (name == "else") { skipBranch(directive.line, false); }
        conditions.pop_back();
    }
    else if (name == "eval" || name == "calc")
    {
        fail(directive.line, fmt::format("has #{} where a key should be", name), "write: key #eval{ ... };");
    }
    else
    {
        const std::vector<std::string> known = {
            "include", "includeIfPresent", "includeEtc", "inputMode", "remove", "if", "ifeq", "else", "endif", "eval",
            "calc"};
        fail(directive.line, fmt::format("has the unknown directive #{}", name),
             fmt::format("known are: {}", listOfWords(name, known)));
    }
}

fs::path Parser::caseFolder() const
{
    // Messages show system/schemes for a file in <case>/system: as many folders up as the shown name has; without a
    // case in sight, one.
    const Source& outermost = sources_.front();
    fs::path folder = fs::absolute(outermost.folder).lexically_normal();
    if (!folder.has_filename()) { folder = folder.parent_path(); } // a slash at the end
    fs::path shown = fs::path(outermost.shownAs).parent_path();
    if (shown.is_absolute()) { return folder.parent_path(); }
    for (; !shown.empty(); shown = shown.parent_path()) { folder = folder.parent_path(); }
    return folder;
}

void Parser::include(const Lexeme& directive, Dictionary& target)
{
    const Lexeme argument = lexer_->next();
    if (argument.kind != Lexeme::Kind::string && argument.kind != Lexeme::Kind::word)
    {
        fail(directive.line, fmt::format("has an #{} without a file", directive.text),
             fmt::format("write #{} \"file\"", directive.text));
    }
    const Source& includer = sources_.back();
    if (includer.folder.empty()) { fail(directive.line, fmt::format("may not #{} a file here", directive.text)); }

    std::string name = withMacros(argument.text, argument.line, false);
    const bool etc = directive.text == "includeEtc" || name.starts_with("<etc>/");
    fs::path folder = includer.folder;
    fs::path shownIn = fs::path(includer.shownAs).parent_path();
    for (const auto& [tag, place] : {std::pair("<case>/", ""), std::pair("<constant>/", "constant"),
                                     std::pair("<system>/", "system"), std::pair("<etc>/", "etc")})
    {
        if (!name.starts_with(tag)) { continue; }
        name = name.substr(std::string_view(tag).size());
        folder = caseFolder() / place;
        shownIn = place;
    }
    const fs::path file = etc ? findEtcFile(name) : folder / name;
    const std::string shownAs = etc ? "etc/" + name : (shownIn / name).lexically_normal().string();
    if (etc && file.empty())
    {
        fail(directive.line, fmt::format("includes etc/{}, which does not exist", name),
             "etc is looked for beside the programs and in $CONTINUA_ETC");
    }
    if (!isThere(file))
    {
        if (directive.text != "include") { return; }
        fail(directive.line, fmt::format("includes {}, which does not exist", shownAs));
    }
    const auto open =
        std::ranges::find_if(sources_, [&file](const Source& source) { return sameFile(source.file, file); });
    if (open != sources_.end())
    {
        std::string chain;
        for (auto source = open; source != sources_.end(); ++source) { chain += source->shownAs + " -> "; }
        fail(directive.line, fmt::format("includes itself: {}{}", chain, open->shownAs));
    }
    if (sources_.size() >= deepestInclude || ++included_ > mostIncluded)
    {
        fail(directive.line, "includes too many files");
    }

    parseText(readText(file, here(directive.line)), Source{shownAs, file, file.parent_path()}, target);
}

void Parser::setInputMode(int line)
{
    const Lexeme mode = lexer_->next();
    if (mode.text == "merge" || mode.text == "default") { mode_ = InputMode::merge; }
    else if (mode.text == "overwrite") { mode_ = InputMode::overwrite; }
    else if (mode.text == "protect" || mode.text == "warn") { mode_ = InputMode::protect; }
    else if (mode.text == "error") { mode_ = InputMode::error; }
    else
    {
        fail(line, fmt::format("has the unknown #inputMode '{}'", mode.text),
             "known are: merge, overwrite, protect, warn, error, default");
    }
}

void Parser::removeEntries(int line, Dictionary& target)
{
    std::vector<Lexeme> names;
    const auto isName = [](const Lexeme& lexeme)
    { return lexeme.kind == Lexeme::Kind::word || lexeme.kind == Lexeme::Kind::string; };
    Lexeme lexeme = lexer_->next();
    if (isName(lexeme)) { names.push_back(lexeme); }
    else if (lexeme.text == "(" && lexeme.kind == Lexeme::Kind::bracket)
    {
        for (lexeme = lexer_->next(); isName(lexeme); lexeme = lexer_->next()) { names.push_back(lexeme); }
        if (lexeme.text != ")") { fail(line, "has a #remove whose list is not closed"); }
    }
    if (names.empty())
    {
        fail(line, "has a #remove without a name", "write #remove name or #remove (name1 \"name.*\")");
    }

    for (const Lexeme& name : names)
    {
        target.remove(name.text);
        if (name.kind == Lexeme::Kind::word) { continue; }
        if (const auto fault = KeyPattern::fault(name.text))
        {
            fail(line, fmt::format("#remove \"{}\" {}", name.text, *fault));
        }
        const KeyPattern pattern(name.text);
        std::vector<std::string> matching;
        for (const Entry& entry : target.entries())
        {
            if (pattern.matches(entry.keyword())) { matching.push_back(entry.keyword()); }
        }
        for (const std::string& keyword : matching) { target.remove(keyword); }
    }
}

std::vector<Token> Parser::parseToken(const std::string& directive, int line)
{
    const Lexeme lexeme = lexer_->next();
    switch (lexeme.kind)
    {
    case Lexeme::Kind::word:
        return {Token{Token::Kind::word, lexeme.text, 0, line}};
    case Lexeme::Kind::string:
        return {Token{Token::Kind::string, withMacros(lexeme.text, line, false), 0, line}};
    case Lexeme::Kind::number:
        return {Token{Token::Kind::number, lexeme.text, lexeme.number, line}};
    case Lexeme::Kind::macro:
        return expandMacro(lexeme);
    case Lexeme::Kind::directive:
        if (lexeme.text == "eval" || lexeme.text == "calc") { return {valueOfEval(line)}; }
        [[fallthrough]];
    default:
        fail(line, fmt::format("has an #{} without a condition", directive));
    }
}

bool Parser::condition(const Lexeme& directive)
{
    const std::vector<Token> left = parseToken(directive.text, directive.line);
    if (directive.text == "ifeq")
    {
        const std::vector<Token> right = parseToken(directive.text, directive.line);
        return std::ranges::equal(left, right,
                                  [](const Token& a, const Token& b)
                                  {
                                      const bool numbers =
                                          a.kind == Token::Kind::number && b.kind == Token::Kind::number;
                                      return numbers ? a.number == b.number : a.text == b.text;
                                  });
    }
    if (left.size() == 1)
    {
        const Token& token = left[0];
        if (token.kind == Token::Kind::number) { return token.number != 0; }
        if (token.text == "yes" || token.text == "on" || token.text == "true") { return true; }
        if (token.text == "no" || token.text == "off" || token.text == "false") { return false; }
    }
    fail(directive.line, "has an #if whose condition is neither yes, no nor a number");
}

bool Parser::skipBranch(int line, bool stopAtElse)
{
    int depth = 0;
    for (;;)
    {
        const Lexeme lexeme = lexer_->next();
        if (lexeme.kind == Lexeme::Kind::end) { fail(line, "has an #if without its #endif"); }
        if (lexeme.kind != Lexeme::Kind::directive) { continue; }
        if (lexeme.text == "if" || lexeme.text == "ifeq") { ++depth; }
        else if (lexeme.text == "endif" && depth-- == 0) { return false; }
        else if (lexeme.text == "else" && depth == 0 && stopAtElse) { return true; }
    }
}

} // namespace isph
