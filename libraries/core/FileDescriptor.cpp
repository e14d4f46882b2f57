#include "core/FileDescriptor.hpp"

#include "core/Error.hpp"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace isph
{

void throwRefused(const std::filesystem::path& file, const std::string& action, int reason)
{
    std::string advice;
    if (reason == ENOSPC || reason == EDQUOT || reason == EFBIG)
    {
        advice = "make room and start again: what was written before is untouched";
    }
    else if (reason == EACCES || reason == EPERM || reason == EROFS)
    {
        advice = "give yourself permission to write there, or work on a copy of the case";
    }
    throw Error(Fault::input, {file.lexically_normal().string(), 0, ""},
                action + ": " + std::generic_category().message(reason), advice);
}

FileDescriptor::FileDescriptor(std::filesystem::path file, int flags)
    : file_(std::move(file)), number_(open(file_.c_str(), flags | O_CLOEXEC, 0666))
{
    if (number_ < 0) { throwRefused(file_, "could not be opened", errno); }
}

FileDescriptor::~FileDescriptor()
{
    if (number_ >= 0) { close(number_); }
}

FileDescriptor::FileDescriptor(FileDescriptor&& other) noexcept
    : file_(std::move(other.file_)), number_(std::exchange(other.number_, -1))
{
}

void FileDescriptor::write(std::string_view text)
{
    while (!text.empty())
    {
        const ssize_t written = ::write(number_, text.data(), text.size());
        if (written < 0)
        {
            if (errno == EINTR) { continue; }
            throwRefused(file_, "could not be written", errno);
        }
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

void FileDescriptor::sync()
{
    // Some file systems cannot sync folders or special files and say so with EINVAL: there is nothing to wait for.
    if (fsync(number_) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP)
    {
        throwRefused(file_, "could not be written", errno);
    }
}

void makeFolder(const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) { throwRefused(folder, "folder could not be made", error.value()); }
}

void syncToDisk(const std::filesystem::path& path) { FileDescriptor(path, O_RDONLY).sync(); }

std::filesystem::path temporaryName(const std::filesystem::path& file)
{
    std::string name = ".";
    name.append(file.filename().string()).append(".tmp-").append(std::to_string(getpid()));
    return file.parent_path() / name;
}

} // namespace isph
