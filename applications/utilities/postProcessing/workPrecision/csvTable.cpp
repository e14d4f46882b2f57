#include "csvTable.hpp"

#include "core/nearestWord.hpp"
#include "dictionary/Lexer.hpp"
#include "dictionary/readText.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <sstream>

namespace isph
{

namespace
{

constexpr std::string_view byteOrderMark = "\xef\xbb\xbf"; // as spreadsheets write it

std::vector<std::string> cellsOf(std::string line)
{
    if (line.ends_with('\r')) { line.pop_back(); }
    std::vector<std::string> cells(1);
    for (const char c : line)
    {
        if (c == ',') { cells.emplace_back(); }
        else { cells.back() += c; }
    }
    for (std::string& cell : cells)
    {
        const std::size_t begin = std::min(cell.find_first_not_of(" \t"), cell.size());
        cell = cell.substr(begin, cell.find_last_not_of(" \t") + 1 - begin);
        if (cell.size() > 1 && cell.starts_with('"') && cell.ends_with('"')) { cell = cell.substr(1, cell.size() - 2); }
    }
    return cells;
}

std::string withoutUnit(const std::string& head) { return head.substr(0, head.find(" [")); }

} // namespace

CsvTable::CsvTable(const std::filesystem::path& file, std::string shownAs) : shownAs_(std::move(shownAs))
{
    std::istringstream text(readText(file, {shownAs_, 0, ""}));
    int number = 0;
    for (std::string line; std::getline(text, line);)
    {
        ++number;
        if (number == 1 && line.starts_with(byteOrderMark)) { line.erase(0, byteOrderMark.size()); }
        if (line.starts_with('#') || line.find_first_not_of(" \t\r") == std::string::npos) { continue; }
        const std::vector<std::string> cells = cellsOf(std::move(line));
        if (heads_.empty())
        {
            heads_ = cells;
            for (const std::string& head : heads_) { names_.push_back(withoutUnit(head)); }
            columns_.resize(heads_.size());
            continue;
        }
        if (cells.size() != heads_.size())
        {
            throw Error(Fault::input, {shownAs_, number, ""},
                        fmt::format("has {} columns where the head has {}", cells.size(), heads_.size()));
        }
        for (std::size_t i = 0; i < cells.size(); ++i)
        {
            columns_[i].push_back(numberFrom(cells[i]).value_or(std::numeric_limits<double>::quiet_NaN()));
        }
    }
    if (heads_.empty()) { throw Error(Fault::input, {shownAs_, 0, ""}, "is empty"); }
}

std::vector<double> CsvTable::column(std::string_view name, const Origin& origin) const
{
    for (std::size_t i = 0; i < heads_.size(); ++i)
    {
        if (heads_[i] == name || names_[i] == name) { return columns_[i]; }
    }
    throw Error(Fault::input, origin, fmt::format("{} has no column '{}'", shownAs_, name),
                fmt::format("it has: {}", listOfWords(name, names_)));
}

} // namespace isph
