#include "dictionary/SpaceTimeFunction.hpp"

#include "dictionary/Table.hpp"

#include <algorithm>
#include <cassert>
#include <fmt/format.h>

namespace isph
{

SpaceTimeFunction SpaceTimeFunction::uniform(std::vector<double> values)
{
    SpaceTimeFunction function{std::vector<Expression>()};
    function.uniform_ = std::move(values);
    return function;
}

SpaceTimeFunction::SpaceTimeFunction(std::vector<Expression> expressions) : expressions_(std::move(expressions)) {}

SpaceTimeFunction::SpaceTimeFunction(Table table) : table_(std::make_unique<Table>(std::move(table))) {}

SpaceTimeFunction::~SpaceTimeFunction() = default;
SpaceTimeFunction::SpaceTimeFunction(SpaceTimeFunction&&) noexcept = default;
SpaceTimeFunction& SpaceTimeFunction::operator=(SpaceTimeFunction&&) noexcept = default;

int SpaceTimeFunction::components() const
{
    return static_cast<int>(table_ ? table_->columns.size() : std::max(uniform_.size(), expressions_.size()));
}

bool SpaceTimeFunction::isUniform() const
{
    return !table_ && std::ranges::none_of(expressions_, [](const Expression& expression)
                                           { return expression.dependsOnSpace() || expression.dependsOnTime(); });
}

bool SpaceTimeFunction::dependsOnTime() const
{
    return (table_ && table_->coordinate == 't') || std::ranges::any_of(expressions_, &Expression::dependsOnTime);
}

double SpaceTimeFunction::operator()(int component, double x, double y, double z, double t) const
{
    assert(component >= 0 && component < components());
    const auto index = static_cast<std::size_t>(component);
    if (table_) { return (*table_)(component, x, y, z, t); }
    return uniform_.empty() ? expressions_[index](x, y, z, t) : uniform_[index];
}

void SpaceTimeFunction::evaluate(int component, std::span<const double> x, std::span<const double> y,
                                 std::span<const double> z, double t, std::span<double> values) const
{
    assert(component >= 0 && component < components());
    const auto index = static_cast<std::size_t>(component);
    if (!uniform_.empty()) { std::ranges::fill(values, uniform_[index]); }
    else if (!table_) { expressions_[index].evaluate(x, y, z, t, values); }
    else
    {
        for (std::size_t i = 0; i < values.size(); ++i)
        {
            values[i] = (*table_)(component, x.empty() ? 0 : x[i], y.empty() ? 0 : y[i], z.empty() ? 0 : z[i], t);
        }
    }
}

namespace
{

constexpr std::string_view forms = "uniform, expression or table";

bool isBracket(const Token& token, char bracket)
{
    return token.kind == Token::Kind::bracket && token.text[0] == bracket;
}

/// The values behind the first word: one token, or `components` of them in parentheses.
std::vector<Token> componentTokens(const Dictionary& dictionary, std::string_view key, std::size_t first,
                                   int components, Token::Kind kind)
{
    const std::vector<Token>& tokens = dictionary.find(key)->tokens();
    const std::size_t count = tokens.size() - first;
    const bool listed = count >= 2 && isBracket(tokens[first], '(') && isBracket(tokens.back(), ')');
    const auto begin = tokens.begin() + static_cast<std::ptrdiff_t>(first) + (listed ? 1 : 0);
    const std::vector<Token> values(begin, tokens.end() - (listed ? 1 : 0));
    const bool rightKind = std::ranges::all_of(values, [kind](const Token& token) { return token.kind == kind; });
    const bool rightCount = static_cast<int>(values.size()) == components && (listed || components == 1);
    if (!rightKind || !rightCount)
    {
        const bool numbers = kind == Token::Kind::number;
        const std::string wanted =
            components == 1 ? (numbers ? "a number" : "one string") : (numbers ? "three numbers" : "three strings");
        const std::string example = components == 1 ? (numbers ? "uniform 0;" : "expression \"sin(x)\";")
                                    : numbers       ? "uniform (1 0 0);"
                                                    : "expression (\"sin(x)\" \"0\" \"0\");";
        throw dictionary.error(key, fmt::format("is {} but needs {}", shownValue(*dictionary.find(key)), wanted),
                               fmt::format("e.g. {} {}", key, example));
    }
    return values;
}

} // namespace

SpaceTimeFunction readFunction(const Dictionary& dictionary, std::string_view key, int components,
                               const std::vector<std::pair<std::string, double>>& constants,
                               const std::filesystem::path& folder)
{
    const Entry* entry = dictionary.find(key);
    if (entry == nullptr) { throw dictionary.error(key, fmt::format("is missing, {} is needed", forms)); }
    if (entry->isDictionary() || entry->tokens().empty())
    {
        throw dictionary.error(key, fmt::format("is {} but must be {}", shownValue(*entry), forms));
    }

    const Token& form = entry->tokens()[0];
    const bool bare = form.kind == Token::Kind::number || isBracket(form, '(');
    if (bare || (form.kind == Token::Kind::word && form.text == "uniform"))
    {
        std::vector<double> values;
        for (const Token& token : componentTokens(dictionary, key, bare ? 0 : 1, components, Token::Kind::number))
        {
            values.push_back(token.number);
        }
        return SpaceTimeFunction::uniform(std::move(values));
    }
    if (form.kind == Token::Kind::word && form.text == "expression")
    {
        const auto constant = [&](const std::string& name) -> std::optional<double>
        {
            if (const auto own = dictionary.constant(name)) { return own; }
            const auto given = std::ranges::find(constants, name, &std::pair<std::string, double>::first);
            return given != constants.end() ? std::optional(given->second) : std::nullopt;
        };
        std::vector<Expression> expressions;
        for (const Token& token : componentTokens(dictionary, key, 1, components, Token::Kind::string))
        {
            Origin origin = entry->origin();
            origin.line = token.line;
            expressions.emplace_back(token.text, constant, origin);
        }
        return SpaceTimeFunction(std::move(expressions));
    }
    if (form.kind == Token::Kind::word && form.text == "table")
    {
        const std::string name = componentTokens(dictionary, key, 1, 1, Token::Kind::string)[0].text;
        return SpaceTimeFunction(readTable(folder / name, name, components, entry->origin()));
    }
    throw dictionary.error(key, fmt::format("is {} but must be {}", shownValue(*entry), forms),
                           fmt::format("e.g. {} uniform {};", key, components == 1 ? "0" : "(1 0 0)"));
}

} // namespace isph
