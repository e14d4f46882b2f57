#include "functions/FieldAverage.hpp"
#include "fieldStore/FieldReader.hpp"
#include "Flows.hpp"

#include <gtest/gtest.h>

namespace isph
{
namespace
{

using namespace test;

class FieldAverageTest : public testing::Test
{
protected:
    /// The flow at time t: U = (t, x), p = x + t^2.
    FlowAtTime when(double t, const std::string& name = "")
    {
        fill(flow.U, 0, lattice, [t](double, double, double) { return t; });
        fill(flow.U, 1, lattice, [](double x, double, double) { return x; });
        fill(flow.p, 0, lattice, [t](double x, double, double) { return x + t * t; });
        return at(flow, timings, t, name);
    }

    FieldAverage average(const std::string& startTime, bool moments = true)
    {
        return {folder.path, startTime, lattice, FlowFields(lattice, {}), {FlowQuantity::U, FlowQuantity::p}, moments};
    }

    std::string bytesOf(const std::string& time)
    {
        std::ifstream file(folder.path / time / "fields.h5", std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    TemporaryFolder folder;
    Lattice lattice = square(4);
    GivenFlow flow{lattice};
    Timings timings;
};

// Samples at 1, 2, 4 count 1, 1, 2: of t the mean is 11/4 and the variance 27/16.
TEST_F(FieldAverageTest, WeighsSamplesByTheTimeBeforeThem)
{
    FieldAverage averages = average("0");
    for (const double t : {0.0, 1.0, 2.0, 4.0}) { averages.accumulate(when(t)); }
    averages.execute(when(4, "4"));

    const FieldReader reader(folder.path / "4/fields.h5");
    EXPECT_EQ(reader.fields(), (std::vector<std::string>{"UMean", "UPrime2Mean.xx", "UPrime2Mean.xy", "UPrime2Mean.yy",
                                                         "pMean", "pPrime2Mean"}));
    EXPECT_EQ(reader.unit("UMean"), "m/s");
    EXPECT_EQ(reader.unit("UPrime2Mean.xy"), "m2/s2");
    EXPECT_EQ(reader.unit("pPrime2Mean"), "m4/s4");
    EXPECT_NEAR(reader.read("UMean")[0][5], 11.0 / 4, 1e-15);
    EXPECT_NEAR(reader.read("UMean")[1][5], 0.25, 1e-15);
    EXPECT_NEAR(reader.read("UPrime2Mean.xx")[0][5], 27.0 / 16, 1e-14);
    EXPECT_NEAR(reader.read("UPrime2Mean.xy")[0][5], 0, 1e-15);
    EXPECT_NEAR(reader.read("UPrime2Mean.yy")[0][5], 0, 1e-15);
    EXPECT_NEAR(reader.read("pMean")[0][5], 0.25 + 37.0 / 4, 1e-14);
}

TEST_F(FieldAverageTest, WritesNothingBeforeThereIsTimeToAverageOver)
{
    FieldAverage averages = average("0");
    averages.execute(when(0, "0"));
    averages.accumulate(when(0));
    averages.execute(when(0, "0"));
    EXPECT_FALSE(std::filesystem::exists(folder.path / "0"));
}

TEST_F(FieldAverageTest, LeavesOutMomentsWhereNoneAreAskedFor)
{
    FieldAverage averages = average("0", false);
    averages.accumulate(when(0));
    averages.accumulate(when(1));
    averages.execute(when(1, "1"));
    EXPECT_EQ(FieldReader(folder.path / "1/fields.h5").fields(), (std::vector<std::string>{"UMean", "pMean"}));
}

TEST_F(FieldAverageTest, GoesOnInTheSameBits)
{
    const std::vector<double> times{0, 0.1, 0.3, 0.35, 0.7, 0.8};
    FieldAverage whole = average("0");
    for (const double t : times) { whole.accumulate(when(t)); }
    whole.execute(when(times.back(), "whole"));

    FieldAverage first = average("0");
    for (std::size_t i = 0; i < 3; ++i) { first.accumulate(when(times[i])); }
    first.execute(when(times[2], "0.3"));
    FieldAverage second = average("0.3");
    for (std::size_t i = 2; i < times.size(); ++i) { second.accumulate(when(times[i])); }
    second.execute(when(times.back(), "parts"));

    EXPECT_FALSE(bytesOf("whole").empty());
    EXPECT_EQ(bytesOf("whole"), bytesOf("parts"));
}

// Stopped at 0.2, between the samples at 0.1 and 0.3: a restart is no sample.
TEST_F(FieldAverageTest, GoesOnBetweenSamples)
{
    FieldAverage whole = average("0");
    for (const double t : {0.0, 0.1, 0.3}) { whole.accumulate(when(t)); }
    whole.execute(when(0.3, "whole"));

    FieldAverage first = average("0");
    for (const double t : {0.0, 0.1}) { first.accumulate(when(t)); }
    first.execute(when(0.2, "0.2"));
    FieldAverage second = average("0.2");
    for (const double t : {0.2, 0.3}) { second.accumulate(when(t)); }
    second.execute(when(0.3, "parts"));
    EXPECT_EQ(bytesOf("whole"), bytesOf("parts"));
}

TEST_F(FieldAverageTest, TakesAwayWhatAKilledRunLeft)
{
    std::filesystem::create_directories(folder.path / ".0.5.tmp-999999999");
    FieldAverage averages = average("0");
    averages.accumulate(when(0));
    EXPECT_FALSE(std::filesystem::exists(folder.path / ".0.5.tmp-999999999"));
}

TEST_F(FieldAverageTest, RefusesAveragesOnAnotherLattice)
{
    FieldAverage averages = average("0");
    averages.accumulate(when(0));
    averages.accumulate(when(1));
    averages.execute(when(1, "1"));
    const Lattice finer = square(8);
    GivenFlow fineFlow(finer);
    FieldAverage next(folder.path, "1", finer, FlowFields(finer, {}), {FlowQuantity::U}, true);
    try
    {
        next.accumulate(at(fineFlow, timings, 1));
        FAIL();
    }
    catch (const Error& error)
    {
        EXPECT_EQ(std::string(error.what()), (folder.path / "1/fields.h5").string() +
                                                 ": holds averages on another lattice\n"
                                                 "    remove that folder to average from the start");
    }
}

} // namespace
} // namespace isph
