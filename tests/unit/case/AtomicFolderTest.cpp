#include "case/AtomicFolder.hpp"

#include "case/PurgeWrite.hpp"
#include "core/Error.hpp"
#include "core/FileDescriptor.hpp"
#include "core/writeTextFile.hpp"
#include "support/inChild.hpp"
#include "support/TemporaryFolder.hpp"

#include <csignal>
#include <fstream>
#include <gmock/gmock.h>
#include <sys/resource.h>

using namespace isph;
namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

namespace
{

std::vector<std::string> namesIn(const fs::path& folder)
{
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) { names.push_back(entry.path().filename().string()); }
    return names;
}

void write(const AtomicFolder& folder, const std::string& name, const std::string& text)
{
    writeTextFile(folder.path() / name, text);
}

} // namespace

TEST(AtomicFolder, appearsWhenCommitted)
{
    const TemporaryFolder place;
    {
        AtomicFolder folder(place / "0.25");
        write(folder, "U", "new");
        write(folder, "uniform/time", "t");
        EXPECT_FALSE(fs::exists(place / "0.25"));
        folder.commit();
        EXPECT_EQ(place.textOf("0.25/U"), "new");
    }
    EXPECT_EQ(place.textOf("0.25/uniform/time"), "t");
    EXPECT_THAT(namesIn(place.path()), ElementsAre("0.25"));
}

TEST(AtomicFolder, replacesAWholeFolder)
{
    const TemporaryFolder place;
    place.write("0.25/old", "old");
    {
        AtomicFolder folder((place / "0.25").string() + "/");
        write(folder, "U", "new");
        EXPECT_EQ(place.textOf("0.25/old"), "old");
        folder.commit();
    }
    EXPECT_THAT(namesIn(place / "0.25"), ElementsAre("U"));
    EXPECT_THAT(namesIn(place.path()), ElementsAre("0.25"));
}

TEST(AtomicFolder, vanishesWithoutACommit)
{
    const TemporaryFolder place;
    place.write("0.25/old", "old");
    try
    {
        AtomicFolder folder(place / "0.25");
        write(folder, "U", "new");
        throw Error(Fault::input, "disk full");
    }
    catch (const Error&)
    {
    }
    EXPECT_EQ(place.textOf("0.25/old"), "old");
    EXPECT_THAT(namesIn(place.path()), ElementsAre("0.25"));
}

TEST(AtomicFolder, aKillLeavesNoFalseFolder)
{
    const TemporaryFolder place;
    place.write("0.25/old", "old");
    const int status = inChild(
        [&]
        {
            const AtomicFolder again(place / "0.25");
            const AtomicFolder next(place / "0.5");
            write(again, "U", "half");
            write(next, "U", "half");
            std::raise(SIGKILL);
            return 0;
        });
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(namesIn(place.path()).size(), 3U);
    EXPECT_EQ(place.textOf("0.25/old"), "old");
    EXPECT_FALSE(fs::exists(place / "0.5"));

    removeLeftovers(place.path());
    EXPECT_THAT(namesIn(place.path()), ElementsAre("0.25"));
    EXPECT_EQ(place.textOf("0.25/old"), "old");
}

TEST(AtomicFolder, aFullDiskLeavesNothing)
{
    const TemporaryFolder place;
    place.write("0.25/old", "old");
    const int status = inChild(
        [&]
        {
            std::signal(SIGXFSZ, SIG_IGN);
            const rlimit limit{1000, 1000};
            setrlimit(RLIMIT_FSIZE, &limit);
            try
            {
                AtomicFolder folder(place / "0.25");
                write(folder, "U", std::string(5000, 'x'));
                folder.commit();
            }
            catch (const Error&)
            {
                return 7;
            }
            return 8;
        });
    EXPECT_EQ(WEXITSTATUS(status), 7);
    EXPECT_THAT(namesIn(place.path()), ElementsAre("0.25"));
    EXPECT_EQ(place.textOf("0.25/old"), "old");
}

TEST(removeLeftovers, putsBackWhatWasBeingReplaced)
{
    const TemporaryFolder place;
    // A pid that no process has: of a child that is gone.
    pid_t gone = fork();
    if (gone == 0) { _exit(0); }
    waitpid(gone, nullptr, 0);
    const std::string dead = std::to_string(gone);
    const std::string alive = std::to_string(getppid());

    place.write(".0.25.old-" + dead + "/U", "old");
    place.write(".0.5.old-" + dead + "/U", "old");
    place.write("0.5/U", "new");
    place.write(".0.75.tmp-" + dead + "/U", "half");
    place.write(".report.json.tmp-" + dead, "half");
    place.write(".1.tmp-" + alive + "/U", "being written");
    for (const char* mine : {".hidden", ".a-1", ".x.tmp-", ".y.tmp-12a", ".tmp-"}) { place.write(mine, "mine"); }

    removeLeftovers(place.path());
    EXPECT_THAT(namesIn(place.path()), UnorderedElementsAre("0.25", "0.5", ".1.tmp-" + alive, ".hidden", ".a-1",
                                                            ".x.tmp-", ".y.tmp-12a", ".tmp-"));
    EXPECT_EQ(place.textOf("0.25/U"), "old");
    EXPECT_EQ(place.textOf("0.5/U"), "new");
    removeLeftovers(place / "missing");
}

TEST(removeFolder, removes)
{
    const TemporaryFolder place;
    place.write("1/U", "text");
    removeFolder(place / "1");
    EXPECT_THAT(namesIn(place.path()), ElementsAre());
    EXPECT_THROW(removeFolder(place / "1"), Error);
}

TEST(PurgeWrite, keepsTheLatestOfThisRun)
{
    const TemporaryFolder place;
    for (const char* name : {"0", "0.1", "0.2", "0.3", "0.4"}) { place.makeFolder(name); }
    PurgeWrite purge(place.path(), 2);
    for (const char* name : {"0.2", "0.2", "0.3", "0.4"}) { purge.wrote(name); }
    EXPECT_THAT(namesIn(place.path()), UnorderedElementsAre("0", "0.1", "0.3", "0.4"));

    fs::remove(place / "0.3");
    purge.wrote("0.5");
    EXPECT_THAT(namesIn(place.path()), UnorderedElementsAre("0", "0.1", "0.4"));
    PurgeWrite all(place.path(), 0);
    for (const char* name : {"0", "0.1", "0.4"}) { all.wrote(name); }
    EXPECT_EQ(namesIn(place.path()).size(), 3U);
}
