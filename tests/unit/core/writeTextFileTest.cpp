#include "core/writeTextFile.hpp"

#include "core/Error.hpp"
#include "core/FileDescriptor.hpp"
#include "support/inChild.hpp"
#include "support/TemporaryFolder.hpp"

#include <csignal>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/resource.h>

using namespace isph;
using testing::HasSubstr;

namespace
{

std::size_t filesIn(const std::filesystem::path& folder)
{
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

} // namespace

TEST(writeTextFile, makesFoldersAndReplaces)
{
    const TemporaryFolder folder;
    writeTextFile(folder / "a/b/c.txt", "one");
    writeTextFile(folder / "a/b/c.txt", "two");
    EXPECT_EQ(folder.textOf("a/b/c.txt"), "two");
    EXPECT_EQ(filesIn(folder / "a/b"), 1U);
}

TEST(writeTextFile, followsLinks)
{
    const TemporaryFolder folder;
    folder.write("real", "one");
    std::filesystem::create_symlink("real", folder / "link");
    writeTextFile(folder / "link", "two");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
    EXPECT_EQ(folder.textOf("real"), "two");
}

TEST(writeTextFile, aFullDiskLeavesTheOldFile)
{
    const TemporaryFolder folder;
    folder.write("report.json", "old");
    const int status = inChild(
        [&]
        {
            std::signal(SIGXFSZ, SIG_IGN);
            const rlimit limit{1000, 1000};
            setrlimit(RLIMIT_FSIZE, &limit);
            try
            {
                writeTextFile(folder / "report.json", std::string(5000, 'x'));
            }
            catch (const Error& error)
            {
                const std::string text = error.what();
                const bool names = text.find("report.json") != text.npos && text.find("too large") != text.npos;
                return error.fault() == Fault::input && names ? 7 : 8;
            }
            return 9;
        });
    EXPECT_EQ(WEXITSTATUS(status), 7);
    EXPECT_EQ(folder.textOf("report.json"), "old");
    EXPECT_EQ(filesIn(folder.path()), 1U);
}

TEST(writeTextFile, namesFileAndReason)
{
    const TemporaryFolder folder;
    folder.write("file", "");
    try
    {
        writeTextFile(folder / "file/below", "text");
        FAIL();
    }
    catch (const Error& error)
    {
        EXPECT_THAT(error.what(),
                    HasSubstr((folder / "file").string() + ": folder could not be made: Not a directory"));
    }
}

TEST(FileDescriptor, aFullDeviceIsAnError)
{
    FileDescriptor full("/dev/full", O_WRONLY);
    try
    {
        full.write("text");
        FAIL();
    }
    catch (const Error& error)
    {
        EXPECT_THAT(error.what(), HasSubstr("/dev/full: could not be written: No space left on device"));
    }
}
