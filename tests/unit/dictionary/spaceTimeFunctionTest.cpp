#include "dictionary/SpaceTimeFunction.hpp"
#include "support/messageOf.hpp"
#include "support/TemporaryFolder.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

using testing::Each;
using testing::ElementsAre;

Dictionary parse(const std::string& text) { return Dictionary::parse(text, "0/U", ""); }

SpaceTimeFunction functionOf(const std::string& text, int components, const std::filesystem::path& folder = "")
{
    return readFunction(parse(text), "value", components, {{"nu", 0.5}}, folder);
}

std::string messageFor(const std::string& text, int components, const std::filesystem::path& folder = "")
{
    return messageOf([&] { static_cast<void>(functionOf(text, components, folder)); });
}

TEST(SpaceTimeFunction, ReadsUniformValues)
{
    for (const char* text : {"value uniform (1 2 3);", "value (1 2 3);"})
    {
        const SpaceTimeFunction function = functionOf(text, 3);
        EXPECT_EQ(function.components(), 3);
        EXPECT_TRUE(function.isUniform());
        EXPECT_FALSE(function.dependsOnTime());
        EXPECT_EQ(function(2, 0, 0, 0, 0), 3);
        std::vector<double> values(4);
        function.evaluate(1, {}, {}, {}, 0, values);
        EXPECT_THAT(values, Each(2));
    }
    EXPECT_EQ(functionOf("value uniform 7;", 1)(0, 0, 0, 0, 0), 7);
    EXPECT_EQ(functionOf("value 7;", 1)(0, 0, 0, 0, 0), 7);
}

TEST(SpaceTimeFunction, ReadsExpressions)
{
    const SpaceTimeFunction function = functionOf("value expression (\"x + y\" \"z\" \"U0*t*nu\"); U0 4;", 3);
    EXPECT_EQ(function(0, 1, 2, 0, 0), 3);
    EXPECT_EQ(function(2, 0, 0, 0, 3), 6);
    EXPECT_FALSE(function.isUniform());
    EXPECT_TRUE(function.dependsOnTime());
    EXPECT_TRUE(functionOf("value expression (\"1\" \"2\" \"nu\");", 3).isUniform());
    EXPECT_FALSE(functionOf("value expression \"x\";", 1).dependsOnTime());
    EXPECT_EQ(functionOf("value expression (\"x\");", 1)(0, 5, 0, 0, 0), 5);
}

TEST(SpaceTimeFunction, PrefersTheConstantsOfTheDictionary)
{
    EXPECT_EQ(functionOf("nu 2; value expression \"nu\";", 1)(0, 0, 0, 0, 0), 2);
    const Dictionary nested = parse("nu 3; inner { value expression \"nu\"; }");
    EXPECT_EQ(readFunction(nested.dictionary("inner"), "value", 1, {{"nu", 1}}, "")(0, 0, 0, 0, 0), 3);
}

TEST(SpaceTimeFunction, ReadsTables)
{
    const TemporaryFolder folder;
    folder.write("inlet.csv", "# measured\n\"y [m]\",U.x [m/s],U.y [m/s],U.z [m/s]\n0,0,0,1\n\n0.5,1,0,1\r\n1,0,0,1\n");
    const SpaceTimeFunction function = functionOf("value table \"inlet.csv\";", 3, folder.path());
    EXPECT_EQ(function.components(), 3);
    EXPECT_FALSE(function.isUniform());
    EXPECT_FALSE(function.dependsOnTime());
    EXPECT_EQ(function(0, 9, 0.5, 9, 9), 1);
    EXPECT_EQ(function(2, 9, 0.3, 9, 9), 1);
    // The natural spline through (0 0), (1/2 1), (1 0): 3s - 4s^3 on the first half.
    EXPECT_DOUBLE_EQ(function(0, 0, 0.25, 0, 0), 3 * 0.25 - 4 * 0.25 * 0.25 * 0.25);
    EXPECT_EQ(function(0, 0, -1, 0, 0), 0); // outside, the ends are held
    std::vector<double> values(2);
    const std::vector<double> y = {0.5, 1};
    function.evaluate(0, {}, y, {}, 0, values);
    EXPECT_THAT(values, ElementsAre(1, 0));

    folder.write("p.csv", "p,t\n1,0\n3,2\n");
    const SpaceTimeFunction pressure = functionOf("value table \"p.csv\";", 1, folder.path());
    EXPECT_TRUE(pressure.dependsOnTime());
    EXPECT_EQ(pressure(0, 0, 0, 0, 1), 2);
}

