#include "core/writeTextFile.hpp"

#include "core/FileDescriptor.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace isph
{

void writeTextFile(const std::filesystem::path& file, std::string_view text)
{
    // A link stays a link: the file it leads to is replaced.
    std::error_code ignored;
    const std::filesystem::path target =
        std::filesystem::is_symlink(file, ignored) ? std::filesystem::weakly_canonical(file, ignored) : file;
    const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
    makeFolder(folder);

    const std::filesystem::path temporary = temporaryName(target);
    try
    {
        FileDescriptor output(temporary, O_WRONLY | O_CREAT | O_TRUNC);
        output.write(text);
        output.sync();
        if (std::rename(temporary.c_str(), target.c_str()) != 0) { throwRefused(file, "could not be written", errno); }
    }
    catch (...)
    {
        unlink(temporary.c_str());
        throw;
    }
    syncToDisk(folder);
}

} // namespace isph
