#include "spectral/wisdom.hpp"

#include "fields/threads.hpp"
#include "spectral/FourierTransform.hpp"
#include "support/inChild.hpp"
#include "support/periodicBox.hpp"
#include "support/TemporaryFolder.hpp"

#include <cstdlib>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace isph
{
namespace
{

/// A lattice for which measuring finds another plan than estimating, as a rule.
Lattice lattice() { return test::periodicBox({60, 48, 1}, {1, 1, 0}); }

std::string fingerprint(PlanEffort effort) { return FourierTransform(lattice(), 3, effort).fingerprint(); }

/// What a function returns in a process of its own: plans of earlier tests leave no trace there. A child has none of
/// the threads of its parent, so it must get along with one.
std::string inAnotherProcess(const TemporaryFolder& folder, auto&& function)
{
    const std::string answer = "answer";
    const int status = inChild(
        [&]
        {
            ::unsetenv("OMP_NUM_THREADS");
            useRequestedThreads();
            std::ofstream(folder / answer) << function();
            return 0;
        });
    EXPECT_EQ(status, 0);
    return folder.textOf(answer);
}

TEST(Wisdom, LivesInTheUsersCache)
{
    const TemporaryFolder folder;
    inAnotherProcess(
        folder,
        []
        {
            ::setenv("XDG_CACHE_HOME", "/somewhere/cache", 1);
            const std::string file = wisdomFile().string();
            EXPECT_THAT(file, testing::StartsWith("/somewhere/cache/continua/wisdom-fftw-3"));
            ::unsetenv("XDG_CACHE_HOME");
            ::setenv("HOME", "/users/somebody", 1);
            EXPECT_THAT(wisdomFile().string(), testing::StartsWith("/users/somebody/.cache/continua/wisdom-"));
            ::setenv("XDG_CACHE_HOME", "", 1);
            EXPECT_THAT(wisdomFile().string(), testing::StartsWith("/users/somebody/.cache/continua/wisdom-"));
            ::unsetenv("HOME");
            EXPECT_TRUE(wisdomFile().empty());
            return testing::Test::HasFailure() ? "failed" : "passed";
        });
    EXPECT_EQ(folder.textOf("answer"), "passed");
}

TEST(Wisdom, MakesTheSamePlansInEveryProcess)
{
    const TemporaryFolder folder;
    const auto measured = [&folder]
    {
        ::setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
        return fingerprint(PlanEffort::measured);
    };
    const std::string first = inAnotherProcess(folder, measured);
    EXPECT_EQ(first.size(), 16U);

    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "cache/continua"))
    {
        EXPECT_THAT(entry.path().filename().string(), testing::StartsWith("wisdom-fftw")) << "no temporary file stays";
        ++files;
    }
    EXPECT_EQ(files, 2U) << "wisdom and its lock";
    for (int run = 0; run < 3; ++run) { EXPECT_EQ(inAnotherProcess(folder, measured), first); }
}

TEST(Wisdom, WithoutAHomePlansAreEstimated)
{
    const TemporaryFolder folder;
    const std::string estimated = inAnotherProcess(folder, [] { return fingerprint(PlanEffort::estimated); });
    const auto homeless = []
    {
        ::unsetenv("XDG_CACHE_HOME");
        ::unsetenv("HOME");
        return fingerprint(PlanEffort::measured);
    };
    EXPECT_EQ(inAnotherProcess(folder, homeless), estimated);
}

TEST(Wisdom, ThatCannotBeSavedIsNotUsed)
{
    const TemporaryFolder folder;
    const std::string estimated = inAnotherProcess(folder, [] { return fingerprint(PlanEffort::estimated); });

    // The cache's place is taken by a file.
    folder.write("cache", "no folder");
    const auto blocked = [&folder]
    {
        ::setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
        return fingerprint(PlanEffort::measured);
    };
    EXPECT_EQ(inAnotherProcess(folder, blocked), estimated);

    // Everything works until the new wisdom is written: what was measured by then must not find its way into the plans.
    const auto full = [&folder]
    {
        ::setenv("XDG_CACHE_HOME", (folder / "full").c_str(), 1);
        std::filesystem::create_directories(wisdomFile().string() + ".new-" + std::to_string(::getpid()));
        return fingerprint(PlanEffort::measured);
    };
    EXPECT_EQ(inAnotherProcess(folder, full), estimated);
}

TEST(Wisdom, OfOtherPlansDoesNotChangeEstimatedOnes)
{
    const TemporaryFolder folder;
    const std::string estimated = inAnotherProcess(folder, [] { return fingerprint(PlanEffort::estimated); });
    const auto after = [&folder]
    {
        ::setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
        fingerprint(PlanEffort::measured);
        return fingerprint(PlanEffort::estimated);
    };
    EXPECT_EQ(inAnotherProcess(folder, after), estimated);
}

TEST(Wisdom, ThatIsBrokenIsMadeAnew)
{
    const TemporaryFolder folder;
    const auto measured = [&folder]
    {
        ::setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
        std::filesystem::create_directories(wisdomFile().parent_path());
        std::ofstream(wisdomFile()) << "(fftw-3.3.10 fftw_wisdom #x0 nonsense";
        const std::string first = fingerprint(PlanEffort::measured);
        return first == fingerprint(PlanEffort::measured) ? "same" : "changed";
    };
    EXPECT_EQ(inAnotherProcess(folder, measured), "same");
}

TEST(Wisdom, InACacheThatMayOnlyBeReadIsNotReliedOn)
{
    if (::geteuid() == 0) { GTEST_SKIP() << "nothing is read-only for root"; }
    const TemporaryFolder folder;
    const std::string estimated = inAnotherProcess(folder, [] { return fingerprint(PlanEffort::estimated); });
    folder.makeFolder("cache");
    std::filesystem::permissions(folder / "cache",
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    const auto blocked = [&folder]
    {
        ::setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
        return fingerprint(PlanEffort::measured);
    };
    EXPECT_EQ(inAnotherProcess(folder, blocked), estimated);
    std::filesystem::permissions(folder / "cache", std::filesystem::perms::owner_all);
}

} // namespace
} // namespace isph
