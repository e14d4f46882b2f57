#include "dictionary/TextEditor.hpp"

#include "core/nearestWord.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace isph
{

namespace
{

/// The parts of "a.b", "a/b" or "a."b.*".c", quotes and all.
std::vector<std::string> split(const std::string& key)
{
    std::vector<std::string> parts(1);
    bool quoted = false;
    int open = 0;
    for (const char c : key)
    {
        if (c == '"') { quoted = !quoted; }
        if (c == '(') { ++open; }
        if (c == ')') { --open; }
        if ((c == '.' || c == '/') && !quoted && open <= 0) { parts.emplace_back(); }
        else { parts.back() += c; }
    }
    return parts;
}

std::string withoutBlanks(const std::string& text)
{
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// A value as typed on a command line: without its semicolon, and one value only.
std::string checkedValue(const std::string& written, const std::string& shownAs, const std::string& key)
{
    const Origin origin{shownAs, 0, key};
    std::string value = withoutBlanks(written);
    if (value.ends_with(';')) { value = withoutBlanks(value.substr(0, value.size() - 1)); }
    Lexer lexer(value, "the new value of " + key);
    int depth = 0;
    bool ended = false;
    for (Lexeme lexeme = lexer.next(); lexeme.kind != Lexeme::Kind::end; lexeme = lexer.next())
    {
        if (ended) { throw Error(Fault::input, origin, "cannot be set to more than one value", "quote it as a whole"); }
        if (lexeme.kind == Lexeme::Kind::openBrace) { ++depth; }
        if (lexeme.kind == Lexeme::Kind::closeBrace) { --depth; }
        if (depth < 0 || (depth == 0 && lexeme.kind == Lexeme::Kind::semicolon))
        {
            throw Error(Fault::input, origin, fmt::format("cannot be set to {}", value), "give one value");
        }
        ended = depth == 0 && lexeme.kind == Lexeme::Kind::closeBrace && value.starts_with('{');
    }
    if (depth > 0) { throw Error(Fault::input, origin, fmt::format("cannot be set to {}", value), "close its '{'"); }
    // A comment at the end would swallow the semicolon.
    return value.find("//") == std::string::npos ? value : value + '\n';
}

std::string entryText(const std::string& key, const std::string& value, bool aligned)
{
    if (value.starts_with('{')) { return fmt::format("{} {}", key, value); }
    const std::size_t blanks = aligned && key.size() < 16 ? 16 - key.size() : 1;
    return value.empty() ? key + ";" : fmt::format("{}{}{};", key, std::string(blanks, ' '), value);
}

} // namespace

TextEditor::TextEditor(std::string text, std::string shownAs, std::filesystem::path folder)
    : text_(std::move(text)),
      shownAs_(std::move(shownAs)),
      folder_(std::move(folder)),
      dictionary_(Dictionary::parse(text_, shownAs_, folder_))
{
}

TextEditor::Span TextEditor::scan(const std::string& text, const std::string& shownAs)
{
    Lexer lexer(text, shownAs);
    Span root;
    root.isDictionary = true;
    scanEntries(lexer, root);
    root.end = text.size();
    return root;
}

void TextEditor::scanEntries(Lexer& lexer, Span& block)
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

TextEditor::Span TextEditor::scanEntry(Lexer& lexer, const Lexeme& key)
{
    Span span;
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

void TextEditor::skipDirective(Lexer& lexer, const Lexeme& directive)
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
        while (lexer.next().text != ")") {}
        return;
    }
    skipOperand();
    if (directive.text == "ifeq") { skipOperand(); }
}

std::vector<TextEditor::Name> TextEditor::namesOf(const std::string& key) const
{
    // Keywords may hold dots; where the dictionary knows a longer keyword, that is meant.
    const std::vector<std::string> parts = split(key);
    std::vector<Name> names;
    const Dictionary* scope = &dictionary_;
    for (std::size_t i = 0; i < parts.size();)
    {
        const auto bare = [](std::string text)
        {
            std::erase(text, '"');
            return text;
        };
        std::string keyword = bare(parts[i]);
        bool pattern = parts[i].starts_with('"');
        std::size_t next = i + 1;
        std::string longer = keyword;
        for (std::size_t j = i + 1; j < parts.size() && scope != nullptr && !scope->has(keyword); ++j)
        {
            longer += '.' + bare(parts[j]);
            if (scope->has(longer))
            {
                keyword = longer;
                next = j + 1;
            }
        }
        const Entry* entry = scope != nullptr ? scope->find(keyword) : nullptr;
        if (entry != nullptr && entry->keyword() == keyword) { pattern = entry->isPattern(); }
        scope = entry != nullptr && entry->isDictionary() ? &entry->dictionary() : nullptr;
        names.push_back({std::move(keyword), pattern});
        i = next;
    }
    return names;
}

void TextEditor::collect(const Span& block, const std::vector<Name>& names, std::size_t depth,
                         std::vector<const Span*>& found)
{
    for (const Span& span : block.entries)
    {
        if (span.keyword != names[depth].keyword || span.pattern != names[depth].pattern) { continue; }
        if (depth + 1 == names.size()) { found.push_back(&span); }
        else if (span.isDictionary) { collect(span, names, depth + 1, found); }
    }
}

const Entry& TextEditor::entry(const std::string& key) const
{
    std::string plain = key;
    std::erase(plain, '"');
    if (const Entry* found = dictionary_.findScoped(plain)) { return *found; }

    // Name the nearest key of the innermost dictionary that does exist.
    const Dictionary* scope = &dictionary_;
    std::string missing;
    for (const Name& name : namesOf(key))
    {
        missing = name.keyword;
        const Entry* inner = scope->find(name.keyword);
        if (inner == nullptr || !inner->isDictionary()) { break; }
        scope = &inner->dictionary();
    }
    std::vector<std::string> present;
    for (const Entry& candidate : scope->entries()) { present.push_back(candidate.keyword()); }
    const auto nearest = nearestWord(missing, present);
    throw Error(Fault::input, Origin{shownAs_, scope->origin().line, key}, "does not exist",
                nearest ? fmt::format("did you mean {}?", scope->scopedName(*nearest)) : "");
}

std::string TextEditor::inserted(const Span& block, bool whole, const std::string& key, const std::string& value) const
{
    std::string result = text_;
    const std::string entry = entryText(key, value, true);
    const std::size_t closing = block.valueEnd - 1; // the '}', where the block is not the whole text
    const std::size_t lastEnd = block.entries.empty() ? block.valueBegin + 1 : block.entries.back().end;
    const bool oneLine = !whole && text_.find('\n', block.valueBegin) >= closing;
    if (oneLine)
    {
        const bool blank = text_[closing - 1] == ' ';
        return result.insert(closing, fmt::format("{}{} ", blank ? "" : " ", entryText(key, value, false)));
    }
    if (!whole)
    {
        // On a line of its own, in front of the line of the brace.
        const std::size_t lineBegin = text_.rfind('\n', closing) + 1;
        const std::size_t margin = text_.find_first_not_of(" \t", lineBegin) - lineBegin;
        const bool braceAlone = lineBegin + margin == closing;
        const std::string indent(margin + 4, ' ');
        if (braceAlone) { return result.insert(lineBegin, fmt::format("{}{}\n", indent, entry)); }
        return result.insert(lastEnd, fmt::format("\n{}{}", indent, entry));
    }
    // At the end, but before a closing comment line such as OpenFOAM's row of stars.
    std::size_t place = block.valueEnd;
    const std::size_t lineEnd = std::min(text_.find('\n', place), text_.size());
    if (text_.find("/*", place) >= lineEnd) { place = lineEnd; }
    return result.insert(place, fmt::format("\n{}{}", entry, place == text_.size() ? "\n" : ""));
}

void TextEditor::replace(std::string text, const std::string& key, bool expected)
{
    Dictionary changed = Dictionary::parse(text, shownAs_, folder_);
    std::string plain = key;
    std::erase(plain, '"');
    const bool seen = changed.findScoped(plain) != nullptr;
    if (seen != expected)
    {
        throw Error(Fault::input, Origin{shownAs_, 0, key},
                    expected ? "was set but is not seen" : "comes from a macro, a pattern or an included file",
                    expected ? "look for #inputMode, #remove and #if" : "remove it there");
    }
    text_ = std::move(text);
    dictionary_ = std::move(changed);
}

void TextEditor::set(const std::string& key, const std::string& written)
{
    const std::string value = checkedValue(written, shownAs_, key);
    const std::vector<Name> names = namesOf(key);
    const Span root = scan(text_, shownAs_);
    std::vector<const Span*> spans;
    collect(root, names, 0, spans);
    if (!spans.empty())
    {
        // Given more than once, the one that counts is in the line that the reader took it from.
        std::string plain = key;
        std::erase(plain, '"');
        const Entry* entry = dictionary_.findScoped(plain);
        const Span* chosen = spans.back();
        for (const Span* span : spans)
        {
            const auto line =
                1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(span->begin), '\n');
            if (entry != nullptr && entry->origin().file == shownAs_ && entry->origin().line == line) { chosen = span; }
        }
        const bool block = value.starts_with('{');
        const std::string blank = chosen->valueBegin == chosen->begin + chosen->keyword.size() ? " " : "";
        std::string text = text_;
        const bool keepsSemicolon = !block && !chosen->isDictionary;
        const std::size_t end = keepsSemicolon ? chosen->valueEnd : chosen->end;
        text.replace(chosen->valueBegin, end - chosen->valueBegin,
                     blank + value + (keepsSemicolon || block ? "" : ";"));
        replace(std::move(text), key, true);
        return;
    }

    // The innermost dictionary of the key that stands in this text takes the new entry.
    const std::vector<std::string> parts = split(key);
    const Dictionary* scope = &dictionary_;
    for (std::size_t i = 0; i + 1 < names.size(); ++i)
    {
        const Entry* inner = scope->find(names[i].keyword);
        if (inner == nullptr || !inner->isDictionary())
        {
            throw Error(Fault::input, Origin{shownAs_, scope->origin().line, key},
                        fmt::format("has no dictionary {} to be in", scope->scopedName(names[i].keyword)));
        }
        if (inner->keyword() != names[i].keyword)
        {
            throw Error(Fault::input, Origin{shownAs_, inner->origin().line, key},
                        fmt::format("is given by the pattern \"{}\"", inner->keyword()),
                        "name the pattern, in quotes, or add the dictionary as a whole");
        }
        scope = &inner->dictionary();
    }
    const auto spelled = [](const Name& name) { return name.pattern ? '"' + name.keyword + '"' : name.keyword; };
    std::string missing = value; // with the dictionaries around it that this text does not hold
    for (std::size_t known = names.size() - 1; known > 0; --known)
    {
        const std::vector<Name> outer(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(known));
        std::vector<const Span*> blocks;
        collect(root, outer, 0, blocks);
        std::erase_if(blocks, [](const Span* span) { return !span->isDictionary; });
        if (!blocks.empty())
        {
            replace(inserted(*blocks.back(), false, spelled(names[known]), missing), key, true);
            return;
        }
        missing = fmt::format("{{ {} }}", entryText(spelled(names[known]), missing, false));
    }
    replace(inserted(root, true, spelled(names[0]), missing), key, true);
}

