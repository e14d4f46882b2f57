#include "core/readJson.hpp"

#include "core/Error.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <sstream>

namespace isph
{

namespace
{

constexpr int deepestNesting = 64;

/// Reads a JSON text from left to right and keeps its numbers.
class JsonReader
{
public:
    JsonReader(std::string_view text, const std::string& shownAs) : text_(text), shownAs_(shownAs) {}

    JsonValues read()
    {
        readValue("", 0);
        skipBlanks();
        if (at_ != text_.size()) { fail("has something behind its end"); }
        return std::move(values_);
    }

private:
    void readValue(const std::string& name, int depth);
    void readMembers(const std::string& name, int depth);
    void readElements(const std::string& name, int depth);
    std::string readText();
    double readNumber();
    bool takes(std::string_view word);
    bool takes(char character) { return takes(std::string_view(&character, 1)); }
    void expect(char character);
    void skipBlanks();
    [[noreturn]] void fail(const std::string& what) const;

    std::string_view text_;
    const std::string& shownAs_;
    std::size_t at_ = 0;
    JsonValues values_;
};

std::string inside(const std::string& outer, const std::string& name)
{
    return outer.empty() ? name : fmt::format("{}.{}", outer, name);
}

void JsonReader::fail(const std::string& what) const
{
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
    throw Error(Fault::input, {shownAs_, static_cast<int>(line), ""}, what);
}

void JsonReader::skipBlanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

bool JsonReader::takes(std::string_view word)
{
    skipBlanks();
    if (!text_.substr(at_).starts_with(word)) { return false; }
    at_ += word.size();
    return true;
}

void JsonReader::expect(char character)
{
    if (!takes(character)) { fail(fmt::format("is no JSON: a '{}' is missing", character)); }
}

void JsonReader::readValue(const std::string& name, int depth)
{
    if (depth > deepestNesting) { fail("is nested too deeply"); }
    if (takes('{')) { readMembers(name, depth); }
    else if (takes('[')) { readElements(name, depth); }
    else if (takes("true")) { values_.numbers[name] = 1; }
    else if (takes("false")) { values_.numbers[name] = 0; }
    else if (takes("null")) { values_.numbers[name] = std::numeric_limits<double>::quiet_NaN(); }
    else if (text_.substr(at_).starts_with('"')) { readText(); }
    else { values_.numbers[name] = readNumber(); }
}

void JsonReader::readMembers(const std::string& name, int depth)
{
    if (takes('}')) { return; }
    do {
        skipBlanks();
        const std::string key = readText();
        expect(':');
        readValue(inside(name, key), depth + 1);
    } while (takes(','));
    expect('}');
}

void JsonReader::readElements(const std::string& name, int depth)
{
    if (takes(']')) { return; }
    std::size_t index = 0;
    do {
        readValue(inside(name, std::to_string(index++)), depth + 1);
    } while (takes(','));
    expect(']');
}

std::string JsonReader::readText()
{
    expect('"');
    std::string result;
    for (; at_ < text_.size() && text_[at_] != '"'; ++at_)
    {
        if (text_[at_] != '\\')
        {
            result += text_[at_];
            continue;
        }
        // Escapes of our own reports are quotes, backslashes and control characters; others keep their letter.
        const char escaped = ++at_ < text_.size() ? text_[at_] : '"';
        result += escaped == 'n' ? '\n' : escaped == 't' ? '\t' : escaped;
    }
    expect('"');
    return result;
}

double JsonReader::readNumber()
{
    double value = 0;
    const auto parsed = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (parsed.ec != std::errc()) { fail("is no JSON: a value is missing"); }
    at_ = static_cast<std::size_t>(parsed.ptr - text_.data());
    return value;
}

} // namespace

std::optional<double> JsonValues::number(std::string_view name) const
{
    const auto found = numbers.find(name);
    return found == numbers.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string> JsonValues::numberNames() const
{
    std::vector<std::string> names;
    for (const auto& [name, value] : numbers) { names.push_back(name); }
    return names;
}

JsonValues parseJson(std::string_view text, const std::string& shownAs) { return JsonReader(text, shownAs).read(); }

JsonValues readJson(const std::filesystem::path& file, const std::string& shownAs)
{
    std::ifstream stream(file, std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    if (!stream) { throw Error(Fault::input, {shownAs, 0, ""}, "cannot be read"); }
    return parseJson(text.str(), shownAs);
}

} // namespace isph
