#include "core/runApplication.hpp"

#include "core/Error.hpp"
#include "core/signals.hpp"

#include <csignal>
#include <filesystem>
#include <gmock/gmock.h>
#include <new>
#include <stdexcept>

using namespace isph;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

namespace
{

struct Outcome
{
    int code;
    std::string out;
    std::string err;
};

Outcome outcomeOf(void (*run)(const CommandLine&, Log&), std::vector<std::string> arguments = {}, bool banner = true)
{
    const Application application{.name = "tool",
                                  .summary = "does things",
                                  .examples = "",
                                  .options = {{"stdout", "", "data to standard output"}},
                                  .listings = {{"listWords",
                                                [] {
                                                    return std::vector<ListedWord>{{"one", "first"}};
                                                }}},
                                  .banner = banner};
    arguments.insert(arguments.begin(), "tool");
    std::vector<char*> argv;
    for (std::string& argument : arguments) { argv.push_back(argument.data()); }
    argv.push_back(nullptr);

    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = runApplication(application, static_cast<int>(arguments.size()), argv.data(), run);
    return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

void report(const CommandLine&, Log& log) { log.line("a report"); }

} // namespace

TEST(runApplication, headerReportAndEnd)
{
    const Outcome outcome = outcomeOf(report, {"-case", "."});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.out, StartsWith("/*----"));
    for (const char* part : {"Continua", "Exec   : tool -case .", "Date   : ", "Time   : ", "Host   : ", "Case   : /"})
    {
        EXPECT_THAT(outcome.out, HasSubstr(part));
    }
    EXPECT_THAT(outcome.out, EndsWith("a report\nEnd\n\n"));
    EXPECT_EQ(outcome.err, "");
}

TEST(runApplication, withoutBanner) { EXPECT_EQ(outcomeOf(report, {}, false).out, "a report\n"); }

TEST(runApplication, quietSaysNothing) { EXPECT_EQ(outcomeOf(report, {"-quiet"}).out, ""); }

TEST(runApplication, stdoutSendsTheReportToStandardError)
{
    const Outcome outcome = outcomeOf(report, {"--stdout"}, false);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "a report\n");
}

TEST(runApplication, helpVersionAndListings)
{
    EXPECT_THAT(outcomeOf(report, {"-help"}).out, StartsWith("Usage: tool"));
    EXPECT_THAT(outcomeOf(report, {"-version"}).out, StartsWith("tool (Continua) "));
    EXPECT_EQ(outcomeOf(report, {"-listWords", "-quiet"}).out, "one  first\n");
    EXPECT_EQ(outcomeOf(report, {"-listWords"}).code, 0);
}

TEST(runApplication, wrongCommandLine)
{
    const Outcome outcome = outcomeOf(report, {"-nothing"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, StartsWith("tool: unknown option -nothing\n"));
}

TEST(runApplication, errorsOfInput)
{
    const Outcome outcome = outcomeOf(
        [](const CommandLine&, Log&)
        {
            throw Error(Fault::input, {{{"system/schemes", 7, "kernel.order"}, "is odd", "write an even number"},
                                       {{"system/schemes", 9, ""}, "is strange", ""}});
        },
        {}, false);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(outcome.err, "tool: system/schemes:7: kernel.order: is odd\n    write an even number\n"
                           "tool: system/schemes:9: is strange\n");
}

TEST(runApplication, noEndAfterAnError)
{
    const Outcome outcome =
        outcomeOf([](const CommandLine&, Log&) { throw Error(Fault::diverged, "the flow diverged"); });
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.out, testing::Not(HasSubstr("End")));
}

TEST(runApplication, signals)
{
    const auto stopped = [](const CommandLine&, Log&) { throw StoppedBySignal{SIGTERM}; };
    const Outcome outcome = outcomeOf(stopped);
    EXPECT_EQ(outcome.code, 143);
    EXPECT_EQ(outcome.err, "tool: stopped by SIGTERM\n");
}

TEST(runApplication, bugsOfOurs)
{
    const Outcome outcome =
        outcomeOf([](const CommandLine&, Log&) { throw std::out_of_range("vector::at"); }, {"-case", "x"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.err, StartsWith("tool: internal error: vector::at\n"));
    EXPECT_THAT(outcome.err, HasSubstr("bug of ours"));
    EXPECT_THAT(outcome.err, HasSubstr("version: "));
    EXPECT_THAT(outcome.err, HasSubstr("command: tool -case x\n"));
}

TEST(runApplication, memoryAndFilesRefusedByTheMachine)
{
    const Outcome memory = outcomeOf([](const CommandLine&, Log&) { throw std::bad_alloc(); });
    EXPECT_EQ(memory.code, 1);
    EXPECT_THAT(memory.err, StartsWith("tool: memory was refused"));

    const Outcome file =
        outcomeOf([](const CommandLine&, Log&) { std::filesystem::directory_iterator("/nowhere/at/all"); });
    EXPECT_EQ(file.code, 1);
    EXPECT_EQ(file.err, "tool: /nowhere/at/all: No such file or directory\n");
}

TEST(runApplication, warningsAreCounted)
{
    const Outcome outcome = outcomeOf(
        [](const CommandLine&, Log& log)
        {
            log.warning("odd");
            log.warning("odd");
            log.warning("even\nmore");
        },
        {}, false);
    EXPECT_EQ(outcome.err, "tool: warning: odd\ntool: warning: even\nmore\n");
    EXPECT_EQ(outcome.out, "2 warnings:\n    odd (2 times)\n    even\n");
}
