#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isph
{

/// Removes the time folders of a run that purgeWrite no longer keeps; never those it did not write.
class PurgeWrite
{
public:
    /// \param keep number of folders; 0: all
    PurgeWrite(std::filesystem::path caseDirectory, int keep);

    /// A time folder was written.
    void wrote(const std::string& timeName);

private:
    std::filesystem::path caseDirectory_;
    int keep_;
    std::vector<std::string> written_;
};

} // namespace isph
