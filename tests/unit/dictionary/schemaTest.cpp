#include "dictionary/Schema.hpp"
#include "support/messageOf.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

using testing::HasSubstr;

Schema schema()
{
    using T = Key::Type;
    return Schema(
        "system/schemes",
        {
            {.name = "kernel",
             .type = T::dictionary,
             .required = true,
             .keys =
                 {{.name = "type",
                   .type = T::word,
                   .meaning = "the kernel",
                   .required = true,
                   .words = {"gaussian", "quinticSpline", "exact"}},
                  {.name = "order", .type = T::integer, .fallback = "10", .meaning = "even order", .minimum = 2},
                  {.name = "smoothingLength",
                   .type = T::number,
                   .fallback = "1.5",
                   .meaning = "h/dx",
                   .positive = true},
                  {.name = "supportRadius", .type = T::number, .unit = "h", .fallback = "auto", .words = {"auto"}}}},
            {.name = "filter",
             .type = T::dictionary,
             .keys = {{.name = "type", .type = T::word, .fallback = "none", .words = {"none", "cutoff"}},
                      {.name = "fraction", .type = T::number, .fallback = "0.66", .minimum = 0, .maximum = 1}}},
            {.name = "exact", .type = T::dictionary, .keys = {{.name = "U", .type = T::function, .required = true}}},
            {.name = "functions",
             .type = T::dictionary,
             .keys = {{.name = "*",
                       .type = T::dictionary,
                       .keys = {{.name = "type", .type = T::word, .required = true},
                                {.name = "writeInterval", .type = T::number, .fallback = "1"}}}}},
            {.name = "sides", .type = T::dictionary, .fallback = "{ type periodic; }", .keys = {{.name = "type"}}},
            {.name = "renormalise", .type = T::flag, .fallback = "no"},
            {.name = "bodyForce", .type = T::function, .unit = "m/s2", .meaning = "force on the fluid"},
            {.name = "nu", .type = T::dimensioned, .unit = "m2/s", .minimum = 0},
            {.name = "origin", .type = T::vector},
            {.name = "fields", .type = T::list},
            {.name = "title", .type = T::text},
        });
}

Dictionary parse(const std::string& text) { return Dictionary::parse(text, "system/schemes", ""); }

const std::string least = "kernel { type gaussian; }\n";

std::string messageFor(const std::string& text)
{
    return messageOf([&] { static_cast<void>(schema().complete(parse(text))); });
}

TEST(Schema, FillsInDefaults)
{
    const Dictionary completed = schema().complete(parse("FoamFile { version 2.0; }\n" + least));
    EXPECT_EQ(completed.dictionary("kernel").integer("order"), 10);
    EXPECT_EQ(completed.dictionary("kernel").word("supportRadius").text, "auto");
    EXPECT_EQ(completed.dictionary("filter").word("type").text, "none");
    EXPECT_EQ(completed.dictionary("sides").word("type").text, "periodic");
    EXPECT_FALSE(completed.flag("renormalise"));
    EXPECT_TRUE(completed.find("renormalise")->isDefault);
    EXPECT_TRUE(completed.find("filter")->isDefault);
    EXPECT_TRUE(completed.dictionary("kernel").find("order")->isDefault);
    EXPECT_FALSE(completed.dictionary("kernel").find("type")->isDefault);
    EXPECT_EQ(completed.dictionary("kernel").find("order")->origin(), (Origin{"system/schemes", 0, "kernel.order"}));
}

TEST(Schema, LeavesOutWhatOnlyAUserCanGive)
{
    const Dictionary completed = schema().complete(parse(least));
    EXPECT_FALSE(completed.has("exact"));
    EXPECT_FALSE(completed.has("functions"));
    EXPECT_FALSE(completed.has("bodyForce"));
}

TEST(Schema, CompletesEntriesOfAnyName)
{
    const Dictionary completed = schema().complete(parse(least + "functions { a { type x; } \"b.*\" { type y; } }"));
    EXPECT_EQ(completed.dictionary("functions").dictionary("a").number("writeInterval"), 1);
    EXPECT_EQ(completed.dictionary("functions").dictionary("b1").number("writeInterval"), 1);
}

TEST(Schema, LetsAPatternGiveAKey)
{
    const Dictionary completed = schema().complete(parse("kernel { type gaussian; \"o.*\" 4; }"));
    EXPECT_EQ(completed.dictionary("kernel").integer("order"), 4);
    EXPECT_EQ(messageFor("kernel { type gaussian; \"o.*\" x; }"),
              "system/schemes:1: kernel.o.*: is x but must be a whole number");
    EXPECT_EQ(messageFor("kernel { type gaussian; \"q.*\" x; }"),
              "system/schemes:1: kernel.q.*: is not a known entry\n"
              "    known are: type, order, smoothingLength, supportRadius");
}

TEST(Schema, AcceptsConstantsThatMacrosAndExpressionsUse)
{
    EXPECT_NO_THROW(schema().complete(parse("half 5; kernel { type gaussian; order $half; }")));
    EXPECT_NO_THROW(
        schema().complete(parse(least + "U0 2; exact { k 3; U expression (\"U0*sin(k*x)\" \"0\" \"0\"); }")));
    EXPECT_EQ(messageFor(least + "U0 2; exact { U expression (\"U00*sin(x)\" \"0\" \"0\"); }"),
              "system/schemes:2: U0: is not a known entry\n    known are: kernel, filter, exact, functions, sides, "
              "renormalise, bodyForce, nu, origin, fields, title");
}

