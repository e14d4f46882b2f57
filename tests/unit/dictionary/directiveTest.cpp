#include "dictionary/Dictionary.hpp"
#include "support/messageOf.hpp"
#include "support/TemporaryFolder.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

using testing::HasSubstr;

Dictionary parse(const std::string& text) { return Dictionary::parse(text, "system/a", ""); }

std::string messageFor(const std::string& text)
{
    return messageOf([&] { static_cast<void>(parse(text)); });
}

TEST(If, ChoosesABranch)
{
    EXPECT_EQ(parse("#if yes\na 1;\n#else\na 2;\n#endif").number("a"), 1);
    EXPECT_EQ(parse("#if off\na 1;\n#else\na 2;\n#endif").number("a"), 2);
    EXPECT_EQ(parse("n 0; #if $n a 1; #else a 2; #endif").number("a"), 2);
    EXPECT_EQ(parse("n 3; #if #eval{ $n > 2 } a 1; #endif").number("a"), 1);
    EXPECT_FALSE(parse("#if no a 1; #endif b 2;").has("a"));
    EXPECT_EQ(parse("k { #if yes a 1; #endif }").dictionary("k").number("a"), 1);
}

TEST(If, Nests)
{
    const std::string text = " #if no a 1; #else a 2; #endif #else #if yes a 3; #else a 4; #endif #endif b 5;";
    EXPECT_EQ(parse("#if yes" + text).number("a"), 2);
    EXPECT_EQ(parse("#if no" + text).number("a"), 3);
    EXPECT_EQ(parse("#if no" + text).number("b"), 5);
}

TEST(IfEq, Compares)
{
    EXPECT_EQ(parse("w x; #ifeq $w x\na 1;\n#else\na 2;\n#endif").number("a"), 1);
    EXPECT_EQ(parse("n 1; #ifeq $n 1.0\na 1;\n#else\na 2;\n#endif").number("a"), 1);
    EXPECT_EQ(parse("n (1 2); m (1 3); #ifeq $n $m\na 1;\n#else\na 2;\n#endif").number("a"), 2);
    EXPECT_EQ(parse("w x; #ifeq \"$w\" \"x\"\na 1;\n#endif").number("a"), 1);
}

TEST(InputMode, SaysWhatASecondEntryDoes)
{
    const std::string first = "a 1; k { x 1; }\n";
    const std::string second = " a 2; k { y 2; } b 3;";
    const Dictionary merged = parse(first + "#inputMode merge" + second);
    EXPECT_EQ(merged.number("a"), 2);
    EXPECT_TRUE(merged.dictionary("k").has("x"));
    const Dictionary overwritten = parse(first + "#inputMode overwrite" + second);
    EXPECT_EQ(overwritten.number("a"), 2);
    EXPECT_FALSE(overwritten.dictionary("k").has("x"));
    const Dictionary kept = parse(first + "#inputMode protect" + second);
    EXPECT_EQ(kept.number("a"), 1);
    EXPECT_FALSE(kept.dictionary("k").has("y"));
    EXPECT_EQ(kept.number("b"), 3);
    EXPECT_EQ(messageFor(first + "#inputMode error" + second),
              "system/a:2: a: is given a second time\n    #inputMode error allows every key once");
    EXPECT_EQ(parse(first + "#inputMode error #inputMode default" + second).number("a"), 2);
}

TEST(Remove, TakesNamesAndPatterns)
{
    const Dictionary dictionary = parse("a 1; b 2; c 3; xMin 4; xMax 5; k { a 1; #remove a }\n"
                                        "#remove a\n#remove (b \"x.*\" none)\n");
    EXPECT_EQ(dictionary.entries().size(), 2U);
    EXPECT_TRUE(dictionary.has("c"));
    EXPECT_TRUE(dictionary.dictionary("k").entries().empty());
}

struct Slip
{
    std::string text;
    std::string message;
};

class DirectiveMessage : public testing::TestWithParam<Slip>
{
};

TEST_P(DirectiveMessage, SaysWhereAndWhat) { EXPECT_EQ(messageFor(GetParam().text), "system/a" + GetParam().message); }

INSTANTIATE_TEST_SUITE_P(
    Directives, DirectiveMessage,
    testing::Values(Slip{"\n#inclde \"x\"", ":2: has the unknown directive #inclde\n"
                                            "    known are: include, includeIfPresent, includeEtc, inputMode, remove, "
                                            "if, ifeq, else, endif, eval, calc"},
                    Slip{"#include \"x\"", ":1: may not #include a file here"},
                    Slip{"#include;", ":1: has an #include without a file\n"
                                      "    write #include \"file\""},
                    Slip{"a #include \"x\";", ":1: a: has #include in its value\n    only #eval may stand there"},
                    Slip{"#", ":1: has a '#' without a directive behind it"},
                    Slip{"#if yes\na 1;", ":1: has an #if without its #endif"},
                    Slip{"\n#if no\na 1;", ":2: has an #if without its #endif"},
                    Slip{"k { #if yes } #endif", ":1: has an #if without its #endif"},
                    Slip{"#else", ":1: has an #else without its #if"},
                    Slip{"a 1; #endif", ":1: has an #endif without its #if"},
                    Slip{"#if maybe a 1; #endif", ":1: has an #if whose condition is neither yes, no nor a number"},
                    Slip{"#if ; a 1; #endif", ":1: has an #if without a condition"},
                    Slip{"#ifeq a { #endif", ":1: has an #ifeq without a condition"},
                    Slip{"#inputMode often", ":1: has the unknown #inputMode 'often'\n"
                                             "    known are: merge, overwrite, protect, warn, error, default"},
                    Slip{"#remove;",
                         ":1: has a #remove without a name\n    write #remove name or #remove (name1 \"name.*\")"},
                    Slip{"#remove (a b;", ":1: has a #remove whose list is not closed"},
                    Slip{"#remove \"(\"", ":1: #remove \"(\" is not a regular expression: Unmatched ( or \\("}));

