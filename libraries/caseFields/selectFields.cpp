#include "caseFields/selectFields.hpp"

#include "core/Selection.hpp"

#include <algorithm>
#include <optional>

namespace isph
{

namespace
{

/// The words of "(U p)", "U p" or "U,p".
std::vector<std::string> wordsOf(const std::string& text)
{
    std::vector<std::string> words;
    const char* separators = "() ,\t";
    for (std::size_t begin = text.find_first_not_of(separators); begin != std::string::npos;)
    {
        const std::size_t end = text.find_first_of(separators, begin);
        words.push_back(text.substr(begin, end - begin));
        begin = text.find_first_not_of(separators, end);
    }
    return words;
}

} // namespace

std::vector<std::string> selectFields(std::span<const std::string> available, const CommandLine& line)
{
    const std::optional<std::string> written = line.value("fields");
    if (!written) { return {available.begin(), available.end()}; }

    std::vector<std::string> words = wordsOf(*written);
    if (words.empty()) { throw Error(Fault::usage, "-fields names no field", "write e.g. -fields '(U p)'"); }
    for (const std::string& word : words)
    {
        if (std::find(available.begin(), available.end(), word) == available.end())
        {
            throwUnknownWord("field", {word, {"-fields", 0, ""}}, available);
        }
    }
    return words;
}

} // namespace isph
