#include "core/nearestWord.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace isph
{

namespace
{

std::string lowerCase(std::string_view text)
{
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

} // namespace

int editDistance(std::string_view a, std::string_view b)
{
    std::vector<int> twoAbove(b.size() + 1);
    std::vector<int> above(b.size() + 1);
    std::vector<int> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) { row[j] = static_cast<int>(j); }

    for (std::size_t i = 1; i <= a.size(); ++i)
    {
        std::swap(twoAbove, above);
        std::swap(above, row);
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j)
        {
            const int substitution = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, substitution});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) { row[j] = std::min(row[j], twoAbove[j - 2] + 1); }
        }
    }
    return row[b.size()];
}

std::optional<std::string> nearestWord(std::string_view written, std::span<const std::string> known)
{
    const std::string sought = lowerCase(written);
    std::optional<std::string> nearest;
    int least = std::max(2, static_cast<int>(written.size()) / 3) + 1;
    for (const std::string& word : known)
    {
        const int distance = editDistance(sought, lowerCase(word));
        if (distance < least && distance < static_cast<int>(word.size()))
        {
            least = distance;
            nearest = word;
        }
    }
    return nearest;
}

std::string listOfWords(std::string_view written, std::span<const std::string> known)
{
    const auto nearest = nearestWord(written, known);
    std::string list = nearest.value_or("");
    for (const std::string& word : known)
    {
        if (word == nearest) { continue; }
        list += (list.empty() ? "" : ", ") + word;
    }
    return list;
}

} // namespace isph