class Include : public testing::Test
{
protected:
    Dictionary read(const std::string& text) const
    {
        return Dictionary::read(folder.write("system/a", text), "system/a");
    }
    std::string message(const std::string& text) const
    {
        return messageOf([&] { static_cast<void>(read(text)); });
    }
    TemporaryFolder folder;
};

TEST_F(Include, ReadsAFileBesideTheIncludingOne)
{
    folder.write("system/more/b", "FoamFile { object b; }\nb $a;\n#include \"c\"\n");
    folder.write("system/more/c", "\nc 3;");
    const Dictionary dictionary = read("FoamFile { object a; }\na 1; k {\n#include \"more/b\"\n}");
    const Dictionary& inner = dictionary.dictionary("k");
    EXPECT_EQ(inner.number("b"), 1);
    EXPECT_EQ(inner.find("c")->origin(), (Origin{"system/more/c", 2, "k.c"}));
    EXPECT_FALSE(inner.has("FoamFile"));
    EXPECT_EQ(dictionary.dictionary("FoamFile").word("object").text, "a");
}

TEST_F(Include, ShowsPathsRelativeToTheCase)
{
    folder.write("common", "a nan nan");
    EXPECT_EQ(message("#include \"../common\""), "common:1: a: has no ';' at its end (line 1)");
}

TEST_F(Include, ExpandsNames)
{
    folder.write("system/b2", "b 2;");
    setenv("CONTINUA_TEST_FOLDER", folder.path().c_str(), 1);
    EXPECT_EQ(read("which 2;\n#include \"b$which\"").number("b"), 2);
    EXPECT_EQ(read("#include \"${CONTINUA_TEST_FOLDER}/system/b2\"").number("b"), 2);
}

TEST_F(Include, KnowsTheFoldersOfTheCase)
{
    folder.write("constant/c", "c $d;\n#include \"<case>/e\"");
    folder.write("system/d", "d 4;");
    folder.write("e", "\ne 5;");
    const Dictionary dictionary =
        read("#include \"<system>/d\"\n#include \"<constant>/c\"\n#include \"<etc>/solutions/gresho\"");
    EXPECT_EQ(dictionary.number("c"), 4);
    EXPECT_EQ(dictionary.find("e")->origin(), (Origin{"e", 2, "e"}));
    EXPECT_EQ(dictionary.number("R"), 0.2);
    EXPECT_EQ(message("#include \"<constant>/none\""), "system/a:1: includes constant/none, which does not exist");
}

TEST_F(Include, IfPresentLeavesOutWhatIsNotThere)
{
    folder.write("system/b", "b 2;");
    const Dictionary dictionary = read("#includeIfPresent \"none\"\n#includeIfPresent \"b\"\na 1;");
    EXPECT_EQ(dictionary.number("b"), 2);
    EXPECT_EQ(dictionary.number("a"), 1);
}

TEST_F(Include, EtcIsTheSuites)
{
    folder.write("etc/solutions/x", "x 7;");
    setenv("CONTINUA_ETC", (folder.path() / "etc").c_str(), 1);
    EXPECT_EQ(read("#includeEtc \"solutions/x\"").number("x"), 7);
    EXPECT_EQ(read("#includeEtc \"solutions/x\"").find("x")->origin().file, "etc/solutions/x");
    unsetenv("CONTINUA_ETC");
    EXPECT_TRUE(read("#includeEtc \"solutions/taylorGreen2D\"").hasDictionary("exact")); // of the source tree
    EXPECT_EQ(message("\n#includeEtc \"solutions/none\""),
              "system/a:2: includes etc/solutions/none, which does not exist\n"
              "    etc is looked for beside the programs and in $CONTINUA_ETC");
}

TEST_F(Include, RefusesCyclesAndNamesTheChain)
{
    folder.write("system/b", "#include \"c\"");
    folder.write("system/c", "\n#include \"../system/a\"");
    EXPECT_EQ(message("#include \"b\""), "system/c:2: includes itself: system/a -> system/b -> system/c -> system/a");
    EXPECT_EQ(message("#include \"a\""), "system/a:1: includes itself: system/a -> system/a");
}

TEST_F(Include, RefusesTooMany)
{
    folder.write("system/leaf", "");
    std::string many;
    for (int i = 0; i < 1001; ++i) { many += "#include \"leaf\"\n"; }
    EXPECT_EQ(message(many), "system/a:1001: includes too many files");
    for (int i = 0; i < 40; ++i) { folder.write(fmt::format("system/n{}", i), fmt::format("#include \"n{}\"", i + 1)); }
    EXPECT_THAT(message("#include \"n0\""), HasSubstr("includes too many files"));
}

TEST_F(Include, SaysWhatIsMissingAndWhere)
{
    EXPECT_EQ(message("a 1;\n#include \"none\""), "system/a:2: includes system/none, which does not exist");
    EXPECT_EQ(message("#include \".\""), "system/a:1: cannot be read: it is not a file");
    folder.write("system/b", "a 1;\n}");
    EXPECT_EQ(message("#include \"b\""), "system/b:2: has a '}' without its '{'");
    folder.write("system/b", "#if yes");
    EXPECT_EQ(message("#include \"b\"\n#endif"), "system/b:1: has an #if without its #endif");
}

} // namespace
} // namespace isph
