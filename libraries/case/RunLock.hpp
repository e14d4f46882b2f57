#pragma once

#include "core/FileDescriptor.hpp"

#include <filesystem>
#include <optional>

namespace isph
{

/// Keeps a second solver off a case for as long as it lives. The machine lets go of it when the process ends, however
/// it ends, so that there are no stale locks. (On a file system that knows no locks nothing is guarded.)
class RunLock
{
public:
    /// \throws Error(input) if another process is solving the case (naming its pid), or the case cannot be written to.
    explicit RunLock(const std::filesystem::path& caseDirectory);
    ~RunLock();
    RunLock(const RunLock&) = delete;
    RunLock& operator=(const RunLock&) = delete;

private:
    std::optional<FileDescriptor> file_;
};

} // namespace isph
