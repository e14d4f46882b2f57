#include "case/CsvWriter.hpp"

#include "core/Error.hpp"
#include "support/inChild.hpp"
#include "support/TemporaryFolder.hpp"

#include <csignal>
#include <gmock/gmock.h>
#include <limits>
#include <sys/resource.h>
#include <utility>

using namespace isph;

TEST(CsvWriter, headerAndRows)
{
    const TemporaryFolder place;
    const auto file = postProcessingFile(place.path(), "errors", "0.25", "errors.csv");
    CsvWriter writer(file, {{"time", "s"}, {"step"}, {"L2(U)", "m/s"}, {"relL2(U)"}});
    writer.row({0.1, 100000, 1.0 / 3, std::numeric_limits<double>::quiet_NaN()});
    const std::string expected = "time [s],step,L2(U) [m/s],relL2(U)\n0.1,100000,0.3333333333333333,nan\n";
    EXPECT_EQ(place.textOf("postProcessing/errors/0.25/errors.csv"), expected) << "there without closing";

    CsvWriter moved(std::move(writer));
    moved.row(std::vector<double>{1, 2, 3, 4});
    EXPECT_EQ(place.textOf("postProcessing/errors/0.25/errors.csv"), expected + "1,2,3,4\n");
}

TEST(CsvWriter, replacesAnEarlierFile)
{
    const TemporaryFolder place;
    place.write("flow.csv", "of an earlier run\n");
    const CsvWriter writer(place / "flow.csv", {{"time", "s"}});
    EXPECT_EQ(place.textOf("flow.csv"), "time [s]\n");
}

TEST(CsvWriter, quotesWhatWouldSplit)
{
    const TemporaryFolder place;
    const CsvWriter writer(place / "a.csv", {{"p at (0, 1)", "Pa"}, {"the \"p\""}});
    EXPECT_EQ(place.textOf("a.csv"), "\"p at (0, 1) [Pa]\",\"the \"\"p\"\"\"\n");
}

TEST(CsvWriter, aFullDiskLeavesWholeRows)
{
    const TemporaryFolder place;
    const int status = inChild(
        [&]
        {
            std::signal(SIGXFSZ, SIG_IGN);
            const rlimit limit{50, 50};
            setrlimit(RLIMIT_FSIZE, &limit);
            CsvWriter writer(place / "a.csv", {{"time", "s"}, {"step"}});
            try
            {
                for (int step = 0; step < 100; ++step) { writer.row({1.0 / 3, 1.0 * step}); }
            }
            catch (const Error& error)
            {
                return std::string(error.what()).find("a.csv") != std::string::npos ? 7 : 8;
            }
            return 9;
        });
    EXPECT_EQ(WEXITSTATUS(status), 7);
    EXPECT_EQ(place.textOf("a.csv"), "time [s],step\n0.3333333333333333,0\n");
}

TEST(CsvWriter, refusesWhatCannotBeMade)
{
    const TemporaryFolder place;
    place.write("file", "");
    EXPECT_THROW(CsvWriter(place / "file/a.csv", {{"time", "s"}}), Error);
}
