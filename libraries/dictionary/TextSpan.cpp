#include "dictionary/TextSpan.hpp"

#include <algorithm>
#include <utility>

namespace isph
{

namespace
{

TextSpan scanEntry(Lexer& lexer, const Lexeme& key);
void skipDirective(Lexer& lexer, const Lexeme& directive);

void scanEntries(Lexer& lexer, TextSpan& block)
{
    for (;;)
    {
        const Lexeme lexeme = lexer.next();
        block.valueEnd = std::max(block.valueEnd, lexeme.kind == Lexeme::Kind::end ? 0 : lexeme.end);
        switch (lexeme.kind)
        {
        case Lexeme::Kind::closeBrace:
        case Lexeme::Kind::end:
            return;
        case Lexeme::Kind::directive:
            skipDirective(lexer, lexeme);
            break;
        case Lexeme::Kind::semicolon:
            break;
        case Lexeme::Kind::macro:
            if (lexer.peek().kind != Lexeme::Kind::semicolon) { scanEntry(lexer, lexeme); }
            break;
        default:
            block.entries.push_back(scanEntry(lexer, lexeme));
            break;
        }
        if (!block.entries.empty()) { block.valueEnd = std::max(block.valueEnd, block.entries.back().end); }
    }
}

TextSpan scanEntry(Lexer& lexer, const Lexeme& key)
{
    TextSpan span;
    span.keyword = key.text;
    span.pattern = key.kind == Lexeme::Kind::string;
    span.begin = key.begin;
    span.valueBegin = key.end;
    span.valueEnd = key.end;
    if (lexer.peek().kind == Lexeme::Kind::openBrace)
    {
        span.isDictionary = true;
        span.valueBegin = lexer.next().begin;
        scanEntries(lexer, span);
        span.end = span.valueEnd;
        return span;
    }
    bool first = true;
    for (;;)
    {
        if (lexer.peek().kind == Lexeme::Kind::openBrace) // of #eval{ }
        {
            lexer.bracedText();
            span.valueEnd = lexer.end();
        }
        const Lexeme lexeme = lexer.next();
        if (lexeme.kind == Lexeme::Kind::semicolon || lexeme.kind == Lexeme::Kind::end)
        {
            span.end = lexeme.end;
            return span;
        }
        if (std::exchange(first, false)) { span.valueBegin = lexeme.begin; }
        span.valueEnd = lexeme.end;
    }
}

void skipDirective(Lexer& lexer, const Lexeme& directive)
{
    const auto skipOperand = [&lexer]
    {
        const Lexeme operand = lexer.next();
        if (operand.kind != Lexeme::Kind::directive) { return; }
        if (lexer.peek().kind == Lexeme::Kind::openBrace) { lexer.bracedText(); }
        else { lexer.next(); }
    };
    if (directive.text == "else" || directive.text == "endif") { return; }
    if (directive.text == "remove" && lexer.peek().kind == Lexeme::Kind::bracket)
    {
        // Branches of an #if that are not taken need not even parse, so the list may be open.
        for (Lexeme name = lexer.next(); name.text != ")" && name.kind != Lexeme::Kind::end; name = lexer.next()) {}
        return;
    }
    skipOperand();
    if (directive.text == "ifeq") { skipOperand(); }
}

void collect(const TextSpan& block, std::span<const SpanName> names, std::vector<const TextSpan*>& found)
{
    for (const TextSpan& span : block.entries)
    {
        if (span.keyword != names[0].keyword || span.pattern != names[0].pattern) { continue; }
        if (names.size() == 1) { found.push_back(&span); }
        else if (span.isDictionary) { collect(span, names.subspan(1), found); }
    }
}

} // namespace

TextSpan scanText(const std::string& text, const std::string& shownAs)
{
    Lexer lexer(text, shownAs);
    TextSpan root;
    root.isDictionary = true;
    scanEntries(lexer, root);
    root.end = text.size();
    return root;
}

std::vector<const TextSpan*> findSpans(const TextSpan& root, std::span<const SpanName> names)
{
    std::vector<const TextSpan*> found;
    collect(root, names, found);
    return found;
}

} // namespace isph
