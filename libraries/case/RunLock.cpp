#include "case/RunLock.hpp"

#include "core/Error.hpp"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace isph
{

namespace
{

/// Whether a file that is open still has the name; its last owner removes it.
bool hasName(int descriptor, const std::filesystem::path& file)
{
    struct stat open = {};
    struct stat named = {};
    return fstat(descriptor, &open) == 0 && stat(file.c_str(), &named) == 0 && open.st_ino == named.st_ino &&
           open.st_dev == named.st_dev;
}

std::string ownerOf(int descriptor)
{
    std::array<char, 32> text{};
    const ssize_t length = pread(descriptor, text.data(), text.size() - 1, 0);
    return length > 0 ? fmt::format("process {}", std::string(text.data(), static_cast<std::size_t>(length)))
                      : "another process";
}

} // namespace

RunLock::RunLock(const std::filesystem::path& caseDirectory)
{
    const std::filesystem::path path = caseDirectory / ".isphFoam.lock";
    while (true)
    {
        file_.emplace(path, O_RDWR | O_CREAT);
        const int descriptor = file_->number();
        if (flock(descriptor, LOCK_EX | LOCK_NB) != 0)
        {
            if (errno == EWOULDBLOCK)
            {
                throw Error(Fault::input, {caseDirectory.lexically_normal().string(), 0, ""},
                            fmt::format("is being solved by {} already", ownerOf(descriptor)),
                            "wait for it or stop it, or clone the case with cloneCase");
            }
            if (errno == EINTR) { continue; }
            return; // a file system without locks: the run goes on unguarded
        }
        if (hasName(descriptor, path)) { break; }
    }
    if (ftruncate(file_->number(), 0) == 0) { file_->write(std::to_string(getpid())); }
}

RunLock::~RunLock()
{
    // The name goes before the lock does, so that nobody can lock a file that is about to lose it.
    unlink(file_->file().c_str());
}

} // namespace isph
