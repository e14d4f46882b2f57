#include "dictionary/Dictionary.hpp"
#include "support/messageOf.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

using testing::ElementsAre;

Dictionary parse(const std::string& text) { return Dictionary::parse(text, "system/a", ""); }

TEST(Access, ReadsFlagsInAllSpellings)
{
    for (const char* yes : {"yes", "on", "true"}) { EXPECT_TRUE(parse(std::string("a ") + yes + ";").flag("a")); }
    for (const char* no : {"no", "off", "false"}) { EXPECT_FALSE(parse(std::string("a ") + no + ";").flag("a")); }
}

TEST(Access, ReadsLists)
{
    const Dictionary dictionary = parse("n (1 2.5 3); c 3 (1 2 3); e (); w (U \"p.*\"); one U;");
    EXPECT_THAT(dictionary.numbers("n"), ElementsAre(1, 2.5, 3));
    EXPECT_THAT(dictionary.numbers("c"), ElementsAre(1, 2, 3)); // OpenFOAM writes the count in front
    EXPECT_TRUE(dictionary.numbers("e").empty());
    const Origin origin{"system/a", 1, "w"};
    EXPECT_THAT(dictionary.words("w"), ElementsAre(Word{"U", origin}, Word{"p.*", origin}));
    EXPECT_EQ(dictionary.words("one").at(0).text, "U");
}

TEST(Access, ReadsDimensionedNumbers)
{
    const Dictionary dictionary = parse("a 0.01; b [0 2 -1 0 0 0 0] 0.02; nu nu [0 2 -1 0 0] 0.03;");
    const std::array<int, 7> viscosity{0, 2, -1, 0, 0, 0, 0};
    EXPECT_EQ(dictionary.dimensionedNumber("a", viscosity), 0.01);
    EXPECT_EQ(dictionary.dimensionedNumber("b", viscosity), 0.02);
    EXPECT_EQ(dictionary.dimensionedNumber("nu", viscosity), 0.03);
}

TEST(Access, GivesScalarsOfTheParentsAsConstants)
{
    const Dictionary dictionary = parse("U0 1; L 2; nu [0 2 -1 0 0 0 0] 0.5; a { L 3; b { word x; } } L 4; \"p.*\" 6;");
    const Dictionary& inner = dictionary.dictionary("a").dictionary("b");
    EXPECT_EQ(inner.constant("U0"), 1);
    EXPECT_EQ(inner.constant("L"), 3);
    EXPECT_EQ(inner.constant("nu"), 0.5);
    EXPECT_EQ(inner.constant("word"), std::nullopt);
    EXPECT_EQ(dictionary.constant("L"), 4);
}

TEST(Access, SetsAndRemoves)
{
    Dictionary dictionary = parse("a 1; k { x 1; }");
    dictionary.set(*parse("a 2;").find("a"));
    dictionary.set(*parse("k { y 2; }").find("k"));
    dictionary.set(*parse("b 3;").find("b"));
    EXPECT_EQ(dictionary.number("a"), 2);
    EXPECT_EQ(dictionary.dictionary("k").entries().size(), 2U);
    EXPECT_EQ(dictionary.number("b"), 3);
    dictionary.remove("a");
    dictionary.remove("none");
    EXPECT_FALSE(dictionary.has("a"));
}

TEST(Access, IsAValue)
{
    const Dictionary first = parse("k { x 1; }");
    Dictionary second = first;
    second.find("k")->dictionary().remove("x");
    EXPECT_TRUE(first.dictionary("k").has("x"));
    EXPECT_FALSE(second.dictionary("k").has("x"));
}

struct Slip
{
    std::string text;
    void (*ask)(const Dictionary&);
    std::string message;
};

class AccessMessage : public testing::TestWithParam<Slip>
{
};

TEST_P(AccessMessage, SaysWhereAndWhat)
{
    EXPECT_EQ(messageOf([&] { GetParam().ask(parse(GetParam().text)); }), GetParam().message);
}

void number(const Dictionary& d) { d.number("a"); }
void integer(const Dictionary& d) { d.integer("a"); }
void flag(const Dictionary& d) { d.flag("a"); }
void word(const Dictionary& d) { d.word("a"); }
void text(const Dictionary& d) { d.text("a"); }
void vector(const Dictionary& d) { d.vector("a"); }
void numbers(const Dictionary& d) { d.numbers("a"); }
void words(const Dictionary& d) { d.words("a"); }
void dictionary(const Dictionary& d) { d.dictionary("a"); }
void dimensions(const Dictionary& d) { d.dimensions("a"); }
void dimensioned(const Dictionary& d) { d.dimensionedNumber("a", {0, 2, -1, 0, 0, 0, 0}); }

