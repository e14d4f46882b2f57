#pragma once

#include <filesystem>

namespace isph
{

/// A folder that appears under its name only when it is complete.
///
/// It is filled under a temporary name beside the final one (".0.25.tmp-4711"); commit() syncs it to disk and renames
/// it. A folder that already has the name stays until the new one is in place. Without a commit (an exception, a kill)
/// the final name is untouched; what a killed run left is taken away by removeLeftovers.
class AtomicFolder
{
public:
    /// \throws Error(input) if the temporary folder cannot be made.
    explicit AtomicFolder(std::filesystem::path destination);

    /// Removes the temporary folder unless it was committed.
    ~AtomicFolder();
    AtomicFolder(const AtomicFolder&) = delete;
    AtomicFolder& operator=(const AtomicFolder&) = delete;

    /// The folder to write into.
    const std::filesystem::path& path() const { return temporary_; }

    /// Gives the folder its name.
    /// \throws Error(input) naming what could not be written, and why; the old folder is then as it was.
    void commit();

private:
    std::filesystem::path destination_;
    std::filesystem::path temporary_;
    bool committed_ = false;
};

/// Removes what killed runs left half-written in a directory, and puts back a folder that was being replaced.
/// Leaves alone what a process that still lives is writing.
void removeLeftovers(const std::filesystem::path& directory);

/// Removes a folder so that it is never seen half-removed under its name.
/// \throws Error(input) if the machine refuses.
void removeFolder(const std::filesystem::path& folder);

} // namespace isph
