#include "dictionary/Dictionary.hpp"
#include "dictionary/writeDictionary.hpp"
#include "support/messageOf.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

namespace isph
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

Dictionary parse(const std::string& text) { return Dictionary::parse(text, "system/a", ""); }

std::string messageFor(const std::string& text)
{
    return messageOf([&] { static_cast<void>(parse(text)); });
}

TEST(Macro, StandsForTheValue)
{
    const Dictionary dictionary =
        parse("a 1; v (1 2 3); b $a; c ($a ${a}$a); w $v; s \"x y\"; t $s; n [0 2 -1 0 0 0 0] $a;");
    EXPECT_EQ(dictionary.number("b"), 1);
    EXPECT_THAT(dictionary.numbers("c"), ElementsAre(1, 1, 1));
    EXPECT_THAT(dictionary.vector("w"), ElementsAre(1, 2, 3));
    EXPECT_EQ(dictionary.text("t"), "x y");
    EXPECT_EQ(dictionary.dimensionedNumber("n", {0, 2, -1, 0, 0, 0, 0}), 1);
}

TEST(Macro, LooksOutwardsFromTheInnermostDictionary)
{
    const Dictionary dictionary = parse("a 1; k { a 2; x $a; l { y $a; } }");
    EXPECT_EQ(dictionary.dictionary("k").number("x"), 2);
    EXPECT_EQ(dictionary.findScoped("k.l.y")->tokens()[0].number, 2);
    EXPECT_THAT(messageFor("k { z $b; } b 3;"), HasSubstr("uses $b")); // what comes later is not known yet
}

TEST(Macro, FollowsScopes)
{
    const Dictionary dictionary =
        parse("a 1; o { p { q 4; } } k { a 2; l { a 3; x $:a; y $..a; z $.a; t $...a; s $:o.p.q; r ${o.p.q}; } }");
    const Dictionary& inner = dictionary.dictionary("k").dictionary("l");
    EXPECT_EQ(inner.number("x"), 1);
    EXPECT_EQ(inner.number("y"), 2);
    EXPECT_EQ(inner.number("z"), 3);
    EXPECT_EQ(inner.number("t"), 1);
    EXPECT_EQ(inner.number("s"), 4);
    EXPECT_EQ(inner.number("r"), 4);
}

TEST(Macro, FindsKeysThatHoldDotsAndPatterns)
{
    const Dictionary dictionary = parse("a.b 1; x $a.b; c.d { e.f 2; } y $c.d.e.f; \"z.*\" 3; z $zMin;");
    EXPECT_EQ(dictionary.number("x"), 1);
    EXPECT_EQ(dictionary.number("y"), 2);
    EXPECT_EQ(dictionary.number("z"), 3);
}

TEST(Macro, MergesDictionaries)
{
    const Dictionary dictionary = parse("k { a 1; b 2; } l { $k; b 3; } m $k; n { b 4; $k }");
    EXPECT_EQ(dictionary.dictionary("l").number("a"), 1);
    EXPECT_EQ(dictionary.dictionary("l").number("b"), 3);
    EXPECT_EQ(dictionary.dictionary("m").number("b"), 2);
    EXPECT_EQ(dictionary.dictionary("n").number("b"), 2);
    EXPECT_EQ(dictionary.dictionary("m").origin().entry, "m");
}

TEST(Macro, SpellsKeys)
{
    const Dictionary dictionary = parse("name lid; $name { type wall; } ${name} { x 1; }");
    EXPECT_EQ(dictionary.dictionary("lid").word("type").text, "wall");
    EXPECT_EQ(dictionary.dictionary("lid").number("x"), 1);
}

TEST(Macro, MarksWhatItUsed)
{
    const Dictionary dictionary = parse("a 1; b 2; k { c 3; } x $a; y $k.c; z $x;");
    EXPECT_TRUE(dictionary.find("a")->usedByMacro);
    EXPECT_FALSE(dictionary.find("b")->usedByMacro);
    EXPECT_TRUE(dictionary.find("k")->usedByMacro);
    EXPECT_TRUE(dictionary.findScoped("k.c")->usedByMacro);
    EXPECT_FALSE(dictionary.find("z")->usedByMacro);
}

TEST(Macro, KeepsTheMarkWhenAKeyIsGivenAgain) { EXPECT_TRUE(parse("a 1; b $a; a 2;").find("a")->usedByMacro); }

TEST(Macro, FallsBackToTheEnvironment)
{
    setenv("CONTINUA_TEST_WORD", "some text", 1);
    setenv("CONTINUA_TEST_NUMBER", "2.5", 1);
    const Dictionary dictionary =
        parse("a $CONTINUA_TEST_WORD; b ${CONTINUA_TEST_NUMBER}; c #eval{ 2*$CONTINUA_TEST_NUMBER };");
    EXPECT_EQ(dictionary.text("a"), "some text");
    EXPECT_EQ(dictionary.number("b"), 2.5);
    EXPECT_EQ(dictionary.number("c"), 5);
    EXPECT_EQ(parse("CONTINUA_TEST_NUMBER 1; a $CONTINUA_TEST_NUMBER;").number("a"), 1);
}

