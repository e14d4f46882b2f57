#include "case/RunLock.hpp"

#include "core/Error.hpp"
#include "support/inChild.hpp"
#include "support/TemporaryFolder.hpp"

#include <csignal>
#include <gmock/gmock.h>
#include <optional>

using namespace isph;
using testing::HasSubstr;

TEST(RunLock, refusesASecondAndNamesTheFirst)
{
    const TemporaryFolder place;
    std::optional<RunLock> lock(std::in_place, place.path());
    try
    {
        const RunLock second(place.path());
        FAIL();
    }
    catch (const Error& error)
    {
        EXPECT_EQ(error.fault(), Fault::input);
        EXPECT_THAT(error.what(), HasSubstr("is being solved by process " + std::to_string(getpid()) + " already"));
    }
    lock.reset();
    EXPECT_TRUE(std::filesystem::is_empty(place.path()));
    const RunLock again(place.path());
}

TEST(RunLock, anotherProcessIsRefused)
{
    const TemporaryFolder place;
    const RunLock lock(place.path());
    const int status = inChild(
        [&]
        {
            try
            {
                const RunLock second(place.path());
            }
            catch (const Error&)
            {
                return 7;
            }
            return 8;
        });
    EXPECT_EQ(WEXITSTATUS(status), 7);
}

TEST(RunLock, aKillLeavesNoLock)
{
    const TemporaryFolder place;
    const int status = inChild(
        [&]
        {
            const RunLock lock(place.path());
            std::raise(SIGKILL);
            return 0;
        });
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_NO_THROW(RunLock(place.path()));
    EXPECT_TRUE(std::filesystem::is_empty(place.path()));
}

TEST(RunLock, needsACaseToWriteTo)
{
    const TemporaryFolder place;
    EXPECT_THROW(RunLock(place / "missing"), Error);
}
