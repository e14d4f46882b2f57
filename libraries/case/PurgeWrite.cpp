#include "case/PurgeWrite.hpp"

#include "case/AtomicFolder.hpp"

#include <algorithm>
#include <utility>

namespace isph
{

PurgeWrite::PurgeWrite(std::filesystem::path caseDirectory, int keep)
    : caseDirectory_(std::move(caseDirectory)), keep_(keep)
{
}

void PurgeWrite::wrote(const std::string& timeName)
{
    if (std::ranges::find(written_, timeName) == written_.end()) { written_.push_back(timeName); }
    while (keep_ > 0 && written_.size() > static_cast<std::size_t>(keep_))
    {
        // The user may have removed it already.
        if (std::filesystem::exists(caseDirectory_ / written_.front()))
        {
            removeFolder(caseDirectory_ / written_.front());
        }
        written_.erase(written_.begin());
    }
}

} // namespace isph
