#include "case/AtomicFolder.hpp"

#include "core/FileDescriptor.hpp"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <unistd.h>
#include <utility>

namespace isph
{

namespace fs = std::filesystem;

namespace
{

/// A name of the form ".<final>.<kind>-<pid>".
struct TemporaryName
{
    std::string final;
    std::string kind; ///< tmp: being written or removed; old: being replaced
    pid_t pid = 0;
};

std::optional<TemporaryName> parseTemporary(const std::string& name)
{
    const std::size_t dash = name.rfind('-');
    const std::size_t dot = name.rfind('.', dash);
    if (!name.starts_with('.') || dash == std::string::npos || dot == std::string::npos || dot < 2)
    {
        return std::nullopt;
    }
    TemporaryName result{name.substr(1, dot - 1), name.substr(dot + 1, dash - dot - 1), 0};
    const char* end = name.data() + name.size();
    const auto parsed = std::from_chars(name.data() + dash + 1, end, result.pid);
    const bool known = result.kind == "tmp" || result.kind == "old";
    if (!known || parsed.ec != std::errc() || parsed.ptr != end || result.pid <= 0) { return std::nullopt; }
    return result;
}

bool livesElsewhere(pid_t pid) { return pid != getpid() && (kill(pid, 0) == 0 || errno == EPERM); }

void giveName(const fs::path& from, const fs::path& to)
{
    if (std::rename(from.c_str(), to.c_str()) != 0) { throwRefused(to, "could not be written", errno); }
}

/// Puts `next` in the place of the folder `current`, and what was there in the place of `next`.
void exchange(const fs::path& next, const fs::path& current)
{
    if (renameat2(AT_FDCWD, next.c_str(), AT_FDCWD, current.c_str(), RENAME_EXCHANGE) == 0) { return; }
    if (errno != EINVAL && errno != ENOSYS && errno != ENOTSUP)
    {
        throwRefused(current, "could not be replaced", errno);
    }
    // A file system that cannot exchange: between the two renames only the old folder's other name is there, which
    // removeLeftovers knows how to put back.
    const fs::path aside = current.parent_path() / fmt::format(".{}.old-{}", current.filename().string(), getpid());
    giveName(current, aside);
    giveName(next, current);
    giveName(aside, next);
}

void syncTree(const fs::path& folder)
{
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    {
        if (entry.is_symlink()) { continue; }
        if (entry.is_directory()) { syncTree(entry.path()); }
        else { syncToDisk(entry.path()); }
    }
    syncToDisk(folder);
}

fs::path parentOf(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// A folder's path as one wrote it, without a slash at its end that would hide its name.
fs::path withoutSlash(const fs::path& path)
{
    const fs::path normal = path.lexically_normal();
    return normal.has_filename() ? normal : normal.parent_path();
}

} // namespace

AtomicFolder::AtomicFolder(fs::path destination)
    : destination_(withoutSlash(destination)), temporary_(temporaryName(destination_))
{
    std::error_code ignored;
    fs::remove_all(temporary_, ignored);
    makeFolder(temporary_);
}

AtomicFolder::~AtomicFolder()
{
    std::error_code ignored;
    if (!committed_) { fs::remove_all(temporary_, ignored); }
}

void AtomicFolder::commit()
{
    syncTree(temporary_);
    std::error_code ignored;
    const bool replaces = fs::exists(fs::symlink_status(destination_, ignored));
    if (replaces) { exchange(temporary_, destination_); }
    else { giveName(temporary_, destination_); }
    committed_ = true;
    syncToDisk(parentOf(destination_));
    if (replaces) { fs::remove_all(temporary_, ignored); }
}

void removeLeftovers(const fs::path& directory)
{
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory, ignored))
    {
        const auto leftover = parseTemporary(entry.path().filename().string());
        if (!leftover || livesElsewhere(leftover->pid)) { continue; }
        const fs::path final = directory / leftover->final;
        if (leftover->kind == "old" && !fs::exists(final, ignored)) { fs::rename(entry.path(), final, ignored); }
        else { fs::remove_all(entry.path(), ignored); }
    }
}

void removeFolder(const fs::path& folder)
{
    const fs::path path = withoutSlash(folder);
    const fs::path aside = temporaryName(path);
    std::error_code error;
    fs::remove_all(aside, error);
    if (std::rename(path.c_str(), aside.c_str()) != 0) { throwRefused(path, "could not be removed", errno); }
    fs::remove_all(aside, error);
    if (error) { throwRefused(path, "could not be removed", error.value()); }
}

} // namespace isph
