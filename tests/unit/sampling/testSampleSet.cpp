#include "Lattices.hpp"

#include "core/Error.hpp"
#include "sampling/readSampleSet.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace isph::test
{

using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

SampleSet read(const std::string& text, const Lattice& lattice, const SampleChoices& choices = {})
{
    return readSampleSet(Dictionary::parse(text, "system/sampleDict"), lattice, choices);
}

std::string refusal(const std::string& text, const Lattice& lattice)
{
    try
    {
        read(text, lattice);
    }
    catch (const Error& error)
    {
        EXPECT_EQ(error.fault(), Fault::input);
        return error.what();
    }
    return "accepted";
}

} // namespace

TEST(SampleSet, linesHaveDistanceCoordinatesAndFields)
{
    const Lattice lattice = mixedLattice(8, 9, 1);
    const RealField p = fieldOf(lattice, [](double, double y, double) { return 2 * y; });
    RealField U(2, lattice.points());
    std::ranges::copy(p[0], U[1].begin());

    const SampleSet set = read("lines { up { start (0 0.25 0); end (0 1.25 0); nPoints 3; } }", lattice);
    ASSERT_EQ(set.size(), 1U);
    EXPECT_EQ(set.name(0), "up");
    EXPECT_EQ(set.fields().at(0).text, "U");
    EXPECT_EQ(set.fields().at(1).text, "p");

    const SampleTable table = set.sample(0, std::vector<NamedField>{{"U", "m/s", U}, {"p", "m2/s2", p}});
    EXPECT_THAT(table.heads, ElementsAre("distance [m]", "x [m]", "y [m]", "z [m]", "U.x [m/s]", "U.y [m/s]",
                                         "U.z [m/s]", "p [m2/s2]"));
    EXPECT_EQ(csvText(table), "distance [m],x [m],y [m],z [m],U.x [m/s],U.y [m/s],U.z [m/s],p [m2/s2]\n"
                              "0,0,0.25,0,0,0.5,0,0.5\n"
                              "0.5,0,0.75,0,0,1.5,0,1.5\n"
                              "1,0,1.25,0,0,2.5,0,2.5\n");
}

TEST(SampleSet, planesAreLatticePointsInLongForm)
{
    const Lattice lattice = periodicLattice(4, 3, 2);
    const RealField f = fieldOf(lattice, [](double x, double y, double z) { return x + 10 * y + 100 * z; });
    const SampleSet set = read("planes { side { normal x; at -0.5; } }", lattice);
    const SampleTable table = set.sample(0, std::vector<NamedField>{{"T", "K", f}});
    EXPECT_THAT(table.heads, ElementsAre("x [m]", "y [m]", "z [m]", "T [K]"));
    ASSERT_EQ(table.columns[0].size(), 6U);
    EXPECT_THAT(table.columns[2], ElementsAre(2, 2, 2, 2.25, 2.25, 2.25));
    for (std::size_t n = 0; n < 6; ++n)
    {
        EXPECT_EQ(table.columns[0][n], -0.5);
        EXPECT_EQ(table.columns[3][n], table.columns[0][n] + 10 * table.columns[1][n] + 100 * table.columns[2][n]);
    }
}

TEST(SampleSet, planesInTwoDimensions)
{
    const Lattice lattice = periodicLattice(4, 3, 1);
    const SampleSet set = read("planes { all { normal z; at 7; } row { normal y; at 0.25; } "
                               "fine { normal z; at 0; nPoints (11 6); } }",
                               lattice);
    const RealField f = fieldOf(lattice, [](double, double, double) { return 1.0; });
    const std::vector<NamedField> fields{{"T", "K", f}};
    EXPECT_EQ(set.sample(0, fields).columns[0].size(), 12U);
    EXPECT_EQ(set.sample(0, fields).columns[2].front(), 0.0);
    EXPECT_EQ(set.sample(1, fields).columns[0].size(), 4U);
    const SampleTable fine = set.sample(2, fields);
    ASSERT_EQ(fine.columns[0].size(), 66U);
    EXPECT_EQ(fine.columns[0].front(), -1.0);
    EXPECT_EQ(fine.columns[0].back(), 1.0); // both ends of the box, also where it is periodic
    EXPECT_EQ(fine.columns[1].back(), 1.25);
}

