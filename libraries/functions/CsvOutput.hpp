#pragma once

#include "case/CsvWriter.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace isph
{

/// A CSV file that is made with its first row: a function that never runs leaves nothing behind.
class CsvOutput
{
public:
    CsvOutput(std::filesystem::path file, std::vector<CsvColumn> columns)
        : file_(std::move(file)), columns_(std::move(columns))
    {
    }

    /// Adds a row with one value a column. \throws Error(input) if the file cannot be written.
    void row(std::span<const double> values)
    {
        if (!writer_) { writer_.emplace(file_, columns_); }
        writer_->row(values);
    }

private:
    std::filesystem::path file_;
    std::vector<CsvColumn> columns_;
    std::optional<CsvWriter> writer_;
};

} // namespace isph
