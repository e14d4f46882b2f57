#include "core/Json.hpp"

#include "core/numberText.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace isph
{

namespace
{

std::string quoted(std::string_view text)
{
    std::string result = "\"";
    for (const char c : text)
    {
        switch (c)
        {
        case '"':
            result += "\\\"";
            break;
        case '\\':
            result += "\\\\";
            break;
        case '\n':
            result += "\\n";
            break;
        case '\t':
            result += "\\t";
            break;
        case '\r':
            result += "\\r";
            break;
        default:
            if (static_cast<unsigned char>(c) < 0x20) { result += fmt::format("\\u{:04x}", static_cast<int>(c)); }
            else { result += c; }
        }
    }
    return result += '"';
}

std::string indent(std::size_t level) { return std::string(2 * level, ' '); }

} // namespace

Json Json::object()
{
    Json json;
    json.value_ = Object{};
    return json;
}

Json Json::object(std::vector<Member> members)
{
    Json json = object();
    for (Member& member : members) { json.set(member.key, std::move(member.value)); }
    return json;
}

Json Json::array(std::vector<Json> elements)
{
    Json json;
    json.value_ = std::move(elements);
    return json;
}

Json& Json::set(std::string_view key, Json value)
{
    auto& [keys, values] = std::get<Object>(value_);
    const auto found = std::ranges::find(keys, key) - keys.begin();
    if (static_cast<std::size_t>(found) == keys.size())
    {
        keys.emplace_back(key);
        values.emplace_back();
    }
    values[static_cast<std::size_t>(found)] = std::move(value);
    return *this;
}

Json& Json::add(Json value)
{
    std::get<Array>(value_).push_back(std::move(value));
    return *this;
}

bool Json::isPlain() const { return !std::holds_alternative<Array>(value_) && !std::holds_alternative<Object>(value_); }

std::string Json::text() const
{
    std::string text;
    append(text, 0);
    return text += '\n';
}

void Json::append(std::string& text, std::size_t level) const
{
    if (const auto* flag = std::get_if<bool>(&value_)) { text += *flag ? "true" : "false"; }
    else if (const auto* number = std::get_if<double>(&value_))
    {
        text += std::isfinite(*number) ? numberText(*number) : "null";
    }
    else if (const auto* whole = std::get_if<long long>(&value_)) { text += std::to_string(*whole); }
    else if (const auto* string = std::get_if<std::string>(&value_)) { text += quoted(*string); }
    else if (const auto* elements = std::get_if<Array>(&value_))
    {
        const bool oneLine = std::ranges::all_of(*elements, &Json::isPlain);
        text += '[';
        for (std::size_t i = 0; i < elements->size(); ++i)
        {
            if (i > 0) { text += oneLine ? ", " : ","; }
            if (!oneLine) { text.append("\n").append(indent(level + 1)); }
            (*elements)[i].append(text, level + 1);
        }
        if (!oneLine) { text.append("\n").append(indent(level)); }
        text += ']';
    }
    else if (const auto* members = std::get_if<Object>(&value_))
    {
        const auto& [keys, values] = *members;
        text += '{';
        for (std::size_t i = 0; i < keys.size(); ++i)
        {
            text.append(i > 0 ? ",\n" : "\n").append(indent(level + 1));
            text.append(quoted(keys[i])).append(": ");
            values[i].append(text, level + 1);
        }
        if (!keys.empty()) { text.append("\n").append(indent(level)); }
        text += '}';
    }
    else { text += "null"; }
}

} // namespace isph
