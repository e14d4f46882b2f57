#include "fieldStore/FieldWriter.hpp"

#include "core/Error.hpp"
#include "core/version.hpp"
#include "fieldStore/layout.hpp"
#include "fieldStore/OutputFile.hpp"
#include "fieldStore/seal.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <vector>

namespace isph
{

struct FieldWriter::File
{
    OutputFile disk;
    Hdf5Handle hdf5;

    [[noreturn]] void fail(const std::string& entry) const
    {
        throw Error(Fault::input, Origin{disk.path().string(), 0, entry}, "cannot be written: " + hdf5Reason());
    }
};

namespace
{

constexpr std::size_t memoryIncrement = std::size_t{1} << 16;
constexpr std::size_t chunkBytes = std::size_t{1} << 20;

Hdf5Handle properties(hid_t kind) { return {H5Pcreate(kind), H5Pclose}; }

/// A file in memory: HDF5 1.10 crashes when a disk refuses a write, so the disk is left to OutputFile.
Hdf5Handle memoryFile(const std::string& name)
{
    const Hdf5Handle creation = properties(H5P_FILE_CREATE);
    H5Pset_userblock(creation, sealSize);
    H5Pset_obj_track_times(creation, false);
    const Hdf5Handle access = properties(H5P_FILE_ACCESS);
    H5Pset_fapl_core(access, memoryIncrement, false);
    return {H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose};
}

bool putAttribute(hid_t object, const char* name, hid_t type, hid_t space, const void* values)
{
    const Hdf5Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    return attribute.valid() && H5Awrite(attribute, type, values) >= 0;
}

bool putText(hid_t object, const char* name, const std::string& text)
{
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type, std::max<std::size_t>(text.size(), 1)); // HDF5 has no text of length 0
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    H5Tset_cset(type, H5T_CSET_UTF8);
    return putAttribute(object, name, type, space, text.c_str());
}

bool putNumber(hid_t object, const char* name, std::int32_t value)
{
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    return putAttribute(object, name, H5T_STD_I32LE, space, &value);
}

bool putLattice(hid_t object, const Lattice& lattice)
{
    std::array<double, 3> origin{};
    std::array<double, 3> extent{};
    std::array<double, 3> spacing{};
    std::array<std::int32_t, 3> count{};
    std::array<std::int32_t, 3> periodic{};
    std::array<std::int32_t, 3> staggered{};
    for (std::size_t d = 0; d < 3; ++d)
    {
        const Axis& axis = lattice.axis(static_cast<int>(d));
        origin[d] = axis.origin;
        extent[d] = axis.extent;
        spacing[d] = axis.spacing();
        count[d] = axis.count;
        periodic[d] = axis.periodic() ? 1 : 0;
        staggered[d] = axis.staggered ? 1 : 0;
    }
    const hsize_t three = 3;
    const Hdf5Handle space(H5Screate_simple(1, &three, nullptr), H5Sclose);
    return putAttribute(object, layout::originName, H5T_IEEE_F64LE, space, origin.data()) &&
           putAttribute(object, layout::extentName, H5T_IEEE_F64LE, space, extent.data()) &&
           putAttribute(object, layout::spacingName, H5T_IEEE_F64LE, space, spacing.data()) &&
           putAttribute(object, layout::countName, H5T_STD_I32LE, space, count.data()) &&
           putAttribute(object, layout::periodicName, H5T_STD_I32LE, space, periodic.data()) &&
           putAttribute(object, layout::staggeredName, H5T_STD_I32LE, space, staggered.data());
}

/// Even blocks of whole rows or planes, each of no more than chunkBytes: a checksum belongs to a chunk.
std::vector<hsize_t> chunkOf(std::vector<hsize_t> extents, std::size_t valueBytes)
{
    std::size_t bytes = valueBytes;
    for (std::size_t d = extents.size(); d-- > 0;)
    {
        const hsize_t fitting = std::max<std::size_t>(chunkBytes / bytes, 1);
        const hsize_t blocks = (extents[d] + fitting - 1) / fitting;
        extents[d] = (extents[d] + blocks - 1) / blocks;
        bytes *= extents[d];
    }
    return extents;
}

/// A dataset with a Fletcher-32 checksum on every chunk.
Hdf5Handle createDataset(hid_t parent, const std::string& name, hid_t type, const std::vector<hsize_t>& extents)
{
    const auto rank = static_cast<int>(extents.size());
    const std::vector<hsize_t> chunk = chunkOf(extents, H5Tget_size(type));
    const Hdf5Handle space(H5Screate_simple(rank, extents.data(), nullptr), H5Sclose);
    const Hdf5Handle creation = properties(H5P_DATASET_CREATE);
    H5Pset_chunk(creation, rank, chunk.data());
    H5Pset_fletcher32(creation);
    H5Pset_fill_time(creation, H5D_FILL_TIME_ALLOC); // the same bytes also where a chunk reaches over the edge
    H5Pset_obj_track_times(creation, false);
    return {H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose};
}

/// Writes rows first ... first + count - 1 of the slowest dimension.
bool writeRows(hid_t dataset, hid_t type, std::vector<hsize_t> extents, hsize_t first, hsize_t count,
               const void* values)
{
    std::vector<hsize_t> start(extents.size(), 0);
    start[0] = first;
    const auto rank = static_cast<int>(extents.size());
    const Hdf5Handle fileSpace(H5Screate_simple(rank, extents.data(), nullptr), H5Sclose);
    extents[0] = count;
    H5Sselect_hyperslab(fileSpace, H5S_SELECT_SET, start.data(), nullptr, extents.data(), nullptr);
    const Hdf5Handle memorySpace(H5Screate_simple(rank, extents.data(), nullptr), H5Sclose);
    return H5Dwrite(dataset, type, memorySpace, fileSpace, H5P_DEFAULT, values) >= 0;
}

template<class Value>
bool putState(hid_t file, const std::string& name, hid_t type, const Field<Value>& field)
{
    const Hdf5Handle group(H5Gopen2(file, layout::stateName, H5P_DEFAULT), H5Gclose);
    const std::vector<hsize_t> extents{static_cast<hsize_t>(field.components()), field.size()};
    const Hdf5Handle dataset = createDataset(group, name, type, extents);
    bool good = dataset.valid();
    for (int c = 0; good && c < field.components(); ++c)
    {
        good = writeRows(dataset, type, extents, static_cast<hsize_t>(c), 1, field[c].data());
    }
    return good;
}

} // namespace

