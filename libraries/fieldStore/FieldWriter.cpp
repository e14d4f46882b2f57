#include "fieldStore/FieldWriter.hpp"

#include "core/FileDescriptor.hpp"
#include "core/version.hpp"
#include "fieldStore/layout.hpp"
#include "fieldStore/seal.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <fcntl.h>
#include <string_view>
#include <vector>

namespace isph
{

struct FieldWriter::File
{
    FileDescriptor disk;
    Hdf5Handle hdf5;

    Origin origin(const std::string& entry = "") const { return {disk.file().string(), 0, entry}; }
};

namespace
{

constexpr std::size_t memoryIncrement = std::size_t{1} << 16;
constexpr std::size_t chunkBytes = std::size_t{1} << 20;
constexpr const char* problem = "cannot be written";

Hdf5Handle properties(hid_t kind) { return {H5Pcreate(kind), H5Pclose}; }

/// A file in memory: HDF5 1.10 crashes when a disk refuses a write, so the disk is left to FileDescriptor.
Hdf5Handle memoryFile(const std::string& name)
{
    silenceHdf5();
    const Hdf5Handle creation = properties(H5P_FILE_CREATE);
    H5Pset_userblock(creation, sealSize);
    H5Pset_obj_track_times(creation, false);
    const Hdf5Handle access = properties(H5P_FILE_ACCESS);
    H5Pset_fapl_core(access, memoryIncrement, false);
    return {checked(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation, access), {name, 0, ""}, problem), H5Fclose};
}

void putAttribute(hid_t object, const char* name, hid_t type, hid_t space, const void* values, const Origin& origin)
{
    const Hdf5Handle attribute(
        checked(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), origin, problem), H5Aclose);
    checked(H5Awrite(attribute, type, values), origin, problem);
}

void putText(hid_t object, const char* name, const std::string& text, const Origin& origin)
{
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type, std::max<std::size_t>(text.size(), 1)); // HDF5 has no text of length 0
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    H5Tset_cset(type, H5T_CSET_UTF8);
    putAttribute(object, name, type, space, text.c_str(), origin);
}

void putLattice(hid_t object, const Lattice& lattice, const Origin& fileOrigin)
{
    const hsize_t three = 3;
    const Hdf5Handle space(H5Screate_simple(1, &three, nullptr), H5Sclose);
    const auto put = [&]<class Value>(const char* name, hid_t type, Value (*value)(const Axis&))
    {
        const std::array<Value, 3> values{value(lattice.axis(0)), value(lattice.axis(1)), value(lattice.axis(2))};
        putAttribute(object, name, type, space, values.data(), fileOrigin);
    };
    put(
        layout::originName, H5T_NATIVE_DOUBLE, +[](const Axis& axis) { return axis.origin; });
    put(
        layout::extentName, H5T_NATIVE_DOUBLE, +[](const Axis& axis) { return axis.extent; });
    put(
        layout::spacingName, H5T_NATIVE_DOUBLE, +[](const Axis& axis) { return axis.spacing(); });
    put(
        layout::countName, H5T_NATIVE_INT, +[](const Axis& axis) { return axis.count; });
    put(
        layout::periodicName, H5T_NATIVE_INT, +[](const Axis& axis) { return axis.periodic() ? 1 : 0; });
    put(
        layout::staggeredName, H5T_NATIVE_INT, +[](const Axis& axis) { return axis.staggered ? 1 : 0; });
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
Hdf5Handle createDataset(hid_t parent, const std::string& name, hid_t type, const std::vector<hsize_t>& extents,
                         const Origin& origin)
{
    const auto rank = static_cast<int>(extents.size());
    const std::vector<hsize_t> chunk = chunkOf(extents, H5Tget_size(type));
    const Hdf5Handle space(checked(H5Screate_simple(rank, extents.data(), nullptr), origin, problem), H5Sclose);
    const Hdf5Handle creation = properties(H5P_DATASET_CREATE);
    H5Pset_chunk(creation, rank, chunk.data());
    H5Pset_fletcher32(creation);
    H5Pset_fill_time(creation, H5D_FILL_TIME_ALLOC); // the same bytes also where a chunk reaches over the edge
    H5Pset_obj_track_times(creation, false);
    return {checked(H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT), origin, problem),
            H5Dclose};
}

