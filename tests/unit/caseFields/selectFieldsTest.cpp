#include "caseFields/selectFields.hpp"
#include "core/Error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

using testing::ElementsAre;

std::vector<std::string> selected(const std::vector<std::string>& arguments)
{
    const Application application{.name = "test", .summary = "", .examples = "", .options = fieldOptions};
    const std::vector<std::string> available{"U", "p"};
    return selectFields(available, CommandLine(application, arguments));
}

TEST(SelectFields, TakesAllWithoutTheOption) { EXPECT_THAT(selected({}), ElementsAre("U", "p")); }

TEST(SelectFields, TakesListsAndWords)
{
    EXPECT_THAT(selected({"-fields", "(p U)"}), ElementsAre("p", "U"));
    EXPECT_THAT(selected({"-fields", "p"}), ElementsAre("p"));
    EXPECT_THAT(selected({"-fields", "U,p"}), ElementsAre("U", "p"));
}

TEST(SelectFields, RefusesWhatIsNotThere)
{
    try
    {
        selected({"-fields", "(U q)"});
        FAIL() << "accepted";
    }
    catch (const Error& error)
    {
        EXPECT_EQ(error.fault(), Fault::input);
        EXPECT_STREQ(error.what(), "-fields: 'q' is not a known field\n    known are: U, p");
    }
    try
    {
        selected({"-fields", "()"});
        FAIL() << "accepted";
    }
    catch (const Error& error)
    {
        EXPECT_EQ(error.fault(), Fault::usage);
        EXPECT_STREQ(error.what(), "-fields names no field\n    write e.g. -fields '(U p)'");
    }
}

} // namespace
} // namespace isph
