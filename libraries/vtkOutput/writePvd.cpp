#include "vtkOutput/writePvd.hpp"

#include "core/Error.hpp"

#include <cerrno>
#include <fmt/format.h>
#include <fstream>
#include <system_error>
#include <unistd.h>

namespace isph
{

namespace
{

/// Text inside quotes of an XML attribute: a case folder may be called "a&b".
std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text)
    {
        switch (c)
        {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '"':
            result += "&quot;";
            break;
        default:
            result += c;
        }
    }
    return result;
}

} // namespace

std::string pvdText(std::span<const PvdEntry> entries)
{
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n  <Collection>\n";
    for (const PvdEntry& entry : entries)
    {
        text += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", entry.time, escaped(entry.file));
    }
    return text + "  </Collection>\n</VTKFile>\n";
}

void writePvd(const std::filesystem::path& file, std::span<const PvdEntry> entries)
{
    const std::filesystem::path temporary = file.string() + fmt::format(".writing{}", getpid());
    std::error_code failure;
    errno = 0;
    std::ofstream stream(temporary, std::ios::binary);
    stream << pvdText(entries);
    stream.close();
    if (stream) { std::filesystem::rename(temporary, file, failure); }
    else { failure = std::error_code(errno != 0 ? errno : EIO, std::generic_category()); }
    if (failure)
    {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw Error(Fault::input, {file.string(), 0, ""}, "cannot be written: " + failure.message());
    }
}

} // namespace isph
