#include "FieldFile.hpp"

#include "core/Error.hpp"
#include "core/version.hpp"
#include "fieldStore/checksum.hpp"
#include "fieldStore/FieldReader.hpp"
#include "fieldStore/seal.hpp"

#include <gmock/gmock.h>

#include <csignal>
#include <cstring>
#include <sys/resource.h>

namespace isph::test
{

using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

/// The message of the Error(input) that reading a file must end with.
std::string refusal(const std::filesystem::path& file)
{
    try
    {
        const FieldReader reader(file, "0.25/fields.h5");
    }
    catch (const Error& error)
    {
        EXPECT_EQ(error.fault(), Fault::input);
        return error.what();
    }
    return "accepted";
}

/// The file with a new seal over changed contents.
void reseal(const std::filesystem::path& file, std::string bytes)
{
    const Seal seal = sealOf(std::span(bytes).subspan(sealSize));
    bytes.replace(0, sealSize, seal.data(), sealSize);
    putBytes(file, bytes);
}

} // namespace

TEST(checksum, isThatOfZlib)
{
    const std::string text = "123456789";
    EXPECT_EQ(crc32(text), 0xCBF43926U); // the check value of the catalogue of CRCs
    EXPECT_EQ(crc32(text.substr(4), crc32(text.substr(0, 4))), 0xCBF43926U);
    EXPECT_EQ(crc32(std::string()), 0U);

    // Blocks and single bytes give the same.
    std::string bytes(1000, '\0');
    for (std::size_t n = 0; n < bytes.size(); ++n) { bytes[n] = static_cast<char>(n * n + 7); }
    std::uint32_t single = 0;
    for (const char& byte : bytes) { single = crc32(std::span(&byte, 1), single); }
    EXPECT_EQ(crc32(bytes), single);
}

TEST(FieldStore, givesBackEveryBit)
{
    const Scratch scratch;
    writeSmall(scratch / "fields.h5");
    const FieldReader reader(scratch / "fields.h5");

    EXPECT_EQ(reader.lattice(), lattice2D());
    EXPECT_THAT(reader.fields(), ElementsAre("U", "p"));
    EXPECT_EQ(reader.unit("U"), "m/s");
    EXPECT_EQ(reader.unit("p"), "m2/s2");

    const RealField U = reader.read("U");
    const RealField written = anyBits(2, 30, 1);
    ASSERT_EQ(U.components(), 2);
    EXPECT_TRUE(sameBits(U[0], written[0]));
    EXPECT_TRUE(sameBits(U[1], written[1]));
    EXPECT_TRUE(sameBits(reader.read("p")[0], anyBits(1, 30, 2)[0]));

    RealField state(1, 7);
    reader.readState("pressure", state);
    EXPECT_TRUE(sameBits(state[0], anyBits(1, 7, 3)[0]));
    SpectralField modes(2, 20);
    reader.readState("U", modes);
    EXPECT_EQ(modes[1][19], std::complex<double>(0.1 * 19, -1.0 / 4));
}

TEST(FieldStore, keepsLargeFieldsOfThreeDimensions)
{
    const Scratch scratch;
    const Lattice lattice = lattice3D(70, 131, 9); // planes and edges that do not fill their chunks
    const RealField U = anyBits(3, lattice.points(), 4);
    const RealField p = anyBits(1, lattice.points(), 5);
    FieldWriter writer(scratch / "fields.h5", lattice);
    writer.write("U", "m/s", U);
    writer.write("p", "m2/s2", p);
    writer.writeState("U", U);
    writer.close();

    const FieldReader reader(scratch / "fields.h5");
    EXPECT_EQ(reader.lattice(), lattice);
    const RealField readU = reader.read("U");
    RealField state(3, lattice.points());
    reader.readState("U", state);
    for (int d = 0; d < 3; ++d)
    {
        EXPECT_TRUE(sameBits(readU[d], U[d]));
        EXPECT_TRUE(sameBits(state[d], U[d]));
    }
    EXPECT_TRUE(sameBits(reader.read("p")[0], p[0]));
    EXPECT_LT(std::filesystem::file_size(scratch / "fields.h5"), 1.2 * 8.0 * 7.0 * static_cast<double>(U.size()));
}

