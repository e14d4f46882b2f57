#include "core/Error.hpp"
#include "vtkOutput/writePvd.hpp"
#include "vtkOutput/writeVti.hpp"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace isph
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class VtkOutput : public testing::Test
{
protected:
    VtkOutput() { std::filesystem::create_directories(folder); }
    ~VtkOutput() override { std::filesystem::remove_all(folder); }

    std::string textOf(const std::string& name) const
    {
        std::ifstream stream(folder / name, std::ios::binary);
        std::ostringstream text;
        text << stream.rdbuf();
        return text.str();
    }

    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("vtkOutput-" + std::to_string(getpid()));
};

/// The value of an attribute of the data array with this name.
std::string attribute(const std::string& vti, const std::string& array, const std::string& name)
{
    const std::size_t at = vti.find("Name=\"" + array + "\"");
    const std::size_t begin = vti.find(name + "=\"", at) + name.size() + 2;
    return vti.substr(begin, vti.find('"', begin) - begin);
}

/// The appended values of a data array that is not compressed.
template<class Value>
std::vector<Value> valuesOf(const std::string& vti, const std::string& array)
{
    const std::size_t data = vti.find('_', vti.find("<AppendedData")) + 1 + std::stoul(attribute(vti, array, "offset"));
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, vti.data() + data, sizeof bytes);
    std::vector<Value> values(bytes / sizeof(Value));
    std::memcpy(values.data(), vti.data() + data + sizeof bytes, bytes);
    return values;
}

const Lattice channel({Axis{'x', -1, 2, 2}, Axis{'y', 3, 1, 3, Axis::Ends::bounded}, Axis{'z', 7}}, {});

RealField counted(int components, std::size_t size)
{
    RealField field(components, size);
    for (int c = 0; c < components; ++c)
    {
        for (std::size_t n = 0; n < size; ++n) { field[c][n] = 100 * c + static_cast<double>(n); }
    }
    return field;
}

TEST_F(VtkOutput, ClosesPeriodicAxes)
{
    const RealField p = counted(1, channel.points());
    const std::vector<ImageArray> arrays{{"p", &p}};
    writeVti(folder / "a.vti", channel, 0.25, arrays);

    const std::string text = textOf("a.vti");
    EXPECT_THAT(text, HasSubstr("WholeExtent=\"0 2 0 2 0 0\" Origin=\"-1 3 7\" Spacing=\"1 0.5 1\""));
    EXPECT_THAT(valuesOf<double>(text, "p"), ElementsAre(0, 1, 0, 2, 3, 2, 4, 5, 4));
    EXPECT_THAT(valuesOf<double>(text, "TimeValue"), ElementsAre(0.25));
}

TEST_F(VtkOutput, ShowsStaggeredPointsWhereTheyAre)
{
    const Lattice lattice({Axis{'x', -1, 2, 2}, Axis{'y', 3, 1, 2, Axis::Ends::bounded, true}, Axis{'z', 7}}, {});
    const RealField p = counted(1, lattice.points());
    const std::vector<ImageArray> arrays{{"p", &p}};
    writeVti(folder / "a.vti", lattice, 0, arrays);
    EXPECT_THAT(textOf("a.vti"), HasSubstr("WholeExtent=\"0 2 0 1 0 0\" Origin=\"-1 3.25 7\" Spacing=\"1 0.5 1\""));
    EXPECT_THAT(valuesOf<double>(textOf("a.vti"), "p"), ElementsAre(0, 1, 0, 2, 3, 2));
}

TEST_F(VtkOutput, GivesVectorsThreeComponents)
{
    // Axes x and z in use: the second component of the velocity is along z.
    const Lattice lattice({Axis{'x', 0, 1, 2, Axis::Ends::bounded}, Axis{'y'}, Axis{'z', 0, 1, 2, Axis::Ends::bounded}},
                          {});
    const RealField U = counted(2, lattice.points());
    const std::vector<ImageArray> arrays{{"U", &U}};
    writeVti(folder / "a.vti", lattice, 0, arrays, {.compressed = false, .singlePrecision = true});

    const std::string text = textOf("a.vti");
    EXPECT_EQ(attribute(text, "U", "NumberOfComponents"), "3");
    EXPECT_THAT(valuesOf<float>(text, "U"), ElementsAre(0, 0, 100, 1, 0, 101, 2, 0, 102, 3, 0, 103));
}

TEST_F(VtkOutput, AddsThePeriodGain)
{
    const RealField psi = counted(1, channel.points());
    const std::vector<ImageArray> arrays{{"psi", &psi, {0.5, 9, 9}}};
    writeVti(folder / "a.vti", channel, 0, arrays);
    EXPECT_THAT(valuesOf<double>(textOf("a.vti"), "psi"), ElementsAre(0, 1, 0.5, 2, 3, 2.5, 4, 5, 4.5));
}

TEST_F(VtkOutput, ClosesAllAxesOfABox)
{
    const Lattice box({Axis{'x', 0, 1, 2}, Axis{'y', 0, 1, 2}, Axis{'z', 0, 1, 2}}, {});
    const RealField p = counted(1, box.points());
    const std::vector<ImageArray> arrays{{"p", &p}};
    writeVti(folder / "a.vti", box, 0, arrays);
    EXPECT_THAT(valuesOf<double>(textOf("a.vti"), "p"),
                ElementsAre(0, 1, 0, 2, 3, 2, 0, 1, 0, 4, 5, 4, 6, 7, 6, 4, 5, 4, 0, 1, 0, 2, 3, 2, 0, 1, 0));
}

TEST_F(VtkOutput, Compresses)
{
    const RealField p(1, channel.points());
    const std::vector<ImageArray> arrays{{"p", &p}};
    writeVti(folder / "a.vti", channel, 0, arrays, {.compressed = true});
    EXPECT_THAT(textOf("a.vti"), HasSubstr("compressor=\"vtkZLibDataCompressor\""));
    writeVti(folder / "a.vti", channel, 0, arrays);
    EXPECT_THAT(textOf("a.vti"), Not(HasSubstr("compressor")));
}

TEST_F(VtkOutput, NamesTheFileThatCannotBeWritten)
{
    const std::filesystem::path file = folder / "missing" / "a.vti";
    try
    {
        writeVti(file, channel, 0, {});
        FAIL() << "written";
    }
    catch (const Error& error)
    {
        EXPECT_THAT(error.what(), HasSubstr(file.string() + ": could not be written: No such file or directory"));
    }
}

TEST_F(VtkOutput, LeavesNothingElse)
{
    writeVti(folder / "a.vti", channel, 0, {});
    writePvd(folder / "a.pvd", {});
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) { names.push_back(entry.path().filename()); }
    EXPECT_THAT(names, testing::UnorderedElementsAre("a.vti", "a.pvd"));
}

TEST(Pvd, GivesEachFileItsTime)
{
    EXPECT_EQ(pvdText(std::vector<PvdEntry>{{0, "a&b_0.vti"}, {0.1, "a&b_0.1.vti"}}),
              "<?xml version=\"1.0\"?>\n"
              "<VTKFile type=\"Collection\" version=\"1.0\">\n"
              "  <Collection>\n"
              "    <DataSet timestep=\"0\" part=\"0\" file=\"a&amp;b_0.vti\"/>\n"
              "    <DataSet timestep=\"0.1\" part=\"0\" file=\"a&amp;b_0.1.vti\"/>\n"
              "  </Collection>\n"
              "</VTKFile>\n");
}

} // namespace
} // namespace isph
