#include "continuation/continuationSelection.hpp"
#include "support/messageOf.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{
namespace
{

Axis axisOf(int count, bool staggered = false) { return {'y', 0, 1, count, Axis::Ends::bounded, staggered}; }

std::unique_ptr<Continuation> chosen(const std::string& entries, const Axis& axis)
{
    const Schema schema("schemes", {continuationKey()});
    const Dictionary dictionary =
        schema.complete(Dictionary::parse("continuation\n{\n" + entries + "\n}\n", "system/schemes"));
    return selectContinuation(dictionary.dictionary("continuation"), axis);
}

TEST(ContinuationSelection, HasTheDefaultsOfTheContract)
{
    const auto smooth = chosen("", axisOf(101));
    EXPECT_EQ(smooth->newPoints(), 27);
    EXPECT_EQ(smooth->points(), 5);
    const auto polynomial = chosen("type polynomial;", axisOf(101));
    EXPECT_EQ(polynomial->newPoints(), 25);
    EXPECT_EQ(polynomial->points(), 25);
    EXPECT_EQ(chosen("type polynomial;", axisOf(21))->points(), 8);
    const auto gram = chosen("type gram;", axisOf(65));
    EXPECT_EQ(gram->newPoints(), 31);
    const auto mirror = chosen("type mirror;", axisOf(12, true));
    EXPECT_EQ(mirror->newPoints(), 12);
}

TEST(ContinuationSelection, TakesPointsAndFractions)
{
    EXPECT_EQ(chosen("extension 32;", axisOf(101))->newPoints(), 32);
    EXPECT_EQ(chosen("extension 0.5;", axisOf(101))->newPoints(), 50);
    EXPECT_EQ(chosen("extension 1;", axisOf(101))->newPoints(), 100);
    EXPECT_EQ(chosen("type polynomial; points 12; degree 7; smoothness 5;", axisOf(101))->points(), 12);
    EXPECT_EQ(chosen("degree 6;", axisOf(101))->points(), 7);
}

TEST(ContinuationSelection, TakesOnlyBoundedAxes)
{
    const Lattice lattice({Axis{'x', 0, 1, 32, Axis::Ends::periodic, false}, axisOf(33), Axis{'z', 0, 0, 1}}, {});
    const Schema schema("schemes", {continuationKey()});
    const Dictionary dictionary = schema.complete(Dictionary::parse("continuation {}", "system/schemes"));
    const Continuations made = selectContinuations(dictionary.dictionary("continuation"), lattice);
    EXPECT_EQ(made[0], nullptr);
    ASSERT_NE(made[1], nullptr);
    EXPECT_EQ(made[1]->newPoints(), 27);
    EXPECT_EQ(made[2], nullptr);
}

TEST(ContinuationSelection, SaysWhatCannotBe)
{
    const auto says = [](const std::string& entries, const Axis& axis)
    { return messageOf([&] { chosen(entries, axis); }); };
    EXPECT_THAT(says("type smooth;", axisOf(50)), testing::HasSubstr("system/schemes:3: continuation.type"));
    EXPECT_EQ(says("type polynomial;\npoints 60;", axisOf(50)),
              "system/schemes:4: continuation.points: needs 60 points at each end, but axis y has 50\n"
              "    take more lattice points in system/latticeDict, or fewer here");
    EXPECT_EQ(says("type polynomial;\npoints 4;", axisOf(50)),
              "system/schemes:4: continuation.points: 4 points do not determine a polynomial of degree 5\n"
              "    write at least points 6;");
    EXPECT_EQ(says("extension 101;", axisOf(101)),
              "system/schemes:3: continuation.extension: is 101 new points on axis y\n"
              "    write auto, or 1 ... 100 points");
    EXPECT_THAT(says("extension 12.5;", axisOf(50)),
                testing::HasSubstr("is 12.5, neither a whole number of points nor a fraction"));
    EXPECT_THAT(says("extension 0.001;", axisOf(50)), testing::HasSubstr("is 0 new points on axis y"));
    EXPECT_THAT(says("type gram;\nextension 6;", axisOf(50)),
                testing::HasSubstr("system/schemes:4: continuation.extension: an extension of 6 points has no table"));
    EXPECT_THAT(says("degree 9;", axisOf(50)), testing::HasSubstr("system/schemes:3: continuation.degree: degree 9"));
    EXPECT_THAT(says("smoothness 90;", axisOf(50)), testing::HasSubstr("system/schemes:3: continuation.smoothness"));
    EXPECT_THAT(says("degree 4;", axisOf(4)), testing::HasSubstr("continuation.degree: needs 5 points at each end"));
    EXPECT_EQ(says("type smoothGram;", axisOf(50, true)),
              "system/schemes:3: continuation.type: smoothGram needs points on the walls, but axis y is staggered\n"
              "    write type mirror; or arrangement collocated; in system/latticeDict");
}

} // namespace
} // namespace isph
