#pragma once

#include "core/FileDescriptor.hpp"

#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace isph
{

/// A column of a CSV file; the header shows "name [unit]", or the name alone if it has no unit.
struct CsvColumn
{
    std::string name;
    std::string unit = "";
};

/// A CSV file that grows row by row; each row is in the file when row() returns. Numbers read back as the same bits.
class CsvWriter
{
public:
    /// Makes the file, and the folders it is in; a file of an earlier run is replaced.
    /// \throws Error(input) naming the file and the machine's reason.
    CsvWriter(std::filesystem::path file, const std::vector<CsvColumn>& columns);

    /// Adds a row with one value a column (step numbers are written as whole numbers).
    /// \throws Error(input) if it cannot be written (disk full); the file then ends with the row before.
    void row(std::span<const double> values);
    void row(std::initializer_list<double> values) { row(std::span(values.begin(), values.size())); }

    const std::filesystem::path& file() const { return file_.file(); }

private:
    void append(const std::string& line);

    FileDescriptor file_;
    std::size_t columns_;
    long size_ = 0; ///< of the complete rows, in bytes
};

/// <case>/postProcessing/<name>/<startTime>/<file>: where a function writes (contract, section 1).
std::filesystem::path postProcessingFile(const std::filesystem::path& caseDirectory, const std::string& name,
                                         const std::string& startTime, const std::string& file);

} // namespace isph
