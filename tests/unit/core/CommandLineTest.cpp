#include "core/CommandLine.hpp"

#include "core/Error.hpp"

#include <gmock/gmock.h>

using namespace isph;
using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

Application tool()
{
    return {.name = "tool",
            .summary = "does things",
            .examples = "tool -case cavity",
            .options = {{"overwrite", "", "replace"}, {"set", "VALUE", "the value"}},
            .listings = {{"listKernels", [] {
                              return std::vector<ListedWord>{{"gaussian", "even order"}, {"quinticSpline", "order 2"}};
                          }}}};
}

std::string refusal(const Application& application, const std::vector<std::string>& arguments)
{
    try
    {
        const CommandLine line(application, arguments);
    }
    catch (const Error& error)
    {
        EXPECT_EQ(error.fault(), Fault::usage);
        return error.what();
    }
    return "";
}

} // namespace

TEST(CommandLine, takesOneDashOrTwo)
{
    const Application application = tool();
    const CommandLine line(application, {"-overwrite", "--case", "cavity", "--set", "3"});
    EXPECT_TRUE(line.has("overwrite"));
    EXPECT_EQ(line.value("set"), "3");
    EXPECT_EQ(line.caseDirectory(), "cavity");
    EXPECT_FALSE(line.has("quiet"));
    EXPECT_EQ(line.value("quiet"), std::nullopt);
}

TEST(CommandLine, caseIsTheCurrentFolderByDefault)
{
    const Application application = tool();
    EXPECT_EQ(CommandLine(application, {}).caseDirectory(), ".");
}

TEST(CommandLine, negativeNumbersAreArguments)
{
    const Application application = tool();
    EXPECT_EQ(CommandLine(application, {"-set", "-1.5e-3"}).value("set"), "-1.5e-3");
    EXPECT_EQ(CommandLine(application, {"-set", "(-1 0 0)"}).value("set"), "(-1 0 0)");

    Application words = tool();
    words.positional = "NUMBERS";
    EXPECT_THAT(CommandLine(words, {"-0.5", "a", "--", "-overwrite"}).positional(),
                ElementsAre("-0.5", "a", "-overwrite"));
}

TEST(CommandLine, anOptionGivenTwiceTakesTheLast)
{
    const Application application = tool();
    EXPECT_EQ(CommandLine(application, {"-set", "1", "-set", "2"}).value("set"), "2");
}

TEST(CommandLine, refusals)
{
    const Application application = tool();
    EXPECT_EQ(refusal(application, {"-overwirte"}), "unknown option -overwirte\n    did you mean -overwrite?");
    EXPECT_EQ(refusal(application, {"--listkernels"}), "unknown option --listkernels\n    did you mean -listKernels?");
    EXPECT_EQ(refusal(application, {"-zzzzzz"}), "unknown option -zzzzzz\n    tool -help lists the options");
    EXPECT_EQ(refusal(application, {"-set"}), "option -set needs an argument\n    write -set VALUE");
    EXPECT_EQ(refusal(application, {"-case", "-overwrite"}), "option -case needs an argument\n    write -case DIR");
    EXPECT_EQ(refusal(application, {"stray"}),
              "'stray' is not an option and no other arguments are expected\n    tool -help shows the usage");
}

TEST(CommandLine, wholeNumbersHaveALeast)
{
    const Application application = tool();
    EXPECT_EQ(CommandLine(application, {"-set", "7"}).wholeNumber("set", 7, 9), 7);
    EXPECT_EQ(CommandLine(application, {}).wholeNumber("set", 7, 9), 9);
    for (const char* wrong : {"6", "7.5", "1e3", "99999999999", "seven", ""})
    {
        const CommandLine line(application, {"-set", wrong});
        EXPECT_THROW(line.wholeNumber("set", 7, 9), Error) << wrong;
    }
}

TEST(CommandLine, textIsWhatOneWouldType)
{
    const Application application = tool();
    EXPECT_EQ(CommandLine(application, {"-set", "(1 0 0)", "-case", "a/b-c.d"}).text(),
              "tool -set '(1 0 0)' -case a/b-c.d");
    EXPECT_EQ(CommandLine(application, {"-set", "it's"}).text(), "tool -set 'it'\\''s'");
    EXPECT_EQ(CommandLine(application, {"-set", ""}).text(), "tool -set ''");
}

TEST(CommandLine, helpNamesEveryOption)
{
    Application application = tool();
    application.positional = "FILE";
    const std::string help = helpText(application);
    EXPECT_THAT(help, HasSubstr("Usage: tool [OPTIONS] FILE\n\ndoes things\n"));
    for (const char* option : {"-overwrite", "-set VALUE", "-listKernels", "-case DIR", "-quiet", "-help", "-version"})
    {
        EXPECT_THAT(help, HasSubstr(option));
    }
    EXPECT_THAT(help, HasSubstr("Examples:\n  tool -case cavity\n"));
}

TEST(CommandLine, listingsAreAligned)
{
    EXPECT_EQ(listingText(tool().listings.front()), "gaussian       even order\nquinticSpline  order 2\n");
}