/// Writes rows first ... first + count - 1 of the slowest dimension.
void writeRows(hid_t dataset, hid_t type, hsize_t first, hsize_t count, const void* values, const Origin& origin)
{
    const Hdf5Handle fileSpace(H5Dget_space(dataset), H5Sclose);
    const std::vector<hsize_t> extents = selectRows(fileSpace, first, count);
    const auto rank = static_cast<int>(extents.size());
    const Hdf5Handle memorySpace(H5Screate_simple(rank, extents.data(), nullptr), H5Sclose);
    checked(H5Dwrite(dataset, type, memorySpace, fileSpace, H5P_DEFAULT, values), origin, problem);
}

template<class Value>
void putState(hid_t file, const std::string& name, hid_t type, const Field<Value>& field, const Origin& origin)
{
    const Hdf5Handle group(checked(H5Gopen2(file, layout::stateName, H5P_DEFAULT), origin, problem), H5Gclose);
    const Hdf5Handle dataset =
        createDataset(group, name, type, {static_cast<hsize_t>(field.components()), field.size()}, origin);
    for (int c = 0; c < field.components(); ++c)
    {
        writeRows(dataset, type, static_cast<hsize_t>(c), 1, field[c].data(), origin);
    }
}

} // namespace

FieldWriter::FieldWriter(const std::filesystem::path& file, const Lattice& lattice)
    : file_(
          std::make_unique<File>(File{FileDescriptor(file, O_WRONLY | O_CREAT | O_TRUNC), memoryFile(file.string())})),
      lattice_(lattice)
{
    const Origin origin = file_->origin();
    const hid_t root = file_->hdf5;
    const Hdf5Handle scalar(H5Screate(H5S_SCALAR), H5Sclose);
    putAttribute(root, layout::formatVersionName, H5T_NATIVE_INT, scalar, &layout::formatVersion, origin);
    putText(root, layout::programName, std::string("Continua ") + version, origin);
    putLattice(root, lattice, origin);
    const Hdf5Handle state(
        checked(H5Gcreate2(root, layout::stateName, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), origin, problem), H5Gclose);
}

FieldWriter::~FieldWriter() = default;

void FieldWriter::write(const std::string& name, const std::string& unit, const RealField& field)
{
    assert(field.components() == 1 || field.components() == lattice_.dimensions());
    assert(field.size() == lattice_.points());
    const Origin origin = file_->origin(name);
    const std::vector<hsize_t> extents = layout::extentsOf(lattice_, field.components() > 1);
    const Hdf5Handle dataset = createDataset(file_->hdf5, name, H5T_IEEE_F64LE, extents, origin);
    putText(dataset, layout::unitName, unit, origin);
    if (field.components() == 1)
    {
        writeRows(dataset, H5T_NATIVE_DOUBLE, 0, extents[0], field[0].data(), origin);
        return;
    }
    // Interleaved plane by plane, so that no second copy of the field is needed.
    const std::size_t plane = extents[1] * extents[2];
    std::vector<double> values(plane * 3, 0.0);
    for (hsize_t iz = 0; iz < extents[0]; ++iz)
    {
        for (int d = 0; d < field.components(); ++d)
        {
            const auto source = field[d].subspan(iz * plane, plane);
            const auto direction = static_cast<std::size_t>(lattice_.direction(d));
            for (std::size_t n = 0; n < plane; ++n) { values[3 * n + direction] = source[n]; }
        }
        writeRows(dataset, H5T_NATIVE_DOUBLE, iz, 1, values.data(), origin);
    }
}

void FieldWriter::writeState(const std::string& name, const SpectralField& field)
{
    putState(file_->hdf5, name, layout::complexType(), field, file_->origin("state/" + name));
}

void FieldWriter::writeState(const std::string& name, const RealField& field)
{
    putState(file_->hdf5, name, H5T_IEEE_F64LE, field, file_->origin("state/" + name));
}

void FieldWriter::close()
{
    assert(file_);
    const Origin origin = file_->origin();
    // The image is taken where it lies: H5Fget_file_image would copy it, and only tells its size (without the seal).
    void* memory = nullptr;
    checked(H5Fflush(file_->hdf5, H5F_SCOPE_GLOBAL), origin, problem);
    checked(H5Fget_vfd_handle(file_->hdf5, H5P_DEFAULT, &memory), origin, problem);
    const ssize_t size = checked(H5Fget_file_image(file_->hdf5, nullptr, 0), origin, problem);
    const char* const image = *static_cast<const char**>(memory);
    const std::string_view contents(image + sealSize, static_cast<std::size_t>(size));
    const Seal seal = sealOf(contents);
    file_->disk.write({seal.data(), seal.size()});
    file_->disk.write(contents);
    file_->disk.sync();
    file_.reset();
}

} // namespace isph
