#include "case/CsvWriter.hpp"

#include "core/Error.hpp"
#include "core/numberText.hpp"

#include <cassert>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace isph
{

namespace
{

std::string headerText(const CsvColumn& column)
{
    const std::string text = column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
    if (text.find_first_of(",\"\n") == std::string::npos) { return text; }
    std::string quoted = "\"";
    for (const char c : text) { quoted.append(c == '"' ? 2 : 1, c); }
    return quoted += '"';
}

FileDescriptor create(const std::filesystem::path& file)
{
    if (file.has_parent_path()) { makeFolder(file.parent_path()); }
    return FileDescriptor(file, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND);
}

} // namespace

CsvWriter::CsvWriter(std::filesystem::path file, const std::vector<CsvColumn>& columns)
    : file_(create(file)), columns_(columns.size())
{
    std::string line;
    for (const CsvColumn& column : columns)
    {
        if (!line.empty()) { line += ','; }
        line += headerText(column);
    }
    append(line += '\n');
}

void CsvWriter::row(std::span<const double> values)
{
    assert(values.size() == columns_);
    std::string line;
    for (const double value : values)
    {
        if (!line.empty()) { line += ','; }
        line += numberText(value);
    }
    append(line += '\n');
}

void CsvWriter::append(const std::string& line)
{
    try
    {
        file_.write(line);
        size_ += static_cast<long>(line.size());
    }
    catch (const Error&)
    {
        // Half a row would be read as a wrong number: better none. Should that be refused too, the error says enough.
        [[maybe_unused]] const int refused = ftruncate(file_.number(), size_);
        throw;
    }
}

std::filesystem::path postProcessingFile(const std::filesystem::path& caseDirectory, const std::string& name,
                                         const std::string& startTime, const std::string& file)
{
    return caseDirectory / "postProcessing" / name / startTime / file;
}

} // namespace isph