TEST(Schema, AcceptsValuesOfEveryType)
{
    EXPECT_NO_THROW(schema().complete(
        parse(least + "nu [0 2 -1 0 0 0 0] 0.1; origin (0 0 0); fields (U p); title \"a b\"; bodyForce (1 0 0);")));
    for (const char* force : {"uniform (0 0 0)", "expression (\"x\" \"0\" \"0\")", "table \"f.csv\"", "3"})
    {
        EXPECT_NO_THROW(schema().complete(parse(least + "bodyForce " + force + ";"))) << force;
    }
}

struct Slip
{
    std::string text;
    std::string message;
};

class SchemaMessage : public testing::TestWithParam<Slip>
{
};

TEST_P(SchemaMessage, SaysWhereAndWhat)
{
    EXPECT_EQ(messageFor(GetParam().text), "system/schemes:" + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Keys, SchemaMessage,
    testing::Values(Slip{"", " kernel: is missing\n    write kernel { ... }"},
                    Slip{"\nkernel {}", "2: kernel.type: is missing\n"
                                        "    write type gaussian | quinticSpline | exact; (the kernel)"},
                    Slip{least + "filtre { }", "2: filtre: is not a known entry\n    did you mean 'filter'?"},
                    Slip{least + "filter none;", "2: filter: is none but must be a dictionary { ... }"},
                    Slip{least + "functions { a { } }", "2: functions.a.type: is missing\n    write type <word>;"},
                    Slip{least + "functions { a 1; }", "2: functions.a: is 1 but must be a dictionary { ... }"}));

INSTANTIATE_TEST_SUITE_P(
    Values, SchemaMessage,
    testing::Values(
        Slip{"kernel { type gausian; }",
             "1: kernel.type: 'gausian' is not a known choice\n    known are: gaussian, quinticSpline, exact"},
        Slip{"kernel { type exact; order 1; }",
             "1: kernel.order: is 1 but must be at least 2\n    even order, e.g. order 10;"},
        Slip{"kernel { type exact; smoothingLength -2; }",
             "1: kernel.smoothingLength: is -2 but must be positive\n    h/dx, e.g. smoothingLength 1.5;"},
        Slip{"kernel { type exact; supportRadius all; }",
             "1: kernel.supportRadius: is all but must be a number or auto\n    [h], e.g. supportRadius auto;"},
        Slip{least + "filter { fraction 2; }",
             "2: filter.fraction: is 2 but must be at most 1\n    e.g. fraction 0.66;"},
        Slip{least + "renormalise maybe;", "2: renormalise: is maybe but must be yes or no (on/off, true/false)"},
        Slip{least + "bodyForce strong;",
             "2: bodyForce: is strong but must be uniform, expression or table\n    force on the fluid [m/s2]"},
        Slip{least + "nu [0 2 -1 0 0 0 0];",
             "2: nu: is [0 2 -1 0 0 0 0] but must be a number, perhaps behind dimensions\n    [m2/s]"},
        Slip{least + "nu -1;", "2: nu: is -1 but must be at least 0\n    [m2/s]"},
        Slip{least + "fields U;", "2: fields: is U but must be a list ( ... )"},
        Slip{least + "title 3;", "2: title: is 3 but must be a word or a quoted string"}));

TEST(Schema, CollectsAllSlips)
{
    EXPECT_EQ(messageFor("kernel\n{\n    order 1;\n}\nfiltre { }\nrenormalise 3;\n"),
              "system/schemes:2: kernel.type: is missing\n"
              "    write type gaussian | quinticSpline | exact; (the kernel)\n"
              "system/schemes:3: kernel.order: is 1 but must be at least 2\n"
              "    even order, e.g. order 10;\n"
              "system/schemes:5: filtre: is not a known entry\n"
              "    did you mean 'filter'?\n"
              "system/schemes:6: renormalise: is 3 but must be yes or no (on/off, true/false)");
}

TEST(Schema, AnnotatesItself)
{
    const Schema small(
        "system/demoDict",
        {{.name = "endTime", .type = Key::Type::number, .unit = "s", .meaning = "the end", .required = true},
         {.name = "kernel",
          .type = Key::Type::dictionary,
          .meaning = "how it smooths",
          .keys = {{.name = "type", .type = Key::Type::word, .fallback = "gaussian", .words = {"gaussian", "exact"}}}},
         {.name = "*", .type = Key::Type::dictionary, .keys = {{.name = "a", .fallback = "1"}}}});
    EXPECT_EQ(small.annotated(), "FoamFile\n{\n    version         2.0;\n    format          ascii;\n"
                                 "    class           dictionary;\n    object          demoDict;\n}\n\n"
                                 "// the end [s]; must be given\n"
                                 "// endTime         <number>;\n"
                                 "\n"
                                 "// how it smooths\n"
                                 "kernel\n{\n"
                                 "    // gaussian | exact\n"
                                 "    type            gaussian;\n"
                                 "}\n"
                                 "\n"
                                 "// <name>\n// {\n//     a               1;\n// }\n");
    EXPECT_EQ(parse(small.annotated()).entries().size(), 2U);
}

} // namespace
} // namespace isph
