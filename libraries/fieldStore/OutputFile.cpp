#include "fieldStore/OutputFile.hpp"

#include "core/Error.hpp"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace isph
{

OutputFile::OutputFile(std::filesystem::path path)
    : path_(std::move(path)), descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666))
{
    if (descriptor_ < 0) { fail(); }
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1))
{
}

OutputFile::~OutputFile()
{
    if (descriptor_ >= 0) { ::close(descriptor_); }
}

void OutputFile::write(std::span<const char> bytes)
{
    while (!bytes.empty())
    {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written >= 0) { bytes = bytes.subspan(static_cast<std::size_t>(written)); }
        else if (errno != EINTR) { fail(); }
    }
}

void OutputFile::close()
{
    // EINVAL and ENOTSUP: pipes and devices have no disk to wait for.
    if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP) { fail(); }
    if (::close(std::exchange(descriptor_, -1)) != 0) { fail(); }
}

void OutputFile::fail() const
{
    const std::string reason = std::generic_category().message(errno);
    throw Error(Fault::input, Origin{path_.string(), 0, ""}, "cannot be written: " + reason,
                errno == ENOSPC ? "make room on the disk" : "");
}

} // namespace isph
