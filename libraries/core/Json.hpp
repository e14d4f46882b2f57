#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace isph
{

/// A JSON value to be written: members keep the order they were added in. A number that is not finite becomes null.
class Json
{
public:
    struct Member; ///< key and value

    Json() : value_(nullptr) {} ///< null
    Json(std::same_as<bool> auto flag) : value_(flag) {}
    Json(std::floating_point auto number) : value_(static_cast<double>(number)) {}
    Json(std::integral auto number)
        requires(!std::same_as<decltype(number), bool>)
        : value_(static_cast<long long>(number))
    {
    }
    Json(std::string text) : value_(std::move(text)) {}
    Json(std::string_view text) : value_(std::string(text)) {}
    Json(const char* text) : value_(std::string(text)) {}

    /// An empty object, or one with these members: Json::object({{"steps", 12}, {"case", "cavity"}}).
    static Json object();
    static Json object(std::vector<Member> members);

    /// An empty array, or one with these elements.
    static Json array(std::vector<Json> elements = {});

    /// An array of anything that a Json can be made of.
    static Json arrayOf(const auto& range)
    {
        std::vector<Json> elements;
        for (const auto& element : range) { elements.emplace_back(element); }
        return array(std::move(elements));
    }

    /// Adds a member to an object; a key that is there already gets the new value in its old place.
    Json& set(std::string_view key, Json value);

    /// Adds an element to an array.
    Json& add(Json value);

    /// The text, indented by two blanks a level; arrays of plain values stay on one line. Ends with a newline.
    std::string text() const;

private:
    using Array = std::vector<Json>;
    struct Object
    {
        std::vector<std::string> keys;
        std::vector<Json> values;
    };

    void append(std::string& text, std::size_t level) const;
    bool isPlain() const;

    std::variant<std::nullptr_t, bool, double, long long, std::string, Array, Object> value_;
};

struct Json::Member
{
    std::string key;
    Json value;
};

} // namespace isph
