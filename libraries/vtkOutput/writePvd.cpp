#include "vtkOutput/writePvd.hpp"

#include "core/numberText.hpp"
#include "core/writeTextFile.hpp"

#include <fmt/format.h>

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
        text += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", numberText(entry.time),
                            escaped(entry.file));
    }
    return text + "  </Collection>\n</VTKFile>\n";
}

void writePvd(const std::filesystem::path& file, std::span<const PvdEntry> entries)
{
    writeTextFile(file, pvdText(entries));
}

} // namespace isph