TEST(SampleSet, choicesOverrideTheDictionary)
{
    const Lattice lattice = mixedLattice(8, 9, 1);
    const SampleSet set = read("lines { up { start (0 0.25 0); end (0 1.25 0); nPoints 4; } } fields (p);", lattice,
                               {.fields = {{{"vorticity", {}}}}, .interpolation = {{"linear", {}}}, .only = {}});
    EXPECT_EQ(set.fields().at(0).text, "vorticity");
}

TEST(SampleSet, onlyOneOfThem)
{
    const Lattice lattice = mixedLattice(8, 9, 1);
    const std::string text = "lines { a { start (0 1 0); end (1 1 0); nPoints 4; } } planes { b { normal z; at 0; } }";
    const SampleSet set = read(text, lattice, {.fields = {}, .interpolation = {}, .only = {{"b", {}}}});
    ASSERT_EQ(set.size(), 1U);
    EXPECT_EQ(set.name(0), "b");
    EXPECT_THROW(read(text, lattice, {.fields = {}, .interpolation = {}, .only = {{"c", {}}}}), Error);
}

TEST(SampleSet, namesWhatIsWrong)
{
    const Lattice lattice = mixedLattice(8, 9, 1);
    EXPECT_EQ(refusal("lines { up { start (0 0.2 0); end (0 1.25 0); nPoints 4; } }", lattice),
              "system/sampleDict:1: lines.up.start: has y = 0.2, outside of the box\n    y reaches from 0.25 to 1.25");
    EXPECT_THAT(refusal("planes { mid { normal y; at 2; } }", lattice), HasSubstr("planes.mid.at: has y = 2, outside"));
    EXPECT_THAT(refusal("lines { up { start (0 1 0); end (0 1 0); nPoints 4; } }", lattice),
                HasSubstr("lines.up.end: is the same point as the start"));
    EXPECT_THAT(refusal("fields (U);", lattice), HasSubstr("asks for no line and no plane"));
    EXPECT_THAT(
        refusal("lines { a { start (0 1 0); end (1 1 0); nPoints 4; } } planes { a { normal z; at 0; } }", lattice),
        HasSubstr("planes.a: is the name of a line already"));
    EXPECT_THAT(refusal("planes { a { normal z; at 0; nPoints (3.5 2); } }", lattice),
                HasSubstr("planes.a.nPoints: is not two whole numbers"));
    EXPECT_THAT(refusal("planes { a { normal z; at 0; } } interpolation cubical;", lattice), HasSubstr("cubic"));
    EXPECT_THAT(refusal("lines { up { start (0 1 0); end (0 1.2 0); nPoints 1; } }", lattice), HasSubstr("nPoints"));
    EXPECT_THAT(refusal("lines { up { start (0 1 0); ends (0 1.2 0); nPoints 3; } }", lattice), HasSubstr("end"));
}

TEST(SampleSet, planesOfWords)
{
    const Lattice flat = periodicLattice(4, 3, 1);
    const Lattice box = mixedLattice(4, 3, 2);
    EXPECT_EQ(planeOfText("auto", flat).normal, 2);
    EXPECT_EQ(planeOfText("auto", box).at, 2.25);
    EXPECT_EQ(planeOfText("x", box).at, 0);
    EXPECT_EQ(planeOfText(" y 0.5 ", box).at, 0.5);
    for (const char* text : {"", "w 1", "x 1 2", "x one", "x nan", "xy"})
    {
        EXPECT_THROW(planeOfText(text, box), Error) << text;
    }
    EXPECT_THROW(planeOfText("y 2", box), Error);
}

TEST(SampleSet, writesAFileAPlace)
{
    const Lattice lattice = periodicLattice(4, 3, 1);
    const SampleSet set =
        read("planes { all { normal z; at 0; } } lines { up { start (0 0 0); end (0 1 0); nPoints 4; } }", lattice);
    const RealField f = fieldOf(lattice, [](double, double, double) { return 1.0; });
    const std::vector<NamedField> fields{{"T", "K", f}};
    std::string folder = (std::filesystem::temp_directory_path() / "samplingXXXXXX").string();
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    writeSamples(set, fields, std::filesystem::path(folder) / "0.25");
    for (const std::size_t place : {0U, 1U})
    {
        std::ifstream in(std::filesystem::path(folder) / "0.25" / (set.name(place) + ".csv"));
        EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), csvText(set.sample(place, fields)));
    }
    std::filesystem::remove_all(folder);
}

} // namespace isph::test
