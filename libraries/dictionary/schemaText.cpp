#include "dictionary/schemaText.hpp"

#include "dictionary/writeDictionary.hpp"

#include <filesystem>
#include <fmt/format.h>

namespace isph
{

namespace
{

std::string placeholder(const Key& key)
{
    switch (key.type)
    {
    case Key::Type::number:
        return "<number>";
    case Key::Type::integer:
        return "<whole number>";
    case Key::Type::flag:
        return "<yes or no>";
    case Key::Type::word:
        return key.words.empty() ? "<word>" : fmt::format("{}", fmt::join(key.words, " | "));
    case Key::Type::text:
        return "\"<text>\"";
    case Key::Type::vector:
        return "(<x> <y> <z>)";
    case Key::Type::list:
        return "( ... )";
    case Key::Type::dimensioned:
        return "<number>";
    case Key::Type::function:
        return "<uniform ... | expression ... | table ...>";
    case Key::Type::dictionary:
        return "{ ... }";
    case Key::Type::any:
        break;
    }
    return "...";
}

std::string meaningWithUnit(const Key& key)
{
    return key.meaning + (key.unit.empty() ? "" : fmt::format("{}[{}]", key.meaning.empty() ? "" : " ", key.unit));
}

std::string ended(const Key& key, const std::string& value)
{
    return fmt::format("{} {}{}", key.name, value, key.type == Key::Type::dictionary ? "" : ";");
}

std::string keysText(const std::vector<Key>& keys, std::size_t indent);

/// One key, its meaning above it.
std::string keyText(const Key& key, std::size_t indent)
{
    const std::string margin(indent, ' ');
    const bool isDictionary = key.type == Key::Type::dictionary;
    const bool needsName = key.name == "*";
    std::string comment = meaningWithUnit(key);
    if (!key.words.empty())
    {
        comment += fmt::format("{}{}", comment.empty() ? "" : ": ", fmt::join(key.words, " | "));
    }
    if (key.required) { comment += comment.empty() ? "must be given" : "; must be given"; }
    std::string text = comment.empty() ? "" : fmt::format("{}// {}\n", margin, comment);
    const std::string name = needsName ? "<name>" : key.name;
    if (isDictionary && !key.keys.empty())
    {
        text += fmt::format("{0}{1}\n{0}{{\n{2}{0}}}\n", margin, name, keysText(key.keys, indent + 4));
    }
    else
    {
        const std::string value = key.fallback.value_or(placeholder(key));
        text += fmt::format("{}{:<15} {}{}\n", margin, name, value, isDictionary ? "" : ";");
    }
    const bool parses = !needsName && (isDictionary || key.fallback);
    if (parses) { return text; }

    // What does not parse, or would not mean anything, becomes a comment as a whole.
    std::string commented;
    for (std::size_t begin = 0; begin < text.size();)
    {
        const std::size_t end = text.find('\n', begin);
        const std::string line = text.substr(begin, end - begin);
        const std::size_t first = line.find_first_not_of(' ');
        const bool isComment = first != std::string::npos && line.compare(first, 2, "//") == 0;
        commented += isComment || first == std::string::npos ? line : margin + "// " + line.substr(indent);
        commented += '\n';
        begin = end + 1;
    }
    return commented;
}

std::string keysText(const std::vector<Key>& keys, std::size_t indent)
{
    std::string text;
    for (const Key& key : keys)
    {
        if (!text.empty()) { text += '\n'; }
        text += keyText(key, indent);
    }
    return text;
}

} // namespace

std::string shape(const Key& key)
{
    std::string result;
    switch (key.type)
    {
    case Key::Type::number:
        result = "a number";
        break;
    case Key::Type::integer:
        result = "a whole number";
        break;
    case Key::Type::flag:
        result = "yes or no";
        break;
    case Key::Type::word:
        result = "a word";
        break;
    case Key::Type::text:
        result = "a word or a quoted string";
        break;
    case Key::Type::vector:
        result = "a vector of three numbers";
        break;
    case Key::Type::list:
        result = "a list ( ... )";
        break;
    case Key::Type::dimensioned:
        result = "a number, perhaps behind dimensions";
        break;
    case Key::Type::function:
        result = "uniform, expression or table";
        break;
    case Key::Type::dictionary:
        result = "a dictionary { ... }";
        break;
    case Key::Type::any:
        result = "a value";
        break;
    }
    const bool isNumber = key.type == Key::Type::number || key.type == Key::Type::integer;
    return isNumber && !key.words.empty() ? fmt::format("{} or {}", result, fmt::join(key.words, " or ")) : result;
}

std::string usage(const Key& key)
{
    const std::string meaning = meaningWithUnit(key);
    return ended(key, placeholder(key)) + (meaning.empty() ? "" : fmt::format(" ({})", meaning));
}

std::string hint(const Key& key)
{
    const std::string meaning = meaningWithUnit(key);
    const std::string example = key.fallback && key.name != "*" ? "e.g. " + ended(key, *key.fallback) : "";
    return meaning + (meaning.empty() || example.empty() ? "" : ", ") + example;
}

std::string annotatedText(const std::string& name, const std::vector<Key>& keys)
{
    return foamHeader("dictionary", std::filesystem::path(name).filename().string()) + keysText(keys, 0);
}

} // namespace isph
