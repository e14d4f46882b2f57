#include "dictionary/TextEditor.hpp"
#include "dictionary/writeDictionary.hpp"
#include "support/messageOf.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

TEST(WriteDictionary, HasOpenFoamsLayout)
{
    const Dictionary dictionary = Dictionary::parse("FoamFile { object a; } a 1; long_keyword_of_many_letters ( 1 2 ); "
                                                    "k { b \"c d\"; l { } } \"x.*\" [0 1 -1 0 0 0 0]; e;",
                                                    "a", "");
    EXPECT_EQ(dictionaryText(dictionary), "a               1;\n"
                                          "long_keyword_of_many_letters (1 2);\n"
                                          "k\n{\n    b               \"c d\";\n    l\n    {\n    }\n}\n"
                                          "\"x.*\"           [0 1 -1 0 0 0 0];\n"
                                          "e;\n");
    EXPECT_EQ(valueText(*dictionary.find("long_keyword_of_many_letters")), "(1 2)");
    EXPECT_EQ(foamHeader("dictionary", "controlDict"),
              "FoamFile\n{\n    version         2.0;\n    format          ascii;\n    class           dictionary;\n"
              "    object          controlDict;\n}\n\n");
}

TEST(WriteDictionary, KeepsNumbersAsWrittenAndAllBitsOfOthers)
{
    Dictionary dictionary = Dictionary::parse("a 1.50; b #eval{ 0.1 + 0.2 };", "a", "");
    dictionary.set(Entry("c", false, {}, {Token{Token::Kind::number, "", 1e-7 / 3}}));
    EXPECT_EQ(dictionaryText(dictionary),
              "a               1.50;\nb               0.30000000000000004;\nc               3.3333333333333334e-08;\n");
}

TEST(WriteDictionary, RefusesWhatCannotBeReadBack)
{
    const auto message = [](const Entry& entry)
    {
        Dictionary dictionary;
        dictionary.set(entry);
        return messageOf([&] { static_cast<void>(dictionaryText(dictionary)); });
    };
    const Origin origin{"a", 3, "k"};
    EXPECT_EQ(message(Entry("a b", false, origin, std::vector<Token>())),
              "a:3: k: holds 'a b', which no dictionary can hold");
    EXPECT_EQ(message(Entry("k", false, origin, {Token{Token::Kind::word, "1"}})),
              "a:3: k: holds '1', which no dictionary can hold");
    EXPECT_EQ(message(Entry("k", false, origin, {Token{Token::Kind::string, "a\\"}})),
              "a:3: k: holds 'a\\', which no dictionary can hold");
    EXPECT_EQ(message(Entry("k", false, origin, {Token{Token::Kind::number, "", INFINITY}})),
              "a:3: k: holds a number that is not finite");
}

TextEditor editorOf(const std::string& text) { return TextEditor(text, "system/a", ""); }

std::string afterSet(const std::string& text, const std::string& key, const std::string& value)
{
    TextEditor editor = editorOf(text);
    editor.set(key, value);
    return editor.text();
}

std::string afterRemove(const std::string& text, const std::string& key)
{
    TextEditor editor = editorOf(text);
    editor.remove(key);
    return editor.text();
}

TEST(TextEditor, ChangesAValueAndNothingElse)
{
    EXPECT_EQ(afterSet("// end\na  1 ; // s\nb 2;", "a", "3"), "// end\na  3 ; // s\nb 2;");
    EXPECT_EQ(afterSet("a (1 2\n  3);", "a", "(4 5 6)"), "a (4 5 6);");
    EXPECT_EQ(afterSet("a;", "a", "1"), "a 1;");
    EXPECT_EQ(afterSet("a #eval{ 1 + 1 };", "a", "#eval{ 2*pi() };"), "a #eval{ 2*pi() };");
    EXPECT_EQ(afterSet("a { b 1; /* c */ }", "a.b", "2"), "a { b 2; /* c */ }");
    EXPECT_EQ(afterSet("a { b 1; }", "a/b", "2"), "a { b 2; }");
    EXPECT_EQ(afterSet("a.b 1; a { b 2; }", "a.b", "3"), "a.b 1; a { b 3; }");
    EXPECT_EQ(afterSet("\"x.*\" { type wall; }", "\"x.*\".type", "slip"), "\"x.*\" { type slip; }");
    EXPECT_EQ(afterSet("a.b { c 1; d.e { f 2; } }", "a.b.d.e.f", "3"), "a.b { c 1; d.e { f 3; } }");
    EXPECT_EQ(afterSet("a.b { c 1; }", "a.b.d", "3"), "a.b { c 1; d 3; }");
    EXPECT_EQ(afterSet("a { b 1; }", "a", "2"), "a 2;");
    EXPECT_EQ(afterSet("a 2; c 3;", "a", "{ b 1; }"), "a { b 1; } c 3;");
}

TEST(TextEditor, ChangesTheEntryThatCounts)
{
    EXPECT_EQ(afterSet("a 1;\na 2;\n", "a", "3"), "a 1;\na 3;\n");
    EXPECT_EQ(afterSet("#if yes\na 1;\n#else\na 2;\n#endif\n", "a", "3"), "#if yes\na 3;\n#else\na 2;\n#endif\n");
    EXPECT_EQ(afterSet("k { a 1; }\nk { b 2; }\n", "k.a", "3"), "k { a 3; }\nk { b 2; }\n");
}

