#include "dictionary/Dictionary.hpp"
#include "support/messageOf.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

Dictionary parse(const std::string& text) { return Dictionary::parse(text, "system/schemes", ""); }

std::string messageFor(const std::string& text)
{
    return messageOf([&] { static_cast<void>(parse(text)); });
}

std::vector<std::string> texts(const Entry& entry)
{
    std::vector<std::string> result;
    for (const Token& token : entry.tokens()) { result.push_back(token.text); }
    return result;
}

TEST(Grammar, ReadsValuesOfEveryKind)
{
    const Dictionary dictionary = parse("FoamFile { version 2.0; class dictionary; }\n"
                                        "number 1.5; word gaussian; text \"a b\"; flag yes;\n"
                                        "vector (1 0 -2); list ((1 2) (3 4)); dimensions [0 1 -1 0 0 0 0];\n"
                                        "empty; kernel { order 10; }");
    EXPECT_EQ(dictionary.number("number"), 1.5);
    EXPECT_EQ(dictionary.word("word").text, "gaussian");
    EXPECT_EQ(dictionary.text("text"), "a b");
    EXPECT_TRUE(dictionary.flag("flag"));
    EXPECT_THAT(dictionary.vector("vector"), ElementsAre(1, 0, -2));
    EXPECT_THAT(texts(*dictionary.find("list")), ElementsAre("(", "(", "1", "2", ")", "(", "3", "4", ")", ")"));
    EXPECT_THAT(dictionary.dimensions("dimensions"), ElementsAre(0, 1, -1, 0, 0, 0, 0));
    EXPECT_TRUE(dictionary.find("empty")->tokens().empty());
    EXPECT_EQ(dictionary.dictionary("kernel").integer("order"), 10);
    EXPECT_TRUE(dictionary.hasDictionary("FoamFile"));
}

TEST(Grammar, SkipsComments)
{
    const Dictionary dictionary = parse("// a 1;\n/* b 2;\n * c 3; */ d /* of */ 4; // e\nf 5//6\n;");
    EXPECT_EQ(dictionary.entries().size(), 2U);
    EXPECT_EQ(dictionary.number("d"), 4);
    EXPECT_EQ(dictionary.number("f"), 5);
}

TEST(Grammar, ReadsNumbersAsOpenFoamDoes)
{
    const Dictionary dictionary = parse("a 0.01; b 1e-3; c -.5; d +2; e 1.; f -1E+2; g 007;");
    EXPECT_EQ(dictionary.number("a"), 0.01);
    EXPECT_EQ(dictionary.number("b"), 1e-3);
    EXPECT_EQ(dictionary.number("c"), -0.5);
    EXPECT_EQ(dictionary.number("d"), 2);
    EXPECT_EQ(dictionary.number("e"), 1);
    EXPECT_EQ(dictionary.number("f"), -100);
    EXPECT_EQ(dictionary.number("g"), 7);
}

TEST(Grammar, KeepsWordsWithPunctuation)
{
    const Dictionary dictionary = parse("div(U) Gauss; div(phi,U) x; U.x a/b; 2D a-b; list (U p); nested (div(U) p);");
    EXPECT_EQ(dictionary.word("div(U)").text, "Gauss");
    EXPECT_EQ(dictionary.word("div(phi,U)").text, "x");
    EXPECT_EQ(dictionary.word("U.x").text, "a/b");
    EXPECT_EQ(dictionary.word("2D").text, "a-b");
    EXPECT_THAT(texts(*dictionary.find("list")), ElementsAre("(", "U", "p", ")"));
    EXPECT_THAT(texts(*dictionary.find("nested")), ElementsAre("(", "div(U)", "p", ")"));
}

TEST(Grammar, UnescapesStrings)
{
    const Dictionary dictionary = parse("a \"say \\\"x\\\"\"; b \"one\\\ntwo\"; c \"a\\.b\"; d \"{;}//\";");
    EXPECT_EQ(dictionary.text("a"), "say \"x\"");
    EXPECT_EQ(dictionary.text("b"), "one\ntwo");
    EXPECT_EQ(dictionary.text("c"), "a\\.b");
    EXPECT_EQ(dictionary.text("d"), "{;}//");
}

TEST(Grammar, TheLastOfTwoWinsAndDictionariesMerge)
{
    const Dictionary dictionary = parse("a 1; k { x 1; y 1; } a 2; k { y 2; } b 1; b { c 1; }");
    EXPECT_EQ(dictionary.number("a"), 2);
    EXPECT_EQ(dictionary.dictionary("k").number("x"), 1);
    EXPECT_EQ(dictionary.dictionary("k").number("y"), 2);
    EXPECT_TRUE(dictionary.hasDictionary("b"));
}

TEST(Grammar, ExactKeysComeBeforePatternsAndLaterPatternsBeforeEarlier)
{
    const Dictionary dictionary = parse("\"x.*\" 1; \"x(Min|Max)\" 2; xMax 3; \".*Mid\" 4; \"a|b\" 5;");
    EXPECT_EQ(dictionary.number("xMax"), 3);
    EXPECT_EQ(dictionary.number("xMin"), 2);
    EXPECT_EQ(dictionary.number("xMid"), 4);
    EXPECT_EQ(dictionary.number("xOther"), 1);
    EXPECT_EQ(dictionary.number("b"), 5);
    EXPECT_FALSE(dictionary.has("ab")); // a pattern matches a whole name
    EXPECT_EQ(dictionary.number("x(Min|Max)"), 2);
}