TEST(Eval, Calculates)
{
    const Dictionary dictionary = parse(
        "L 2; m -1; a #eval{ $L*pi() }; b #eval \"${L} + 1\"; c #calc \"pow($L, 3)\"; d #eval{ $m^2 };\n"
        "e #eval{ L > 1 ? 10 : 20 }; f ( #eval{ 1 + 1 } 3 ); k { g #eval{ 2*$..L }; h #eval{ sum(n, 1, $L, n) }; }");
    EXPECT_EQ(dictionary.number("a"), 2 * std::numbers::pi);
    EXPECT_EQ(dictionary.number("b"), 3);
    EXPECT_EQ(dictionary.number("c"), 8);
    EXPECT_EQ(dictionary.number("d"), 1); // a macro stands for a value, not for its text
    EXPECT_EQ(dictionary.number("e"), 10);
    EXPECT_THAT(dictionary.numbers("f"), ElementsAre(2, 3));
    EXPECT_EQ(dictionary.dictionary("k").number("g"), 4);
    EXPECT_EQ(dictionary.dictionary("k").number("h"), 3);
}

TEST(Eval, KeepsEveryBit)
{
    EXPECT_EQ(parse("a #eval{ 1/3 };").number("a"), 1.0 / 3);
    EXPECT_EQ(parse("a 0.1; b #eval{ $a + 0.2 };").number("b"), 0.1 + 0.2);
}

TEST(Eval, MarksWhatItUsed)
{
    const Dictionary dictionary = parse("a 1; b 2; x #eval{ $a + b };");
    EXPECT_TRUE(dictionary.find("a")->usedByMacro);
    EXPECT_TRUE(dictionary.find("b")->usedByMacro);
}

struct Slip
{
    std::string text;
    std::string message;
};

class MacroMessage : public testing::TestWithParam<Slip>
{
};

TEST_P(MacroMessage, SaysWhereAndWhat) { EXPECT_EQ(messageFor(GetParam().text), "system/a" + GetParam().message); }

INSTANTIATE_TEST_SUITE_P(
    Macros, MacroMessage,
    testing::Values(
        Slip{"\na $nope;", ":2: uses $nope, which is neither an entry so far nor in the environment"},
        Slip{"a $a;", ":1: uses $a, which is neither an entry so far nor in the environment"},
        Slip{"$nope;", ":1: has $nope where a key should be, but it is not an entry so far"},
        Slip{"a 1; $a;", ":1: has $a where a key should be, but it is not a dictionary"},
        Slip{"a 1; $a 2;", ":1: has $a where a key should be, but it is 1"},
        Slip{"k { a 1; } b ($k);",
             ":1: uses the dictionary $k as a value\n    only \"key $name;\" and \"$name;\" may name a dictionary"},
        Slip{"k { a 1; } b $k 2;", ":1: b: needs a ';' behind the dictionary"},
        Slip{"k { a $....b; }", ":1: has the macro $....b, which leads out of the dictionary"},
        Slip{"a ${b;\n};", ":1: opens '${' but does not close it on its line"},
        Slip{"a $;", ":1: has a '$' without a name behind it"}));

INSTANTIATE_TEST_SUITE_P(
    Evals, MacroMessage,
    testing::Values(Slip{"\na #eval{ 1 + };", ":2: \" 1 + \" ends too early (character 4)"},
                    Slip{"a #eval{ x };", ":1: has \" x \" in an #eval, which knows no x, y, z, t and noise"},
                    Slip{"a #eval{ 1/0 };", ":1: \" 1/0 \" is infinite"},
                    Slip{"a #eval{ qwerty };", ":1: \" qwerty \" has the unknown name 'qwerty' (character 2)\n"
                                               "    define it in the same dictionary, e.g. qwerty 1;"},
                    Slip{"w word; a #eval{ $w };", ":1: uses $w in a formula, but that is not a number"},
                    Slip{"a #eval;",
                         ":1: has an #eval without a formula\n    write #eval{ 2*pi() } or #eval \"2*pi()\""},
                    Slip{"a #eval{ 1;", ":1: opens a '{' that is never closed"},
                    Slip{"#eval{ 1 };", ":1: has #eval where a key should be\n    write: key #eval{ ... };"}));

TEST(Macro, CannotBlowUp)
{
    // Each line doubles what the line before holds.
    std::string text = "a0 { x 1; y 2; }";
    std::string list = "b0 (1 2 3 4);";
    for (int i = 1; i < 60; ++i)
    {
        text += fmt::format("a{} {{ p $a{}; q $a{}; }}\n", i, i - 1, i - 1);
        list += fmt::format("b{} ($b{} $b{});\n", i, i - 1, i - 1);
    }
    EXPECT_THAT(messageFor(text), HasSubstr("is copied until there are more than 10000 entries"));
    EXPECT_THAT(messageFor(list), HasSubstr("holds more than 1000000 words"));

    std::string deep = "a0 { x 1; }";
    for (int i = 1; i < 100; ++i) { deep += fmt::format("a{} {{ p $a{}; }}\n", i, i - 1); }
    EXPECT_THAT(messageFor(deep), HasSubstr("is copied into too deep a nest of dictionaries"));

    std::string macros = "a 1; b (";
    for (int i = 0; i < 10001; ++i) { macros += "$a "; }
    EXPECT_EQ(messageFor(macros + ");"), "system/a:1: has more than 10000 macros");
}

} // namespace
} // namespace isph
