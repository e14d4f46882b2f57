#pragma once

#include <filesystem>

namespace isph
{

/// Keeps a second solver off a case for as long as it lives. The machine lets go of it when the process ends, however
/// it ends, so that there are no stale locks.
class RunLock
{
public:
    /// \throws Error(input) if another process is solving the case (naming its pid), or the case cannot be written to.
    explicit RunLock(const std::filesystem::path& caseDirectory);
    ~RunLock();
    RunLock(const RunLock&) = delete;
    RunLock& operator=(const RunLock&) = delete;

private:
    std::filesystem::path file_;
    int descriptor_ = -1;
};

} // namespace isph
