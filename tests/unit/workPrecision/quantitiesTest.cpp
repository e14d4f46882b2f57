#include "quantities.hpp"
#include "support/messageOf.hpp"
#include "support/TemporaryFolder.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isph
{

using testing::HasSubstr;

namespace
{

Quantity reducedBy(Quantity::Reduction reduction)
{
    Quantity quantity;
    quantity.reduction = reduction;
    return quantity;
}

const std::vector<double> times{0, 1, 2, 3, 4};
const std::vector<double> hill{2, 5, 8, 9, 8};

/// What a run of isphFoam leaves behind, as far as quantities look at it.
void writeResults(const TemporaryFolder& folder)
{
    folder.write("run/postProcessing/report.json",
                 R"({"steps": 200, "seconds": {"poisson": 0.5}, "errors": {"U": {"relL2": 1e-3}}})");
    folder.write("run/postProcessing/errors/0/errors.csv", "time [s],step,relL2(U)\n0,0,0\n0.5,100,2e-3\n1,200,1e-3\n");
    folder.write("run/postProcessing/sampleLines/0.5/mid.csv", "distance [m],y [m],U.x [m/s]\n0,0,9\n1,1,9\n");
    folder.write("run/postProcessing/sampleLines/1/mid.csv", "distance [m],y [m],U.x [m/s]\n0,1,4\n1,0,0\n");
    folder.write("validation/mid.csv", "# a reference\ny,u\n0,0\n0.25,1.5\n0.5,2\n1,4\n2,50\n");
}

Quantity of(Quantity::Source source, const std::string& from, const std::string& column = "")
{
    Quantity quantity;
    quantity.source = source;
    quantity.from = from;
    quantity.column = column;
    quantity.origin = {"system/workPrecisionDict", 7, "error"};
    return quantity;
}

} // namespace

TEST(Reduce, TakesWhatIsAsked)
{
    using enum Quantity::Reduction;
    EXPECT_EQ(reduce(reducedBy(last), times, hill), 8);
    EXPECT_EQ(reduce(reducedBy(first), times, hill), 2);
    EXPECT_EQ(reduce(reducedBy(max), times, hill), 9);
    EXPECT_EQ(reduce(reducedBy(min), times, hill), 2);
}

TEST(Reduce, FindsTheVertexOfAParabola)
{
    // 10 - (t - 2.8)^2 on unequal steps
    const std::vector<double> t{0, 1, 2.5, 3, 4};
    std::vector<double> y;
    for (const double at : t) { y.push_back(10 - std::pow(at - 2.8, 2)); }
    EXPECT_NEAR(reduce(reducedBy(Quantity::Reduction::peak), t, y), 10, 1e-13);
}

TEST(Reduce, HasNoPeakWithoutAMaximum)
{
    EXPECT_TRUE(std::isnan(reduce(reducedBy(Quantity::Reduction::peak), times, {1, 2, 3, 4, 5})));
}

TEST(Reduce, LooksAtRowsWithinARange)
{
    Quantity quantity = reducedBy(Quantity::Reduction::max);
    quantity.end = 2;
    EXPECT_EQ(reduce(quantity, times, hill), 8);
    quantity.begin = 10;
    quantity.end = 20;
    EXPECT_TRUE(std::isnan(reduce(quantity, times, hill)));
}

TEST(Reduce, InterpolatesBetweenRows)
{
    Quantity quantity;
    quantity.at = 1.5;
    EXPECT_DOUBLE_EQ(reduce(quantity, times, hill), 6.5);
    quantity.at = 4;
    EXPECT_DOUBLE_EQ(reduce(quantity, times, hill), 8);
    quantity.overFirst = true;
    EXPECT_DOUBLE_EQ(reduce(quantity, times, hill), 4);
    quantity.at = 4.1;
    EXPECT_TRUE(std::isnan(reduce(quantity, times, hill)));
}

TEST(Deviation, IsTakenAtThePointsOfTheReferenceThatTheProfileReaches)
{
    EXPECT_DOUBLE_EQ(deviation(Quantity::Norm::max, {0, 1}, {0, 4}, {0, 0.25, 1, 7}, {0.5, 3, 4, 90}), 2);
    EXPECT_DOUBLE_EQ(deviation(Quantity::Norm::rms, {0, 1}, {0, 4}, {0, 1}, {3, 8}), std::sqrt(12.5));
    EXPECT_TRUE(std::isnan(deviation(Quantity::Norm::max, {0, 1}, {0, 4}, {2, 3}, {0, 0})));
    EXPECT_TRUE(std::isnan(deviation(Quantity::Norm::max, {0.5}, {4}, {0.5}, {4}))) << "nothing to interpolate";
}

TEST(Evaluate, ReadsReportsFunctionsLinesAndCommands)
{
    const TemporaryFolder folder;
    writeResults(folder);
    const auto value = [&](const Quantity& quantity) { return evaluate(quantity, folder.path(), folder / "run"); };

    EXPECT_EQ(value(of(Quantity::Source::report, "errors.U.relL2")), 1e-3);
    EXPECT_EQ(value(of(Quantity::Source::function, "errors", "relL2(U)")), 1e-3);
    EXPECT_EQ(value(of(Quantity::Source::command, "echo so it is: 2.5e-1; echo ignored >&2")), 0.25);

    Quantity poisson = of(Quantity::Source::report, "seconds.poisson");
    poisson.per = "steps";
    EXPECT_DOUBLE_EQ(value(poisson), 0.0025);

    Quantity peak = of(Quantity::Source::function, "errors", "relL2(U)");
    peak.reduction = Quantity::Reduction::max;
    peak.reference = 4e-3;
    EXPECT_DOUBLE_EQ(value(peak), 0.5);

    // The last time counts, and a profile may run backwards.
    Quantity line = of(Quantity::Source::line, "mid", "U.x");
    line.abscissa = "y";
    line.profile = {"validation/mid.csv", "y", "u"};
    EXPECT_DOUBLE_EQ(value(line), 0.5);

    // A line may also be reduced to a number.
    line.profile.reset();
    line.reduction = Quantity::Reduction::max;
    line.reference = 5;
    EXPECT_DOUBLE_EQ(value(line), 0.2);
}

TEST(Evaluate, TakesTheLargestOfOthers)
{
    const TemporaryFolder folder;
    writeResults(folder);
    Quantity largest = of(Quantity::Source::largestOf, "");
    Quantity a = of(Quantity::Source::report, "errors.U.relL2");
    Quantity b = of(Quantity::Source::report, "seconds.poisson");
    a.name = "a";
    b.name = "b";
    largest.others = {"a", "b"};
    const auto values = [&] { return evaluateAll({largest, a, b}, folder.path(), folder / "run"); };
    EXPECT_EQ(values(), (std::vector<double>{0.5, 1e-3, 0.5}));
    largest.per = "steps";
    EXPECT_DOUBLE_EQ(values()[0], 0.0025);
    largest.reference = 0.002;
    EXPECT_DOUBLE_EQ(values()[0], 0.25);
    b = of(Quantity::Source::command, "echo nan");
    b.name = "b";
    EXPECT_TRUE(std::isnan(values()[0]));
}

TEST(Evaluate, NamesWhatThereIsInstead)
{
    const TemporaryFolder folder;
    writeResults(folder);
    const auto message = [&](const Quantity& quantity)
    { return messageOf([&] { evaluate(quantity, folder.path(), folder / "run"); }); };
    EXPECT_EQ(message(of(Quantity::Source::function, "errors", "rellL2(U)")),
              "system/workPrecisionDict:7: error: errors.csv has no column 'rellL2(U)'\n"
              "    it has: relL2(U), time, step");
    EXPECT_THAT(message(of(Quantity::Source::report, "error.U.relL2")),
                HasSubstr("report.json has no number 'error.U.relL2'\n    it has: errors.U.relL2, "));
    EXPECT_THAT(message(of(Quantity::Source::function, "flow", "enstrophy")),
                HasSubstr("there are no results of 'flow' in postProcessing"));
    EXPECT_THAT(message(of(Quantity::Source::command, "echo much")), HasSubstr("printed 'much'"));
    EXPECT_THAT(message(of(Quantity::Source::command, "echo why >&2; false")),
                HasSubstr("failed with exit code 1\n    why"));
}

TEST(Evaluate, LeavesOutWhatIsOptional)
{
    const TemporaryFolder folder;
    writeResults(folder);
    std::vector<Quantity> quantities{of(Quantity::Source::report, "pressureSolver.iterations.mean"),
                                     of(Quantity::Source::report, "steps")};
    EXPECT_THAT(messageOf([&] { evaluateAll(quantities, folder.path(), folder / "run"); }), HasSubstr("no number"));
    quantities[0].optional = true;
    const std::vector<double> values = evaluateAll(quantities, folder.path(), folder / "run");
    EXPECT_TRUE(std::isnan(values[0]));
    EXPECT_EQ(values[1], 200);
}

} // namespace isph