TEST(FieldStore, sameDataGiveTheSameBytes)
{
    const Scratch scratch;
    for (const char* name : {"a.h5", "b.h5"})
    {
        // Memory that was used before must not show through.
        const std::vector<char> dirt(std::size_t{3} << 20, name[0]);
        EXPECT_EQ(dirt.back(), name[0]);
        const Lattice lattice = lattice3D(70, 131, 9);
        FieldWriter writer(scratch / name, lattice);
        writer.write("U", "m/s", anyBits(3, lattice.points(), 4));
        writer.close();
    }
    EXPECT_TRUE(bytesOf(scratch / "a.h5") == bytesOf(scratch / "b.h5"));
}

TEST(FieldStore, refusesEveryFlippedByte)
{
    const Scratch scratch;
    writeSmall(scratch / "fields.h5");
    const std::string good = bytesOf(scratch / "fields.h5");
    std::fstream file(scratch / "fields.h5", std::ios::binary | std::ios::in | std::ios::out);
    const auto put = [&](std::size_t n, char byte) { file.seekp(static_cast<std::streamoff>(n)).put(byte).flush(); };
    for (std::size_t n = 0; n < good.size(); ++n)
    {
        put(n, static_cast<char>(good[n] ^ (1 << n % 8)));
        const std::string message = refusal(scratch / "fields.h5");
        ASSERT_TRUE(message.starts_with("0.25/fields.h5: is damaged") ||
                    message.starts_with("0.25/fields.h5: is no file of fields"))
            << "byte " << n << " of " << good.size() << ": " << message;
        put(n, good[n]);
    }
    EXPECT_EQ(refusal(scratch / "fields.h5"), "accepted");
}

TEST(FieldStore, refusesFilesCutShortOrGrown)
{
    const Scratch scratch;
    writeSmall(scratch / "fields.h5");
    const std::string good = bytesOf(scratch / "fields.h5");
    for (const std::size_t size :
         {good.size() - 1, good.size() / 2, std::size_t{513}, std::size_t{512}, std::size_t{99}})
    {
        putBytes(scratch / "bad.h5", good.substr(0, size));
        EXPECT_THAT(refusal(scratch / "bad.h5"), HasSubstr("0.25/fields.h5: is damaged"));
    }
    putBytes(scratch / "bad.h5", good + '\0');
    EXPECT_THAT(refusal(scratch / "bad.h5"), HasSubstr("0.25/fields.h5: is damaged"));
    putBytes(scratch / "bad.h5", "");
    EXPECT_THAT(refusal(scratch / "bad.h5"), HasSubstr("0.25/fields.h5: is no file of fields"));
}

TEST(FieldStore, datasetsAreGuardedByThemselvesToo)
{
    const Scratch scratch;
    const Lattice lattice = lattice3D(8, 8, 8);
    RealField p(1, lattice.points());
    std::ranges::fill(p[0], 1.25);
    FieldWriter writer(scratch / "fields.h5", lattice);
    writer.write("p", "m2/s2", p);
    writer.close();
    std::string bytes = bytesOf(scratch / "fields.h5");
    const double value = 1.25;
    std::string needle(sizeof(double), '\0');
    std::memcpy(needle.data(), &value, sizeof value);
    bytes[bytes.find(needle + needle)] = 1;
    reseal(scratch / "fields.h5", bytes);

    const FieldReader reader(scratch / "fields.h5", "1/fields.h5");
    try
    {
        reader.read("p");
        FAIL();
    }
    catch (const Error& error)
    {
        EXPECT_THAT(error.what(), HasSubstr("1/fields.h5: p: cannot be read: "));
    }
}