INSTANTIATE_TEST_SUITE_P(
    Numbers, AccessMessage,
    testing::Values(Slip{"b 1;", number, "system/a: a: is missing, a number is needed"},
                    Slip{"\nA 1;", number,
                         "system/a: a: is missing, a number is needed\n    is 'A' in line 2 meant for it?"},
                    Slip{"a nan;", number, "system/a:1: a: is nan but must be a number"},
                    Slip{"a inf;", number, "system/a:1: a: is inf but must be a number"},
                    Slip{"a -inf;", number, "system/a:1: a: is -inf but must be a number"},
                    Slip{"a 0x10;", number, "system/a:1: a: is 0x10 but must be a number"},
                    Slip{"\na \"1\";", number, "system/a:2: a: is \"1\" but must be a number"},
                    Slip{"a { b 1; }", number, "system/a:1: a: is a dictionary but must be a number"},
                    Slip{"a;", number, "system/a:1: a: is empty but must be a number"},
                    Slip{"a 1\nb 2;", number,
                         "system/a:1: a: is 1 b 2 but must be a number\n    is the ';' missing at the end of line 1?"},
                    Slip{"a 1.5;", integer, "system/a:1: a: is 1.5 but must be a whole number"},
                    Slip{"a x;", integer, "system/a:1: a: is x but must be a whole number"},
                    Slip{"a 3000000000;", integer,
                         "system/a:1: a: is 3000000000 but must be a whole number from -2147483648 to 2147483647"},
                    Slip{"a 1e300;", integer,
                         "system/a:1: a: is 1e300 but must be a whole number from -2147483648 to 2147483647"}));

INSTANTIATE_TEST_SUITE_P(
    Others, AccessMessage,
    testing::Values(
        Slip{"a maybe;", flag, "system/a:1: a: is maybe but must be yes or no (on/off, true/false)"},
        Slip{"a 1;", word, "system/a:1: a: is 1 but must be a word"},
        Slip{"a (b c);", text, "system/a:1: a: is (b c) but must be a word or a quoted string"},
        Slip{"a (1 2);", vector, "system/a:1: a: is (1 2) but must be a vector of three numbers, e.g. (1 0 0)"},
        Slip{"a (1 2 x);", vector, "system/a:1: a: is (1 2 x) but must be a vector of three numbers, e.g. (1 0 0)"},
        Slip{"a 2 (1 2 3);", numbers, "system/a:1: a: is 2 (1 2 3) but must be a list of numbers, e.g. (1 2 3)"},
        Slip{"a ((1));", numbers, "system/a:1: a: is ((1)) but must be a list of numbers, e.g. (1 2 3)"},
        Slip{"a 1;", words, "system/a:1: a: is 1 but must be a list of words, e.g. (U p)"},
        Slip{"a 1;", dictionary, "system/a:1: a: is 1 but must be a dictionary { ... }"},
        Slip{"a [0 1];", dimensions,
             "system/a:1: a: is [0 1] but must be seven whole exponents, e.g. [0 1 -1 0 0 0 0]"},
        Slip{"a [0 1.5 0 0 0 0 0];", dimensions,
             "system/a:1: a: is [0 1.5 0 0 0 0 0] but must be seven whole exponents, e.g. [0 1 -1 0 0 0 0]"},
        Slip{"a [0 1 0 0 0 0 0] 3;", dimensioned,
             "system/a:1: a: has the dimensions [0 1 0 0 0 0 0] but must have [0 2 -1 0 0 0 0]\n"
             "    they are the exponents of kg, m, s, K, mol, A and cd"},
        Slip{"a [0 1 x] 3;", dimensioned,
             "system/a:1: a: is [0 1 x] 3 but must be a number behind seven whole exponents"},
        Slip{"a b;", dimensioned, "system/a:1: a: is b but must be a number, perhaps behind dimensions"}));

TEST(Access, NamesTheKeyThatWasProbablyMeant)
{
    const Dictionary dictionary = parse("kernel\n{\n    ordr 4;\n}");
    EXPECT_EQ(messageOf([&] { dictionary.dictionary("kernel").integer("order"); }),
              "system/a:2: kernel.order: is missing, a whole number is needed\n    is 'ordr' in line 3 meant for it?");
}

TEST(Access, BuildsErrorsAtTheEntry)
{
    const Dictionary dictionary = parse("k\n{\n    a 1;\n}");
    EXPECT_STREQ(dictionary.dictionary("k").error("a", "is odd", "take 2").what(),
                 "system/a:3: k.a: is odd\n    take 2");
    EXPECT_STREQ(dictionary.error("", "is odd").what(), "system/a: is odd");
}

} // namespace
} // namespace isph
