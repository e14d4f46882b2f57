#include "core/readJson.hpp"
#include "core/Json.hpp"
#include "support/messageOf.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace isph
{

TEST(ReadJson, FindsPlainValuesByTheirScopedNames)
{
    const JsonValues values = parseJson(R"({"a": 1.5e-3, "b": {"c": [1, {"x\"y\n": 2}], "e": {}, "f": []}, "word": "t",
        "yes": true, "no": false, "none": null})",
                                        "report.json");
    EXPECT_EQ(values.number("a"), 1.5e-3);
    EXPECT_EQ(values.number("b.c.0"), 1);
    EXPECT_EQ(values.number("b.c.1.x\"y\n"), 2);
    EXPECT_EQ(values.number("yes"), 1);
    EXPECT_EQ(values.number("no"), 0);
    EXPECT_TRUE(std::isnan(*values.number("none")));
    EXPECT_FALSE(values.number("b"));
    EXPECT_FALSE(values.number("word"));
}

TEST(ReadJson, ReadsWhatWeWrite)
{
    const Json json = Json::object({{"text", "a \"b\"\\"}, {"steps", 12}, {"list", Json::array({0.1, -3e300})}});
    const JsonValues values = parseJson(json.text(), "report.json");
    EXPECT_EQ(values.number("steps"), 12);
    EXPECT_EQ(values.number("list.0"), 0.1);
    EXPECT_EQ(values.number("list.1"), -3e300);
}

TEST(ReadJson, NamesTheLineOfWhatIsNone)
{
    const auto message = [](const char* text) { return messageOf([text] { parseJson(text, "report.json"); }); };
    EXPECT_EQ(message("{\"a\": 1,\n\"b\" 2}"), "report.json:2: is no JSON: a ':' is missing");
    EXPECT_EQ(message("{\"a\": }"), "report.json:1: is no JSON: a value is missing");
    EXPECT_EQ(message("{\"a\": 1"), "report.json:1: is no JSON: a '}' is missing");
    EXPECT_EQ(message("1 2"), "report.json:1: has something behind its end");
    EXPECT_EQ(message("\"open"), "report.json:1: is no JSON: a '\"' is missing");
    EXPECT_EQ(message(""), "report.json:1: is no JSON: a value is missing");
    EXPECT_EQ(message(std::string(1000, '[').c_str()), "report.json:1: is nested too deeply");
}

} // namespace isph