void TextEditor::add(const std::string& key, const std::string& value)
{
    std::string plain = key;
    std::erase(plain, '"');
    const Entry* existing = dictionary_.findScoped(plain);
    if (existing != nullptr && existing->keyword() == namesOf(key).back().keyword)
    {
        throw Error(Fault::input, existing->origin(), "exists already", "use -set to change it");
    }
    set(key, value);
}

void TextEditor::remove(const std::string& key)
{
    static_cast<void>(entry(key)); // names the nearest if there is none
    const Span root = scan(text_, shownAs_);
    std::vector<const Span*> spans;
    collect(root, namesOf(key), 0, spans);
    std::string text = text_;
    for (auto span = spans.rbegin(); span != spans.rend(); ++span)
    {
        // An entry alone on its lines goes with them, and with the comment behind it.
        std::size_t begin = (*span)->begin;
        std::size_t end = (*span)->end;
        const std::size_t lineBegin = begin == 0 ? 0 : text.rfind('\n', begin - 1) + 1;
        const std::size_t lineEnd = std::min(text.find('\n', end), text.size());
        const bool nothingBefore = text.find_first_not_of(" \t", lineBegin) == begin;
        const std::size_t behind = text.find_first_not_of(" \t\r", end);
        if (nothingBefore && (behind >= lineEnd || text.compare(behind, 2, "//") == 0))
        {
            begin = lineBegin;
            end = std::min(lineEnd + 1, text.size());
        }
        else if (behind < lineEnd && text[behind] != '}') { end = behind; }
        text.erase(begin, end - begin);
    }
    replace(std::move(text), key, false);
}

} // namespace isph