TEST(TextEditor, PassesOverBranchesThatDoNotParse)
{
    EXPECT_EQ(afterSet("a 1;\n#if no\nb (1;\n#remove (c\n#endif\n", "a", "3"),
              "a 3;\n#if no\nb (1;\n#remove (c\n#endif\n");
}

TEST(TextEditor, AddsBehindAMacroThatWouldWin)
{
    EXPECT_EQ(afterSet("l { a 1; }\nk { a 5; $l; }\n", "k.a", "3"), "l { a 1; }\nk { a 5; $l; a 3; }\n");
}

TEST(TextEditor, AddsWhereAUserWould)
{
    EXPECT_EQ(afterSet("a 1;\n\n// *** //\n", "b", "2"), "a 1;\nb               2;\n\n// *** //\n");
    EXPECT_EQ(afterSet("a 1;", "b", "2"), "a 1;\nb               2;\n");
    EXPECT_EQ(afterSet("", "b", "2"), "\nb               2;\n");
    EXPECT_EQ(afterSet("k\n{\n    a 1;\n}\n", "k.b", "2"), "k\n{\n    a 1;\n    b               2;\n}\n");
    EXPECT_EQ(afterSet("k { a 1; }\n", "k.b", "2"), "k { a 1; b 2; }\n");
    EXPECT_EQ(afterSet("k {}\n", "k.b", "2"), "k { b 2; }\n");
    EXPECT_EQ(afterSet("l { a 1; } k $l;\n", "k.b", "2"), "l { a 1; } k $l;\nk { b 2; }\n");
    EXPECT_EQ(afterSet("k { a 1; }\n", "\"x.*\"", "{ type wall; }"), "k { a 1; }\n\"x.*\" { type wall; }\n");
    EXPECT_EQ(afterSet("a 1; /* a\ncomment */\n", "b", "2"), "a 1;\nb               2; /* a\ncomment */\n");
}

TEST(TextEditor, RemovesAnEntryWithItsLine)
{
    EXPECT_EQ(afterRemove("a 1;\nb 2;   // of b\nc 3;\n", "b"), "a 1;\nc 3;\n");
    EXPECT_EQ(afterRemove("a 1; b 2; c 3;", "b"), "a 1; c 3;");
    EXPECT_EQ(afterRemove("k { a 1; b 2; }", "k.b"), "k { a 1; }");
    EXPECT_EQ(afterRemove("k\n{\n    a 1;\n}\nb 1;\n", "k"), "b 1;\n");
    EXPECT_EQ(afterRemove("a 1;\nb 2;\na 3;\n", "a"), "b 2;\n");
}

std::string editMessage(const std::string& text, void (*edit)(TextEditor&))
{
    TextEditor editor = editorOf(text);
    const std::string message = messageOf([&] { edit(editor); });
    EXPECT_EQ(editor.text(), text) << "a refused change was made";
    return message;
}

TEST(TextEditor, RefusesWhatWouldNotParse)
{
    EXPECT_EQ(editMessage("a 1;", [](TextEditor& e) { e.set("a", "1; b 2"); }),
              "system/a: a: cannot be set to 1; b 2\n    give one value");
    EXPECT_EQ(editMessage("a 1;", [](TextEditor& e) { e.set("a", "{ b 1;"); }),
              "system/a: a: cannot be set to { b 1\n    close its '{'");
    EXPECT_EQ(editMessage("a 1;", [](TextEditor& e) { e.set("a", "{ b 1; } c 2"); }),
              "system/a: a: cannot be set to more than one value\n    quote it as a whole");
    EXPECT_EQ(editMessage("a 1;", [](TextEditor& e) { e.set("a", "}"); }),
              "system/a: a: cannot be set to }\n    give one value");
    EXPECT_EQ(editMessage("a 1;", [](TextEditor& e) { e.set("a", "(1 2"); }), "system/a:1: a: ends before its ')'");
    EXPECT_EQ(editMessage("a 1;", [](TextEditor& e) { e.set("a", "$none"); }),
              "system/a:1: uses $none, which is neither an entry so far nor in the environment");
    EXPECT_EQ(editMessage("a 1;", [](TextEditor& e) { e.set("b c", "1"); }),
              "system/a: b c: was set but is not seen\n    look for #inputMode, #remove and #if");
    EXPECT_EQ(editMessage("a 1;\n#if no\n#endif", [](TextEditor& e) { e.set("k.b", "1"); }),
              "system/a: k.b: has no dictionary k to be in");
    EXPECT_EQ(editMessage("\"x.*\" { type wall; }", [](TextEditor& e) { e.set("xMin.type", "slip"); }),
              "system/a:1: xMin.type: is given by the pattern \"x.*\"\n"
              "    name the pattern, in quotes, or add the dictionary as a whole");
}

TEST(TextEditor, RefusesToAddTwiceAndToRemoveWhatIsNotThere)
{
    EXPECT_EQ(editMessage("\na 1;", [](TextEditor& e) { e.add("a", "1"); }),
              "system/a:2: a: exists already\n    use -set to change it");
    EXPECT_EQ(editMessage("kernel\n{\n    order 1;\n}", [](TextEditor& e) { e.remove("kernel.odrer"); }),
              "system/a:2: kernel.odrer: does not exist\n    did you mean kernel.order?");
    EXPECT_EQ(editMessage("l { a 1; } k $l;", [](TextEditor& e) { e.remove("k.a"); }),
              "system/a: k.a: comes from a macro, a pattern or an included file\n    remove it there");
}

} // namespace
} // namespace isph
