#pragma once

#include <filesystem>
#include <span>

namespace isph
{

/// A file being written, with every refusal of the disk reported: none is left to a buffer that is flushed too late.
class OutputFile
{
public:
    /// Creates the file or empties it. \throws Error(input) naming file and reason.
    explicit OutputFile(std::filesystem::path path);
    ~OutputFile();
    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;

    const std::filesystem::path& path() const { return path_; }

    void write(std::span<const char> bytes);

    /// Returns when the bytes are on the disk, not in a cache. \throws Error(input)
    void close();

private:
    [[noreturn]] void fail() const;

    std::filesystem::path path_;
    int descriptor_ = -1;
};

} // namespace isph