TEST(SpaceTimeFunction, InterpolatesWithFourthOrder)
{
    const TemporaryFolder folder;
    const auto errorWith = [&folder](int intervals)
    {
        std::string text = "x,f\n";
        for (int i = 0; i <= intervals; ++i)
        {
            const double x = static_cast<double>(i) / intervals;
            text += std::to_string(x) + "," + std::to_string(std::sin(2 * M_PI * x)) + "\n";
        }
        folder.write("f.csv", text);
        const SpaceTimeFunction function = functionOf("value table \"f.csv\";", 1, folder.path());
        double largest = 0;
        for (int i = 0; i < 500; ++i)
        {
            const double x = i / 500.0;
            largest = std::max(largest, std::abs(function(0, x, 0, 0, 0) - std::sin(2 * M_PI * x)));
        }
        return largest;
    };
    // Order 4, sin'' being zero at the ends; six digits in the file leave 1e-6.
    EXPECT_LT(errorWith(16), errorWith(8) / 12);
}

TEST(SpaceTimeFunction, NamesTheEntryAndThePointWhereItIsNotFinite)
{
    const SpaceTimeFunction function = functionOf("\nvalue expression \"1/x\";", 1);
    EXPECT_EQ(messageOf([&] { function(0, 0, 1, 2, 3); }), "0/U:2: value: \"1/x\" is infinite at (0 1 2), t = 3");
}

struct Slip
{
    std::string text;
    int components;
    std::string message;
};

class FunctionMessage : public testing::TestWithParam<Slip>
{
};

TEST_P(FunctionMessage, SaysWhereAndWhat)
{
    EXPECT_EQ(messageFor(GetParam().text, GetParam().components), "0/U:" + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Functions, FunctionMessage,
    testing::Values(
        Slip{"a 1;", 1, " value: is missing, uniform, expression or table is needed"},
        Slip{"value fast;", 1, "1: value: is fast but must be uniform, expression or table\n    e.g. value uniform 0;"},
        Slip{"value { a 1; }", 1, "1: value: is a dictionary but must be uniform, expression or table"},
        Slip{"value;", 3, "1: value: is empty but must be uniform, expression or table"},
        Slip{"value uniform 1;", 3, "1: value: is uniform 1 but needs three numbers\n    e.g. value uniform (1 0 0);"},
        Slip{"value uniform (1 0 0);", 1, "1: value: is uniform (1 0 0) but needs a number\n    e.g. value uniform 0;"},
        Slip{"value uniform (1 nan 0);", 3,
             "1: value: is uniform (1 nan 0) but needs three numbers\n    e.g. value uniform (1 0 0);"},
        Slip{"value expression \"x\";", 3,
             "1: value: is expression \"x\" but needs three strings\n"
             "    e.g. value expression (\"sin(x)\" \"0\" \"0\");"},
        Slip{"value expression x;", 1,
             "1: value: is expression x but needs one string\n    e.g. value expression \"sin(x)\";"},
        Slip{"value expression\n(\n\"x\"\n\"sni(x)\"\n\"0\");", 3,
             "4: value: \"sni(x)\" has the unknown function 'sni' (character 1)\n    did you mean 'sin'?"},
        Slip{"value table \"/nonexistent.csv\";", 1,
             "1: value: table \"/nonexistent.csv\": cannot be read: No such file or directory"}));

TEST(SpaceTimeFunction, SaysWhatIsWrongWithATable)
{
    const TemporaryFolder folder;
    const auto messageWith = [&folder](const std::string& text)
    {
        folder.write("t.csv", text);
        return messageFor("value table \"t.csv\";", 1, folder.path());
    };
    EXPECT_EQ(messageWith("y,p\n0,1\n0,2\n"), "t.csv:3: value: has y = 0 after 0, but the coordinate must increase");
    EXPECT_EQ(messageWith("y,p\n0,1,2\n"),
              "t.csv:2: value: has 3 columns but must have 2\n    a coordinate and the value");
    EXPECT_EQ(messageWith("y,p\n0,nan\n"), "t.csv:2: value: has 'nan' where a number should be");
    EXPECT_EQ(messageWith("y,p\n0,1e999\n"), "t.csv:2: value: has '1e999' where a number should be");
    EXPECT_EQ(messageWith("# none\nr,p\n0,1\n"), "t.csv:2: value: names no coordinate column\n"
                                                 "    head the columns with names, one of them x, y, z or t");
    EXPECT_EQ(messageWith("y,p\n0,1\n"), "t.csv:2: value: ends with fewer than two rows of numbers");
    EXPECT_EQ(messageWith(""), "t.csv: value: ends with fewer than two rows of numbers");
}

} // namespace
} // namespace isph