TEST(FieldStore, namesWhatItCannotRead)
{
    const Scratch scratch;
    EXPECT_EQ(refusal(scratch / "none.h5"), "0.25/fields.h5: cannot be read: No such file or directory");
    EXPECT_EQ(refusal(scratch / "."), "0.25/fields.h5: cannot be read: Is a directory");
    putBytes(scratch / "text.h5", "0.1 0.2 0.3\n");
    EXPECT_THAT(refusal(scratch / "text.h5"), HasSubstr("0.25/fields.h5: is no file of fields"));
    putBytes(scratch / "other.h5", "\x89HDF\r\n\x1a\n and so on");
    EXPECT_THAT(refusal(scratch / "other.h5"),
                HasSubstr("0.25/fields.h5: is an HDF5 file, but not one that this suite"));
}

TEST(FieldStore, refusesANewerFormat)
{
    const Scratch scratch;
    writeSmall(scratch / "fields.h5");
    std::string bytes = bytesOf(scratch / "fields.h5");
    // The attribute's value lies behind its name (16 bytes), its type (16) and its shape (8).
    const std::size_t at = bytes.find("formatVersion") + 40;
    ASSERT_EQ(bytes[at], 1);
    bytes[at] = 7;
    reseal(scratch / "fields.h5", bytes);
    EXPECT_EQ(refusal(scratch / "fields.h5"),
              std::string("0.25/fields.h5: has format version 7, written by Continua ") + version +
                  ", but this program reads no version above 1\n"
                  "    read it with the program that wrote it, or a later one");
}

TEST(FieldStore, saysWhatIsMissingOrOfAnotherShape)
{
    const Scratch scratch;
    writeSmall(scratch / "fields.h5");
    const FieldReader reader(scratch / "fields.h5", "1/fields.h5");
    const auto messageOf = [](auto&& action) -> std::string
    {
        try
        {
            action();
        }
        catch (const Error& error)
        {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_FALSE(reader.has("T"));
    EXPECT_FALSE(reader.has("state"));
    EXPECT_FALSE(reader.has("state/U"));
    EXPECT_TRUE(reader.hasState("U"));
    EXPECT_FALSE(reader.hasState("T"));
    EXPECT_EQ(messageOf([&] { reader.read("T"); }), "1/fields.h5: T: is missing\n    there are: U, p");
    EXPECT_THAT(messageOf([&] { reader.read("state"); }), HasSubstr("1/fields.h5: state: is missing"));
    SpectralField modes(2, 21);
    EXPECT_THAT(messageOf([&] { reader.readState("U", modes); }),
                HasSubstr("1/fields.h5: state/U: has the shape (2 20) but must have (2 21)"));
    EXPECT_THAT(messageOf([&] { reader.readState("T", modes); }), HasSubstr("1/fields.h5: state/T: is missing"));
    RealField real(2, 20);
    EXPECT_THAT(messageOf([&] { reader.readState("U", real); }), HasSubstr("1/fields.h5: state/U: "));
}

TEST(FieldStore, withoutCloseThereIsNoFileToRead)
{
    const Scratch scratch;
    {
        FieldWriter writer(scratch / "fields.h5", lattice2D());
        writer.write("p", "m2/s2", anyBits(1, 30, 2));
    }
    EXPECT_THAT(refusal(scratch / "fields.h5"), HasSubstr("is no file of fields"));
}

TEST(FieldStore, reportsAFullDisk)
{
    try
    {
        writeSmall("/dev/full");
        FAIL();
    }
    catch (const Error& error)
    {
        EXPECT_THAT(error.what(), HasSubstr("/dev/full: could not be written: No space left on device"));
    }
}

TEST(FieldStore, reportsAFileThatMayNotGrow)
{
    const Scratch scratch;
    writeSmall(scratch / "whole.h5");
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    for (const rlim_t limit : {rlim_t{0}, rlim_t{100}, rlim_t{1000}, rlim_t{5000}})
    {
        const rlimit tight{limit, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &tight);
        EXPECT_THROW(writeSmall(scratch / "part.h5"), Error) << limit;
        setrlimit(RLIMIT_FSIZE, &before);
        EXPECT_NE(refusal(scratch / "part.h5"), "accepted");
    }
    std::signal(SIGXFSZ, handler);
}

TEST(FieldStore, saysWhyAFileCannotBeMade)
{
    const Scratch scratch;
    EXPECT_THROW(FieldWriter(scratch / "none/fields.h5", lattice2D()), Error);
}

} // namespace isph::test
