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

std::string withoutQuotes(std::string text)
{
    std::erase(text, '"');
    return text;
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

std::optional<std::vector<SpanName>> TextEditor::resolve(const Dictionary& scope, std::span<const std::string> parts)
{
    const auto nameFrom = [&](std::size_t count)
    {
        const bool quoted = parts[0].starts_with('"');
        std::string text = withoutQuotes(fmt::format("{}", fmt::join(parts.first(count), ".")));
        const Entry* entry = scope.find(text);
        const bool itself = entry != nullptr && entry->keyword() == text;
        return std::pair(SpanName{std::move(text), itself ? entry->isPattern() : quoted}, entry);
    };
    // In the order of Dictionary::findScoped, so that reading and changing mean the same entry.
    for (std::size_t count = 1; count < parts.size(); ++count)
    {
        auto [first, entry] = nameFrom(count);
        if (entry == nullptr || !entry->isDictionary()) { continue; }
        if (auto names = resolve(entry->dictionary(), parts.subspan(count)))
        {
            names->insert(names->begin(), std::move(first));
            return names;
        }
    }
    if (auto [whole, entry] = nameFrom(parts.size()); entry != nullptr) { return std::vector{std::move(whole)}; }
    return std::nullopt;
}

std::vector<SpanName> TextEditor::namesOf(const std::string& key) const
{
    // As much of the key as exists, then its other parts one by one.
    const std::vector<std::string> parts = split(key);
    std::vector<SpanName> names;
    std::size_t known = parts.size();
    for (; known > 0 && names.empty(); --known)
    {
        if (auto resolved = resolve(dictionary_, std::span(parts).first(known)))
        {
            names = std::move(*resolved);
            break;
        }
    }
    for (std::size_t i = known; i < parts.size(); ++i)
    {
        names.push_back({withoutQuotes(parts[i]), parts[i].starts_with('"')});
    }
    return names;
}

const Entry& TextEditor::entry(const std::string& key) const
{
    if (const Entry* found = dictionary_.findScoped(withoutQuotes(key))) { return *found; }

    // Name the nearest key of the innermost dictionary that does exist.
    const Dictionary* scope = &dictionary_;
    std::string missing;
    for (const SpanName& name : namesOf(key))
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

std::string TextEditor::inserted(const TextSpan& block, bool whole, const std::string& key,
                                 const std::string& value) const
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
    const bool seen = changed.findScoped(withoutQuotes(key)) != nullptr;
    if (seen != expected)
    {
        throw Error(Fault::input, Origin{shownAs_, 0, key},
                    expected ? "was set but is not seen" : "comes from a macro, a pattern or an included file",
                    expected ? "look for #inputMode, #remove and #if" : "remove it there");
    }
    text_ = std::move(text);
    dictionary_ = std::move(changed);
}

const TextSpan* TextEditor::spanOf(const std::string& key, const std::vector<const TextSpan*>& spans) const
{
    // Given more than once, the one that counts is in the line that the reader took it from; none is if that was a
    // macro or an included file.
    const Entry* entry = dictionary_.findScoped(withoutQuotes(key));
    const TextSpan* chosen = nullptr;
    for (const TextSpan* span : spans)
    {
        const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(span->begin), '\n');
        if (entry != nullptr && entry->origin().file == shownAs_ && entry->origin().line == line) { chosen = span; }
    }
    return chosen;
}

void TextEditor::set(const std::string& key, const std::string& written)
{
    const std::string value = checkedValue(written, shownAs_, key);
    const std::vector<SpanName> names = namesOf(key);
    const TextSpan root = scanText(text_, shownAs_);
    const TextSpan* span = spanOf(key, findSpans(root, names));
    if (span == nullptr)
    {
        insert(key, names, root, value);
        return;
    }
    const bool block = value.starts_with('{');
    const bool keepsSemicolon = !block && !span->isDictionary;
    const std::size_t end = keepsSemicolon ? span->valueEnd : span->end;
    const bool empty = span->valueBegin == span->valueEnd;
    std::string text = text_;
    text.replace(span->valueBegin, end - span->valueBegin,
                 fmt::format("{}{}{}", empty ? " " : "", value, keepsSemicolon || block ? "" : ";"));
    replace(std::move(text), key, true);
}

void TextEditor::insert(const std::string& key, const std::vector<SpanName>& names, const TextSpan& root,
                        const std::string& value)
{
    // The innermost dictionary of the key that stands in this text takes the new entry.
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
    const auto spelled = [](const SpanName& name) { return name.pattern ? '"' + name.keyword + '"' : name.keyword; };
    std::string missing = value; // with the dictionaries around it that this text does not hold
    for (std::size_t known = names.size() - 1; known > 0; --known)
    {
        const std::vector<SpanName> outer(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(known));
        std::vector<const TextSpan*> blocks = findSpans(root, outer);
        std::erase_if(blocks, [](const TextSpan* span) { return !span->isDictionary; });
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
    const Entry* existing = dictionary_.findScoped(withoutQuotes(key));
    if (existing != nullptr && existing->keyword() == namesOf(key).back().keyword)
    {
        throw Error(Fault::input, existing->origin(), "exists already", "use -set to change it");
    }
    set(key, value);
}

void TextEditor::remove(const std::string& key)
{
    static_cast<void>(entry(key)); // names the nearest if there is none
    const TextSpan root = scanText(text_, shownAs_);
    const std::vector<const TextSpan*> spans = findSpans(root, namesOf(key));
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
        else if (behind < lineEnd) { end = behind; }
        text.erase(begin, end - begin);
    }
    replace(std::move(text), key, false);
}

} // namespace isph
