#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace isph
{

/// An open file of the operating system, closed when it goes; every refusal of the machine becomes an Error.
class FileDescriptor
{
public:
    /// \param flags of open(2); the file is never inherited by other programs
    /// \throws Error(input) naming the file and the reason.
    FileDescriptor(std::filesystem::path file, int flags);
    ~FileDescriptor();
    FileDescriptor(FileDescriptor&& other) noexcept;
    FileDescriptor& operator=(FileDescriptor&&) = delete;

    int number() const { return number_; }
    const std::filesystem::path& file() const { return file_; }

    /// Writes all of the text, or throws Error(input).
    void write(std::string_view text);

    /// Waits until what was written is on the disk.
    void sync();

private:
    std::filesystem::path file_;
    int number_;
};

/// The error for something the machine refused: "0.25/fields.h5: could not be written: No space left on device".
/// \param reason an errno
[[noreturn]] void throwRefused(const std::filesystem::path& file, const std::string& action, int reason);

/// Makes a folder and those it is in.
/// \throws Error(input)
void makeFolder(const std::filesystem::path& folder);

/// Syncs a file or a folder (its list of names) to disk.
/// \throws Error(input)
void syncToDisk(const std::filesystem::path& path);

/// The name that `file` has while this process writes it: ".<name>.tmp-<pid>" beside it.
std::filesystem::path temporaryName(const std::filesystem::path& file);

} // namespace isph
