#include "core/Selection.hpp"

#include <array>
#include <gtest/gtest.h>

using namespace isph;

namespace
{

enum class Shape
{
    gaussian,
    quinticSpline
};

constexpr std::array<Selection<Shape>::Variant, 2> table{{
    {"gaussian", "even order", Shape::gaussian},
    {"quinticSpline", "order 2", Shape::quinticSpline},
}};
static_assert(distinct(table));
constexpr Selection<Shape> shapes("kernel", table);

const std::vector<std::string> known{"gaussian", "quinticSpline", "exact"};

} // namespace

TEST(nearestWord, distances)
{
    EXPECT_EQ(editDistance("", "abc"), 3);
    EXPECT_EQ(editDistance("kernel", "kernel"), 0);
    EXPECT_EQ(editDistance("kenrel", "kernel"), 1); // a swap is one slip
    EXPECT_EQ(editDistance("kernl", "kernel"), 1);
    EXPECT_EQ(editDistance("abcd", "dcba"), 3);
}

TEST(nearestWord, slipsAreFoundOthersNot)
{
    EXPECT_EQ(nearestWord("gausian", known), "gaussian");
    EXPECT_EQ(nearestWord("QuinticSpline", known), "quinticSpline");
    EXPECT_EQ(nearestWord("quintic", known), std::nullopt);
    EXPECT_EQ(nearestWord("wendland", known), std::nullopt);
    EXPECT_EQ(nearestWord("", known), std::nullopt);
}

TEST(nearestWord, listsTheNearestFirst)
{
    EXPECT_EQ(listOfWords("exakt", known), "exact, gaussian, quinticSpline");
    EXPECT_EQ(listOfWords("nothing", known), "gaussian, quinticSpline, exact");
}

TEST(Selection, findsAndNames)
{
    EXPECT_EQ(shapes[(Word{"quinticSpline", {}})], Shape::quinticSpline);
    EXPECT_EQ(shapes.nameOf(Shape::gaussian), "gaussian");
    EXPECT_EQ(shapes.words().back().summary, "order 2");
}

TEST(Selection, unknownWord)
{
    try
    {
        (void)shapes[Word{"gausian", {"system/schemes", 3, "kernel.type"}}];
        FAIL();
    }
    catch (const Error& error)
    {
        EXPECT_STREQ(error.what(), "system/schemes:3: kernel.type: 'gausian' is not a known kernel\n"
                                   "    known are: gaussian, quinticSpline");
    }
}

TEST(Error, tellsWhatIsKnownOfTheOrigin)
{
    EXPECT_EQ(toString(Origin{"system/schemes", 7, "kernel.order"}), "system/schemes:7: kernel.order");
    EXPECT_EQ(toString(Origin{"", 0, "U"}), "U");
    EXPECT_EQ(toString(Origin{}), "");
    EXPECT_STREQ(Error(Fault::input, "is wrong").what(), "is wrong");
}