TEST(Grammar, KnowsFileLineAndScope)
{
    const Dictionary dictionary = parse("a 1;\n\nkernel\n{\n    /* x\n */ order 10;\n    sub { deep 1; }\n}\n");
    const Entry* order = dictionary.dictionary("kernel").find("order");
    EXPECT_EQ(order->origin(), (Origin{"system/schemes", 6, "kernel.order"}));
    EXPECT_EQ(dictionary.dictionary("kernel").origin(), (Origin{"system/schemes", 4, "kernel"}));
    EXPECT_EQ(dictionary.findScoped("kernel.sub.deep")->origin().entry, "kernel.sub.deep");
    EXPECT_EQ(dictionary.findScoped("kernel/sub/deep")->origin().line, 7);
    EXPECT_EQ(dictionary.findScoped("kernel.none"), nullptr);
}

TEST(Grammar, FindsScopedKeysThatHoldDots)
{
    const Dictionary dictionary = parse("a.b { c.d 1; } a { b 2; }");
    EXPECT_NE(dictionary.findScoped("a.b.c.d"), nullptr);
    EXPECT_EQ(dictionary.findScoped("a.b")->tokens().at(0).number, 2); // b inside of a comes first, as in OpenFOAM
}

TEST(Grammar, TakesTextOfOtherMachines)
{
    EXPECT_EQ(parse("\xEF\xBB\xBF"
                    "a 1;\r\nb 2;\r\n")
                  .number("b"),
              2);
}

struct Slip
{
    std::string text;
    std::string message; // behind the file
};

class Message : public testing::TestWithParam<Slip>
{
};

TEST_P(Message, SaysWhereAndWhat) { EXPECT_EQ(messageFor(GetParam().text), "system/schemes" + GetParam().message); }

INSTANTIATE_TEST_SUITE_P(
    Grammar, Message,
    testing::Values(
        Slip{"a 1;\nb 2", ":2: b: has no ';' at its end (line 2)"},
        Slip{"a\n1\n}", ":1: a: has no ';' at its end (line 2)"},
        Slip{"a 1\nkernel { b 2; }", ":1: a: has a '{' in its value\n    is the ';' missing at the end of line 2?"},
        Slip{"a 1;\nkernel {\n b 2;", ":2: opens a '{' that is never closed"},
        Slip{"a 1; }", ":1: has a '}' without its '{'"},
        Slip{"{ a 1; }", ":1: has a '{' without a name in front of it"},
        Slip{"1 a;", ":1: has '1' where a key should be\n    an entry is written: key value;"},
        Slip{"(a);", ":1: has '(' where a key should be\n    an entry is written: key value;"},
        Slip{"a (1 2;", ":1: a: ends before its ')'"}, Slip{"a [1 2;", ":1: a: ends before its ']'"},
        Slip{"a (1 2));", ":1: a: has a ')' too many"}, Slip{"a (1 2];", ":1: a: has a ']' too many"},
        Slip{"a div(U;", ":1: has the word 'div(U' with an open bracket"},
        Slip{"a 1;\n/* b", ":2: opens a comment with '/*' that is never closed"},
        Slip{"a \"b;\nc 1;", ":1: opens a string that does not end on its line\n    close it with a double quote"},
        Slip{"a 'b';", ":1: has a single quote\n    write strings in double quotes"},
        Slip{"a \x01;", ":1: has the unprintable character 0x01"},
        Slip{"a 1e999;", ":1: has the number 1e999, which is too large or too small to hold"},
        Slip{"\"x(\" 1;", ":1: x(: is not a regular expression: Unmatched ( or \\("},
        Slip{"\"\" 1;", ":1: is an empty name"}, Slip{"\"(a)\\1\" 1;", ":1: (a)\\1: is too complicated a pattern"},
        Slip{"\"a++++++++++++++++++++++++\" 1;", ":1: a++++++++++++++++++++++++: is too complicated a pattern"},
        Slip{"\"((a{99}){99}){99}\" 1;", ":1: ((a{99}){99}){99}: is too complicated a pattern"}));

TEST(Grammar, LimitsWhatHostileTextMayCost)
{
    std::string deep;
    for (int i = 0; i < 100000; ++i) { deep += "a {"; }
    EXPECT_THAT(messageFor(deep), HasSubstr("nests its dictionaries too deeply"));
    std::string many;
    for (int i = 0; i < 10001; ++i) { many.append("a").append(std::to_string(i)).append(";"); }
    EXPECT_EQ(messageFor(many), "system/schemes:1: a10000: is one of more than 10000 entries");
    EXPECT_EQ(messageFor(std::string(4000001, ' ')), "system/schemes: is larger than 4000000 bytes");
    EXPECT_EQ(messageFor("a " + std::string(1500000, '(') + ";"), "system/schemes:1: holds more than 1000000 words");
}

TEST(Grammar, ReadsFilesAndSaysWhyNot)
{
    const auto read = [](const char* file) { return messageOf([&] { Dictionary::read(file, "system/x"); }); };
    EXPECT_EQ(read("/nonexistent/x"), "system/x: cannot be read: No such file or directory");
    EXPECT_EQ(read("/"), "system/x: cannot be read: it is not a file");
    EXPECT_EQ(read("/dev/zero"), "system/x: cannot be read: it is not a file");
}

} // namespace
} // namespace isph
