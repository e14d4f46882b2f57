#include "dictionary/KeyPattern.hpp"

#include <algorithm>
#include <regex.h>

namespace isph
{

namespace
{

constexpr std::size_t longestPattern = 500;
constexpr int deepestGroups = 50;
constexpr long mostRepeats = 200;
constexpr long largestUnfolded = 2000; // characters, repeats written out
constexpr std::size_t longestName = 1000;

/// How often the C library may copy a part of a pattern when it unfolds repeats: {n,m} copies m times, + once more, and
/// nested ones multiply, so a row of + doubles with each. -1 for a back reference or deep nesting.
long unfolding(const std::string& text)
{
    long product = 1;
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        if (text[i] == '\\')
        {
            ++i;
            if (i < text.size() && text[i] >= '1' && text[i] <= '9') { return -1; }
        }
        else if (text[i] == '(' && ++depth > deepestGroups) { return -1; }
        else if (text[i] == ')') { --depth; }
        else if (text[i] == '+') { product = std::min(mostRepeats + 1, 2 * product); }
        else if (text[i] == '{')
        {
            long largest = 2; // {1,} is a +
            long number = 0;
            for (++i; i < text.size() && text[i] != '}'; ++i)
            {
                const bool digit = text[i] >= '0' && text[i] <= '9';
                number = digit ? std::min(mostRepeats + 1, 10 * number + (text[i] - '0')) : 0;
                largest = std::max(largest, number);
            }
            product = std::min(mostRepeats + 1, product * largest);
        }
    }
    return product;
}

} // namespace

struct KeyPattern::Compiled
{
    regex_t expression;
};

std::optional<std::string> KeyPattern::fault(const std::string& text)
{
    if (text.empty()) { return "is an empty name"; }
    const long repeats = unfolding(text);
    if (text.size() > longestPattern || text.find('\0') != std::string::npos || repeats < 0 ||
        repeats * static_cast<long>(text.size()) > largestUnfolded)
    {
        return "is too complicated a pattern";
    }
    regex_t expression;
    const int code = regcomp(&expression, text.c_str(), REG_EXTENDED);
    if (code == 0)
    {
        regfree(&expression);
        return std::nullopt;
    }
    std::string reason(200, '\0');
    reason.resize(regerror(code, &expression, reason.data(), reason.size()) - 1);
    return "is not a regular expression: " + reason;
}

KeyPattern::KeyPattern(const std::string& text) : compiled_(std::make_unique<Compiled>())
{
    regcomp(&compiled_->expression, text.c_str(), REG_EXTENDED);
}

KeyPattern::~KeyPattern() { regfree(&compiled_->expression); }

bool KeyPattern::matches(std::string_view name) const
{
    if (name.size() > longestName) { return false; }
    // The leftmost longest match is the whole name if any match is.
    const std::string subject(name);
    regmatch_t match;
    return regexec(&compiled_->expression, subject.c_str(), 1, &match, 0) == 0 && match.rm_so == 0 &&
           static_cast<std::size_t>(match.rm_eo) == subject.size();
}

} // namespace isph
