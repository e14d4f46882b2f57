#include "dictionary/readText.hpp"

#include "core/Error.hpp"
#include "core/version.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <vector>

namespace isph
{

std::string readText(const std::filesystem::path& file, const Origin& origin)
{
    std::error_code problem;
    const auto refuse = [&origin](const std::string& reason)
    { throw Error(Fault::input, origin, fmt::format("cannot be read: {}", reason)); };
    const bool regular = std::filesystem::is_regular_file(file, problem);
    if (problem) { refuse(problem.message()); }
    if (!regular) { refuse("it is not a file"); }
    const auto size = std::filesystem::file_size(file, problem);
    if (problem) { refuse(problem.message()); }
    if (size > largestText) { refuse(fmt::format("it is larger than {} bytes", largestText)); }
    std::ifstream stream(file, std::ios::binary);
    std::string text(size, '\0');
    errno = 0;
    if (!stream.read(text.data(), static_cast<std::streamsize>(size))) { refuse(std::strerror(errno)); }
    return text;
}

std::filesystem::path findEtcFile(const std::string& name)
{
    std::vector<std::filesystem::path> folders;
    if (const char* variable = std::getenv("CONTINUA_ETC")) { folders.emplace_back(variable); }
    std::error_code problem;
    const std::filesystem::path programs = std::filesystem::read_symlink("/proc/self/exe", problem).parent_path();
    if (!problem)
    {
        folders.push_back(programs / ".." / "etc");
        folders.push_back(programs / ".." / ".." / "etc");
        folders.push_back(programs / ".." / installedEtc);
    }
    folders.emplace_back(sourceEtc);
    for (const std::filesystem::path& folder : folders)
    {
        if (std::filesystem::exists(folder / name, problem)) { return folder / name; }
    }
    return {};
}

} // namespace isph
