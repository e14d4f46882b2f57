#include "SweepText.hpp"

#include "dictionary/readText.hpp"
#include "dictionary/Schema.hpp"
#include "dictionary/TextSpan.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <utility>

namespace isph
{

namespace
{

const TextSpan* spanOf(const TextSpan& block, std::string_view keyword, bool dictionary)
{
    const TextSpan* found = nullptr;
    for (const TextSpan& span : block.entries)
    {
        if (span.keyword == keyword && span.isDictionary == dictionary) { found = &span; }
    }
    return found;
}

/// Two entries of one name would merge without a word: of variants and parameters that is a slip.
void refuseTwins(const TextSpan& block, const std::string& text, const std::string& shownAs)
{
    for (std::size_t i = 0; i < block.entries.size(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j)
        {
            const TextSpan& entry = block.entries[i];
            if (entry.keyword != block.entries[j].keyword) { continue; }
            const auto line =
                1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(entry.begin), '\n');
            throw Error(Fault::input,
                        {shownAs, static_cast<int>(line), fmt::format("{}.{}", block.keyword, entry.keyword)},
                        "is there twice", "give one of them another name");
        }
    }
}

/// The same number of lines with nothing on them.
std::string blankLines(std::string_view text)
{
    return std::string(static_cast<std::size_t>(std::ranges::count(text, '\n')), '\n');
}

/// The values of a list, each as it would be written into a dictionary: (20 40), ("(20 20 1)" (40 40 1)), (fft CG).
std::vector<std::string> valuesOf(const Entry& entry)
{
    const std::vector<Token>& tokens = entry.tokens();
    const auto is = [](const Token& token, std::string_view bracket)
    { return token.kind == Token::Kind::bracket && token.text == bracket; };
    if (entry.isDictionary() || tokens.size() < 2 || !is(tokens.front(), "(") || !is(tokens.back(), ")"))
    {
        throw Error(Fault::input, entry.origin(), fmt::format("is {} but must be a list of values", shownValue(entry)),
                    fmt::format("write {} (20 40 80);", entry.keyword()));
    }
    std::vector<std::string> values;
    int depth = 0;
    for (std::size_t i = 1; i + 1 < tokens.size(); ++i)
    {
        const bool closes = is(tokens[i], ")") || is(tokens[i], "]");
        if (depth == 0) { values.emplace_back(); }
        else if (!closes && !values.back().ends_with('(')) { values.back() += ' '; }
        values.back() += tokens[i].text;
        depth += is(tokens[i], "(") || is(tokens[i], "[") ? 1 : closes ? -1 : 0;
    }
    if (values.empty()) { throw Error(Fault::input, entry.origin(), "is an empty list", "give it values"); }
    for (const std::string& value : values)
    {
        if (std::ranges::count(values, value) > 1)
        {
            throw Error(Fault::input, entry.origin(), fmt::format("has {} twice", value), "leave one of them out");
        }
    }
    return values;
}

} // namespace

std::vector<Parameter> readParameters(const Dictionary& dictionary)
{
    static const Schema schema("parameter", {{.name = "values", .type = Key::Type::list, .required = true},
                                             {.name = "entry", .type = Key::Type::text, .fallback = "\"\""}});
    std::vector<Parameter> parameters;
    for (const Entry& entry : dictionary.entries())
    {
        Parameter parameter{.name = entry.keyword(), .values = {}, .entry = "", .origin = entry.origin()};
        if (entry.isDictionary())
        {
            const Dictionary complete = schema.complete(entry.dictionary());
            parameter.values = valuesOf(*complete.find("values"));
            parameter.entry = complete.text("entry");
        }
        else { parameter.values = valuesOf(entry); }
        parameters.push_back(std::move(parameter));
    }
    return parameters;
}

SweepText::SweepText(const std::filesystem::path& file, std::string shownAs, bool reduced)
    : text_(readText(file, {shownAs, 0, ""})),
      shownAs_(std::move(shownAs)),
      folder_(file.parent_path()),
      reduced_(reduced)
{
    const TextSpan root = scanText(text_, shownAs_);
    const TextSpan* lists = spanOf(root, "parameters", true);
    if (lists == nullptr)
    {
        throw Error(Fault::input, {shownAs_, 0, "parameters"}, "is missing", "write parameters { N (20 40 80); }");
    }
    refuseTwins(*lists, text_, shownAs_);
    if (const TextSpan* variants = spanOf(root, "variants", true)) { refuseTwins(*variants, text_, shownAs_); }
    std::string head = text_.substr(0, lists->end);
    if (reduced_)
    {
        const TextSpan* block = spanOf(root, "reduced", true);
        if (block == nullptr)
        {
            throw Error(Fault::input, {shownAs_, 0, "reduced"}, "is missing, and -reduced asks for it",
                        "write reduced { parameters { N (10 20); } }");
        }
        if (const TextSpan* fewer = spanOf(*block, "parameters", true))
        {
            head += blankLines(std::string_view(text_).substr(lists->end, fewer->begin - lists->end));
            head += text_.substr(fewer->begin, fewer->end - fewer->begin);
        }
    }
    const Dictionary dictionary = Dictionary::parse(head, shownAs_, folder_);
    parameters_ = readParameters(dictionary.dictionary("parameters"));
    if (parameters_.empty()) { throw dictionary.error("parameters", "is empty", "write parameters { N (20 40 80); }"); }
}

bool SweepText::uses(const std::string& name) const
{
    for (const char* before : {"$", "${", "$:", "${:", "$.", "$.."})
    {
        for (std::size_t at = text_.find(before + name); at != std::string::npos;
             at = text_.find(before + name, at + 1))
        {
            const std::size_t end = at + std::string_view(before).size() + name.size();
            const bool longer =
                end < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[end])) != 0 || text_[end] == '_');
            if (!longer) { return true; }
        }
    }
    return false;
}

Dictionary SweepText::with(const std::vector<std::string>& values) const
{
    const TextSpan root = scanText(text_, shownAs_);
    std::string text = text_;
    std::string front;
    std::vector<std::pair<const TextSpan*, const std::string*>> replaced;
    for (std::size_t i = 0; i < parameters_.size(); ++i)
    {
        const TextSpan* span = spanOf(root, parameters_[i].name, false);
        if (span != nullptr) { replaced.emplace_back(span, &values[i]); }
        else { front += fmt::format("{} {}; ", parameters_[i].name, values[i]); }
    }
    // From the end, so that what is left to replace stays where it is.
    std::ranges::sort(replaced, [](const auto& a, const auto& b) { return a.first->begin > b.first->begin; });
    for (const auto& [span, value] : replaced)
    {
        text.replace(span->valueBegin, span->valueEnd - span->valueBegin, *value);
    }

    Dictionary dictionary = Dictionary::parse(front + text, shownAs_, folder_);
    if (reduced_)
    {
        const Dictionary fewer = dictionary.dictionary("reduced");
        for (const Entry& entry : fewer.entries()) { dictionary.set(entry); }
    }
    dictionary.remove("reduced");
    for (const Parameter& parameter : parameters_) { dictionary.remove(parameter.name); }
    return dictionary;
}

} // namespace isph
