#pragma once

#include "dictionary/Lexer.hpp"

#include <span>
#include <string>
#include <vector>

namespace isph
{

/// Where an entry stands in the text of a dictionary, in bytes.
struct TextSpan
{
    std::string keyword;
    bool pattern = false; ///< the keyword is in quotes
    bool isDictionary = false;
    std::size_t begin = 0;      ///< of the keyword
    std::size_t valueBegin = 0; ///< of the value or the '{'; where there is no value, behind the keyword
    std::size_t valueEnd = 0;   ///< behind the value, before the ';', or behind the '}'
    std::size_t end = 0;        ///< behind the ';' or the '}'
    std::vector<TextSpan> entries;
};

/// A keyword to look for.
struct SpanName
{
    std::string keyword;
    bool pattern = false;
};

/// The entries of a text as they are written: macros and includes are not followed, and both branches of an #if count.
/// Requires a text that parses.
TextSpan scanText(const std::string& text, const std::string& shownAs);

/// Every place where a scoped entry is written, in the order of the text. names must not be empty.
std::vector<const TextSpan*> findSpans(const TextSpan& root, std::span<const SpanName> names);

} // namespace isph
