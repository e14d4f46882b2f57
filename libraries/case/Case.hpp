#pragma once

#include "dictionary/Dictionary.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace isph
{

/// A case directory (contract, section 1). Reading is relative to it; nothing is cached.
class Case
{
public:
    /// \throws Error(input) if the directory does not exist or holds no case (neither system/ nor constant/).
    explicit Case(const std::filesystem::path& directory);

    const std::filesystem::path& directory() const { return directory_; }

    /// Name of the directory, e.g. "taylorGreen2D", also for "-case .".
    std::string name() const;

    /// Reads a dictionary; messages show the path as given here, e.g. "system/schemes".
    /// \throws Error(input) if it is missing: says which program writes it or what to put there.
    Dictionary dictionary(const std::string& relative) const;
    bool has(const std::string& relative) const;
    std::filesystem::path path(const std::string& relative) const { return directory_ / relative; }

private:
    std::filesystem::path directory_;
};

} // namespace isph
