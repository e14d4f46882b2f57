#pragma once

#include "core/Error.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isph
{

/// A CSV file: comment lines begin with #, the first other line names the columns, "name [unit]".
class CsvTable
{
public:
    /// \param shownAs what messages call the file
    /// \throws Error(input) if it cannot be read or holds no columns; where a cell is missing, at its line.
    CsvTable(const std::filesystem::path& file, std::string shownAs);

    /// The values of a column, named with or without its unit; what is no number is not-a-number.
    /// \param origin of who asks
    /// \throws Error(input) at origin naming the nearest column if there is none.
    std::vector<double> column(std::string_view name, const Origin& origin) const;

    const std::vector<std::string>& names() const { return names_; } ///< without units

private:
    std::string shownAs_;
    std::vector<std::string> heads_;
    std::vector<std::string> names_;
    std::vector<std::vector<double>> columns_;
};

} // namespace isph
