#include "dictionary/Parser.hpp"

#include "dictionary/KeyPattern.hpp"
#include "dictionary/readText.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace isph
{

namespace
{

// What no honest dictionary reaches: limits that keep hostile text from costing time, memory or stack.
constexpr std::size_t mostEntries = 10'000;
constexpr std::size_t mostPatterns = 100;
constexpr std::size_t mostTokens = 1'000'000;
constexpr std::size_t mostInherited = 1'000'000;
constexpr std::size_t deepestNesting = 64;

std::size_t depthOf(const Dictionary& dictionary)
{
    std::size_t deepest = 0;
    for (const Entry& entry : dictionary.entries())
    {
        if (entry.isDictionary()) { deepest = std::max(deepest, depthOf(entry.dictionary())); }
    }
    return deepest + 1;
}

} // namespace

Dictionary Dictionary::read(const std::filesystem::path& file, const std::string& shownAs)
{
    const Parser::Source source{shownAs.empty() ? file.string() : shownAs, file,
                                file.has_parent_path() ? file.parent_path() : std::filesystem::path(".")};
    return Parser().parse(readText(file, Origin{source.shownAs, 0, ""}), source);
}

Dictionary Dictionary::parse(std::string_view text, const std::string& shownAs, const std::filesystem::path& folder)
{
    return Parser().parse(text, Parser::Source{shownAs, "", folder});
}

Dictionary Parser::parse(std::string_view text, const Source& source)
{
    Dictionary root(Origin{source.shownAs, 0, ""});
    scopes_.push_back(&root);
    parseText(text, source, root);
    inheritConstants(root, {});
    return root;
}

Origin Parser::here(int line, std::string_view keyword) const
{
    return Origin{sources_.back().shownAs, line, keyword.empty() ? "" : scopes_.back()->scopedName(keyword)};
}

void Parser::fail(int line, const std::string& what, const std::string& advice) const
{
    failAt(here(line), what, advice);
}

void Parser::failAt(const Origin& origin, const std::string& what, const std::string& advice) const
{
    throw Error(Fault::input, origin, what, advice);
}

void Parser::parseText(std::string_view text, const Source& source, Dictionary& target)
{
    if (text.size() > largestText)
    {
        failAt(Origin{source.shownAs, 0, ""}, fmt::format("is larger than {} bytes", largestText));
    }
    Lexer lexer(text, source.shownAs);
    Lexer* const outer = std::exchange(lexer_, &lexer);
    sources_.push_back(source);
    parseStatements(target, nullptr);
    sources_.pop_back();
    lexer_ = outer;
}

void Parser::parseStatements(Dictionary& target, const Lexeme* openBrace)
{
    std::vector<int> conditions; // lines of the #if whose branch is being read
    for (;;)
    {
        const Lexeme lexeme = lexer_->next();
        switch (lexeme.kind)
        {
        case Lexeme::Kind::end:
            if (openBrace != nullptr) { fail(openBrace->line, "opens a '{' that is never closed"); }
            [[fallthrough]];
        case Lexeme::Kind::closeBrace:
            if (!conditions.empty()) { fail(conditions.back(), "has an #if without its #endif"); }
            if (openBrace == nullptr && lexeme.kind == Lexeme::Kind::closeBrace)
            {
                fail(lexeme.line, "has a '}' without its '{'");
            }
            return;
        case Lexeme::Kind::semicolon:
            break; // OpenFOAM lets stray ones pass
        case Lexeme::Kind::directive:
            executeDirective(lexeme, target, conditions);
            break;
        case Lexeme::Kind::macro:
            parseMacroStatement(lexeme, target);
            break;
        case Lexeme::Kind::word:
        case Lexeme::Kind::string:
            parseEntry(lexeme, target);
            break;
        case Lexeme::Kind::openBrace:
            fail(lexeme.line, "has a '{' without a name in front of it");
        case Lexeme::Kind::number:
        case Lexeme::Kind::bracket:
            fail(lexeme.line, fmt::format("has '{}' where a key should be", lexeme.text),
                 "an entry is written: key value;");
        }
    }
}

void Parser::parseEntry(const Lexeme& key, Dictionary& target)
{
    const bool pattern = key.kind == Lexeme::Kind::string;
    const Origin origin = here(key.line, key.text);
    if (pattern)
    {
        if (const auto fault = KeyPattern::fault(key.text)) { failAt(origin, *fault); }
        if (++patterns_ > mostPatterns)
        {
            failAt(origin, fmt::format("is one of more than {} patterns", mostPatterns));
        }
    }
    if (lexer_->peek().kind == Lexeme::Kind::openBrace)
    {
        Dictionary block = parseBlock(key.text);
        // A header describes its own file, not the one that includes it.
        if (key.text != "FoamFile" || sources_.size() == 1)
        {
            add(Entry(key.text, pattern, origin, std::move(block)), target);
        }
        return;
    }
    if (lexer_->peek().kind == Lexeme::Kind::macro)
    {
        // key $name; copies a dictionary.
        const Lexeme macro = lexer_->peek();
        const Entry* source = macroEntry(macro.text);
        if (source != nullptr && source->isDictionary())
        {
            lexer_->next();
            if (lexer_->next().kind != Lexeme::Kind::semicolon) { failAt(origin, "needs a ';' behind the dictionary"); }
            count(*source);
            Dictionary copy(here(macro.line, key.text));
            for (const Entry& entry : source->dictionary().entries()) { copy.set(entry); }
            add(Entry(key.text, pattern, origin, std::move(copy)), target);
            return;
        }
    }
    add(Entry(key.text, pattern, origin, parseValue(key.text, key.line)), target);
}

Dictionary Parser::parseBlock(const std::string& keyword)
{
    const Lexeme brace = lexer_->next();
    if (scopes_.size() >= deepestNesting) { fail(brace.line, "nests its dictionaries too deeply"); }
    Dictionary block(here(brace.line, keyword));
    scopes_.push_back(&block);
    parseStatements(block, &brace);
    scopes_.pop_back();
    return block;
}

std::vector<Token> Parser::parseValue(const std::string& keyword, int line)
{
    const Origin origin = here(line, keyword);
    std::vector<Token> tokens;
    std::string open; // brackets still to be closed
    for (;;)
    {
        const Lexeme lexeme = lexer_->next();
        const int lastLine = tokens.empty() ? line : tokens.back().line;
        switch (lexeme.kind)
        {
        case Lexeme::Kind::semicolon:
            if (!open.empty()) { failAt(origin, fmt::format("ends before its '{}'", open.back())); }
            countTokens(tokens.size(), line);
            return tokens;
        case Lexeme::Kind::word:
            tokens.push_back({Token::Kind::word, lexeme.text, 0, lexeme.line});
            break;
        case Lexeme::Kind::string:
            tokens.push_back({Token::Kind::string, lexeme.text, 0, lexeme.line});
            break;
        case Lexeme::Kind::number:
            tokens.push_back({Token::Kind::number, lexeme.text, lexeme.number, lexeme.line});
            break;
        case Lexeme::Kind::bracket:
            if (lexeme.text == "(" || lexeme.text == "[") { open += lexeme.text == "(" ? ')' : ']'; }
            else if (!open.empty() && open.back() == lexeme.text[0]) { open.pop_back(); }
            else { failAt(origin, fmt::format("has a '{}' too many", lexeme.text)); }
            tokens.push_back({Token::Kind::bracket, lexeme.text, 0, lexeme.line});
            break;
        case Lexeme::Kind::macro:
            for (Token& token : expandMacro(lexeme)) { tokens.push_back(std::move(token)); }
            break;
        case Lexeme::Kind::directive:
            if (lexeme.text != "eval" && lexeme.text != "calc")
            {
                failAt(origin, fmt::format("has #{} in its value", lexeme.text), "only #eval may stand there");
            }
            tokens.push_back(valueOfEval(lexeme.line));
            break;
        case Lexeme::Kind::openBrace:
            failAt(origin, "has a '{' in its value",
                   fmt::format("is the ';' missing at the end of line {}?", lastLine));
        case Lexeme::Kind::closeBrace:
        case Lexeme::Kind::end:
            failAt(origin, fmt::format("has no ';' at its end (line {})", lastLine));
        }
        if (tokens.size() > mostTokens) { countTokens(tokens.size(), line); }
    }
}

void Parser::add(Entry entry, Dictionary& target)
{
    if (++entries_ > mostEntries)
    {
        failAt(entry.origin(), fmt::format("is one of more than {} entries", mostEntries));
    }
    const auto sameKey = [&entry](const Entry& other)
    { return other.keyword() == entry.keyword() && other.isPattern() == entry.isPattern(); };
    const bool exists = mode_ != InputMode::merge && std::ranges::any_of(target.entries(), sameKey);
    if (exists && mode_ == InputMode::protect) { return; }
    if (exists && mode_ == InputMode::error)
    {
        failAt(entry.origin(), "is given a second time", "#inputMode error allows every key once");
    }
    if (exists && mode_ == InputMode::overwrite) { target.remove(entry.keyword()); }
    target.set(std::move(entry));
}

void Parser::count(const Entry& entry)
{
    if (!entry.isDictionary())
    {
        countTokens(entry.tokens().size(), 0);
        return;
    }
    if (scopes_.size() + depthOf(entry.dictionary()) > deepestNesting)
    {
        failAt(entry.origin(), "is copied into too deep a nest of dictionaries");
    }
    entries_ += entry.dictionary().entries().size();
    if (entries_ > mostEntries)
    {
        failAt(entry.origin(), fmt::format("is copied until there are more than {} entries", mostEntries));
    }
    for (const Entry& inner : entry.dictionary().entries()) { count(inner); }
}

void Parser::countTokens(std::size_t number, int line)
{
    tokens_ += number;
    if (tokens_ > mostTokens) { fail(line, fmt::format("holds more than {} words", mostTokens)); }
}

void Parser::inheritConstants(Dictionary& dictionary, const std::vector<std::pair<std::string, double>>& outer)
{
    inherited_ += outer.size();
    if (inherited_ > mostInherited) { failAt(dictionary.origin(), "sees too many numbers of its parents"); }
    dictionary.inherited_ = outer;
    std::vector<std::pair<std::string, double>> inner;
    for (Entry& entry : dictionary.entries_)
    {
        if (!entry.isDictionary()) { continue; }
        if (inner.empty())
        {
            inner = outer;
            for (const Entry& sibling : dictionary.entries_)
            {
                if (const auto value = scalarValue(sibling)) { inner.emplace_back(sibling.keyword(), *value); }
            }
        }
        inheritConstants(entry.dictionary(), inner);
    }
}

} // namespace isph
