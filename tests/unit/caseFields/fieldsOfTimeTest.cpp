#include "caseFields/FieldsOfTime.hpp"
#include "caseFields/fluidConstants.hpp"
#include "core/Error.hpp"
#include "core/writeTextFile.hpp"
#include "fieldStore/FieldWriter.hpp"

#include <filesystem>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace isph
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

const Lattice lattice({Axis{'x', 0, 1, 2}, Axis{'y', 1, 2, 2, Axis::Ends::bounded}, Axis{'z', 7}}, {});

class FieldsOfTimeTest : public testing::Test
{
protected:
    FieldsOfTimeTest()
    {
        std::filesystem::create_directories(folder / "system");
        write("constant/transportProperties", "nu [0 2 -1 0 0 0 0] 0.5;\nrho 2;\n");
    }
    ~FieldsOfTimeTest() override { std::filesystem::remove_all(folder); }

    void write(const std::string& file, const std::string& text) const { writeTextFile(folder / file, text); }

    Case theCase() const { return Case(folder); }

    RealField read(const std::string& time, const std::string& name) const
    {
        return readField(theCase(), time, name, lattice);
    }

    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("fieldsOfTime-" + std::to_string(getpid()));
};

std::string messageOf(const std::function<void()>& action)
{
    try
    {
        action();
    }
    catch (const Error& error)
    {
        EXPECT_EQ(error.fault(), Fault::input);
        return error.what();
    }
    return "accepted";
}

const std::string velocity = "dimensions [0 1 -1 0 0 0 0];\n";

TEST_F(FieldsOfTimeTest, EvaluatesFormulas)
{
    write("0.5/U", velocity + "a 3;\ninternalField expression (\"x+10*y+t\" \"nu*rho*a\" \"0\");\n");
    const RealField U = read("0.5", "U");
    ASSERT_EQ(U.components(), 2);
    EXPECT_THAT(U[0], ElementsAre(10.5, 11, 30.5, 31));
    EXPECT_THAT(U[1], ElementsAre(3, 3, 3, 3));

    write("0.5/p", "dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 4;\n");
    const RealField p = read("0.5", "p");
    ASSERT_EQ(p.components(), 1);
    EXPECT_THAT(p[0], ElementsAre(4, 4, 4, 4));
    EXPECT_THAT(fieldNames(theCase(), "0.5"), ElementsAre("U", "p"));
}

TEST_F(FieldsOfTimeTest, EvaluatesPlaneByPlane)
{
    const Lattice box({Axis{'x', 0, 1, 1}, Axis{'y', 0, 2, 2}, Axis{'z', 5, 2, 2}}, {});
    write("0/p", "dimensions [0 2 -2 0 0 0 0];\ninternalField expression \"10*z+y\";\n");
    EXPECT_THAT(readField(theCase(), "0", "p", box)[0], ElementsAre(50, 51, 60, 61));
}

TEST_F(FieldsOfTimeTest, ReadsWhatASolverWrote)
{
    RealField U(2, lattice.points());
    U[1][3] = 1.0 / 3;
    RealField mean(1, lattice.points());
    mean[0][0] = -0.1;
    FieldWriter writer(folder / "fields.h5", lattice);
    writer.write("U", "m/s", U);
    writer.write("pMean", "m2/s2", mean);
    writer.close();
    write("2/U", velocity + "internalField hdf5 \"fields.h5\";\n");
    std::filesystem::rename(folder / "fields.h5", folder / "2" / "fields.h5");

    EXPECT_THAT(read("2", "U")[1], ElementsAre(0, 0, 0, 1.0 / 3));
    EXPECT_THAT(read("2", "pMean")[0], ElementsAre(-0.1, 0, 0, 0));

    const Case solved = theCase();
    FieldsOfTime fields(solved, "2");
    EXPECT_THAT(fields.names(), ElementsAre("U", "pMean"));
    EXPECT_EQ(fields.header("U").components, 3);
    EXPECT_EQ(fields.header("U").unit, "m/s");
    EXPECT_EQ(fields.header("pMean").components, 1);
    EXPECT_EQ(fields.header("pMean").unit, "m2/s2");

    const Lattice finer({Axis{'x', 0, 1, 4}, Axis{'y', 1, 2, 2, Axis::Ends::bounded}, Axis{'z', 7}}, {});
    EXPECT_EQ(messageOf([&] { readField(solved, "2", "U", finer); }),
              "2/fields.h5: U: lies on another lattice: (2 2 1) points there, (4 2 1) in constant/lattice\n"
              "    mapFields brings fields of one lattice onto another");
    EXPECT_EQ(messageOf([&] { read("2", "T"); }), "2/T: is missing\n    fields of this time are: U, pMean");
}

TEST_F(FieldsOfTimeTest, KnowsTheTime)
{
    write("0.30/U", velocity + "internalField uniform (0 0 0);\n");
    EXPECT_EQ(FieldsOfTime(theCase(), "0.30").time(), 0.3);
    EXPECT_EQ(messageOf([&] { FieldsOfTime(theCase(), "0.4"); }), "0.4: is no time folder of this case");
}

TEST_F(FieldsOfTimeTest, OverlooksWhatIsNoField)
{
    write("0/U", velocity);
    for (const char* name : {"0/U~", "0/U.orig", "0/.U.swp", "0/uniform/time"}) { write(name, ""); }
    EXPECT_THAT(fieldNames(theCase(), "0"), ElementsAre("U"));
}

TEST_F(FieldsOfTimeTest, RefusesAComponentAlongAnAxisLeftOut)
{
    write("0/U", velocity + "internalField uniform (0 0 1);\n");
    EXPECT_EQ(messageOf([&] { read("0", "U"); }),
              "0/U:2: internalField: has a component along z, an axis that the lattice leaves out\n"
              "    write 0 there, or give axis z an extent in system/latticeDict");
}

TEST_F(FieldsOfTimeTest, TellsScalarsFromVectors)
{
    write("0/T",
          "FoamFile { class latticeScalarField; }\ninternalField uniform (1 2 3);\ndimensions [0 0 0 1 0 0 0];\n");
    EXPECT_THAT(messageOf([&] { read("0", "T"); }), HasSubstr("0/T:2: internalField: "));
    write("0/T", "FoamFile { class volScalarField; }\ninternalField uniform 1;\n");
    EXPECT_EQ(messageOf([&] { read("0", "T"); }), "0/T:1: FoamFile.class: 'volScalarField' is no class of fields\n"
                                                  "    known are: latticeScalarField, latticeVectorField");
    write("0/T", "internalField table \"T.csv\";\n");
    EXPECT_EQ(messageOf([&] { read("0", "T"); }),
              "0/T:1: internalField: does not tell whether the field is a scalar or a vector\n"
              "    begin the file with FoamFile { class latticeScalarField; } or latticeVectorField");
    write("0/T", "internalField hdf5;\n");
    EXPECT_EQ(messageOf([&] { read("0", "T"); }), "0/T:1: internalField: names no file behind hdf5\n"
                                                  "    write hdf5 \"fields.h5\";");
}

TEST_F(FieldsOfTimeTest, ReadsTheConstantsOfTheFluid)
{
    EXPECT_THAT(fluidConstants(theCase()), ElementsAre(testing::Pair("nu", 0.5), testing::Pair("rho", 2)));
    std::filesystem::remove(folder / "constant/transportProperties");
    EXPECT_TRUE(fluidConstants(theCase()).empty());
}

} // namespace
} // namespace isph
