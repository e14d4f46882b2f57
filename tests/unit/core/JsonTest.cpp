#include "core/Json.hpp"

#include "core/numberText.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using namespace isph;

TEST(Json, values)
{
    EXPECT_EQ(Json().text(), "null\n");
    EXPECT_EQ(Json(true).text(), "true\n");
    EXPECT_EQ(Json(3).text(), "3\n");
    EXPECT_EQ(Json(std::size_t{51380224}).text(), "51380224\n");
    EXPECT_EQ(Json(0.1).text(), "0.1\n");
    EXPECT_EQ(Json(1.3e-8).text(), "1.3e-08\n");
    EXPECT_EQ(Json(std::numeric_limits<double>::quiet_NaN()).text(), "null\n");
    EXPECT_EQ(Json(std::numeric_limits<double>::infinity()).text(), "null\n");
    EXPECT_EQ(Json("a \"quote\", a \\ and\na line\x01").text(), "\"a \\\"quote\\\", a \\\\ and\\na line\\u0001\"\n");
}

TEST(Json, objectsKeepTheirOrder)
{
    Json json = Json::object({{"schema", 1}, {"case", "cavity"}});
    json.set("points", Json::arrayOf(std::array{160, 160, 1})).set("schema", 2);
    json.set("errors", Json::object({{"U", Json::object({{"relL2", 1.2e-6}})}}));
    json.set("empty", Json::object());
    EXPECT_EQ(json.text(), R"({
  "schema": 2,
  "case": "cavity",
  "points": [160, 160, 1],
  "errors": {
    "U": {
      "relL2": 1.2e-06
    }
  },
  "empty": {}
}
)");
}

TEST(Json, arraysOfObjectsTakeLines)
{
    Json json = Json::array();
    json.add(Json::object({{"a", 1}})).add(2);
    EXPECT_EQ(json.text(), "[\n  {\n    \"a\": 1\n  },\n  2\n]\n");
    EXPECT_EQ(Json::array().text(), "[]\n");
}

TEST(numberText, isShort)
{
    EXPECT_EQ(numberText(0), "0");
    EXPECT_EQ(numberText(-0.0), "-0");
    EXPECT_EQ(numberText(100000), "100000");
    EXPECT_EQ(numberText(-16), "-16");
    EXPECT_EQ(numberText(0.1), "0.1");
    EXPECT_EQ(numberText(1e-5), "1e-05");
    EXPECT_EQ(numberText(1e300), "1e+300");
    EXPECT_EQ(numberText(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(numberText, readsBackAsTheSameBits)
{
    std::mt19937_64 random(7);
    for (int draw = 0; draw < 20000; ++draw)
    {
        const double value = std::bit_cast<double>(random());
        if (value != value) { continue; }
        const double back = std::strtod(numberText(value).c_str(), nullptr);
        EXPECT_EQ(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(value)) << numberText(value);
    }
}