FieldWriter::FieldWriter(const std::filesystem::path& file, const Lattice& lattice) : lattice_(lattice)
{
    silenceHdf5();
    file_ = std::make_unique<File>(File{OutputFile(file), memoryFile(file.string())});
    const hid_t root = file_->hdf5;
    const bool good =
        file_->hdf5.valid() && putNumber(root, layout::formatVersionName, layout::formatVersion) &&
        putText(root, layout::programName, std::string("Continua ") + version) && putLattice(root, lattice) &&
        Hdf5Handle(H5Gcreate2(root, layout::stateName, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose).valid();
    if (!good) { file_->fail(""); }
}

FieldWriter::~FieldWriter() = default;

void FieldWriter::write(const std::string& name, const std::string& unit, const RealField& field)
{
    assert(field.components() == 1 || field.components() == lattice_.dimensions());
    assert(field.size() == lattice_.points());
    const bool vector = field.components() > 1;
    const auto count = [&](int direction) { return static_cast<hsize_t>(lattice_.axis(direction).count); };
    std::vector<hsize_t> extents{count(2), count(1), count(0)};
    if (vector) { extents.push_back(3); }

    const Hdf5Handle dataset = createDataset(file_->hdf5, name, H5T_IEEE_F64LE, extents);
    bool good = dataset.valid() && putText(dataset, layout::unitName, unit);
    if (!vector) { good = good && writeRows(dataset, H5T_IEEE_F64LE, extents, 0, extents[0], field[0].data()); }
    else
    {
        // Interleaved plane by plane, so that no second copy of the field is needed.
        const std::size_t plane = extents[1] * extents[2];
        std::vector<double> values(plane * 3, 0.0);
        for (hsize_t iz = 0; good && iz < extents[0]; ++iz)
        {
            for (int d = 0; d < field.components(); ++d)
            {
                const auto source = field[d].subspan(iz * plane, plane);
                const auto direction = static_cast<std::size_t>(lattice_.direction(d));
                for (std::size_t n = 0; n < plane; ++n) { values[3 * n + direction] = source[n]; }
            }
            good = writeRows(dataset, H5T_IEEE_F64LE, extents, iz, 1, values.data());
        }
    }
    if (!good) { file_->fail(name); }
}

void FieldWriter::writeState(const std::string& name, const SpectralField& field)
{
    if (!putState(file_->hdf5, name, layout::complexType(), field)) { file_->fail("state/" + name); }
}

void FieldWriter::writeState(const std::string& name, const RealField& field)
{
    if (!putState(file_->hdf5, name, H5T_IEEE_F64LE, field)) { file_->fail("state/" + name); }
}

void FieldWriter::close()
{
    if (!file_) { return; }
    // The image is taken where it lies: H5Fget_file_image would copy it, and is asked for its size only.
    void* memory = nullptr;
    const bool flushed = H5Fflush(file_->hdf5, H5F_SCOPE_GLOBAL) >= 0;
    const ssize_t size = H5Fget_file_image(file_->hdf5, nullptr, 0);
    if (!flushed || size < 0 || H5Fget_vfd_handle(file_->hdf5, H5P_DEFAULT, &memory) < 0) { file_->fail(""); }

    const std::span<const char> image(*static_cast<const char**>(memory), static_cast<std::size_t>(size));
    const std::span<const char> contents = image.subspan(sealSize);
    file_->disk.write(sealOf(contents));
    file_->disk.write(contents);
    file_->disk.close();
    file_.reset();
}

} // namespace isph
