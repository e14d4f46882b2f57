#include "fieldStore/FieldReader.hpp"

#include "core/Error.hpp"
#include "fieldStore/layout.hpp"
#include "fieldStore/seal.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>

namespace isph
{

struct FieldReader::File
{
    std::string shownAs;
    Hdf5Handle hdf5;
    Lattice lattice;

    Origin origin(const std::string& entry = "") const { return {shownAs, 0, entry}; }
};

namespace
{

constexpr const char* problem = "cannot be read";

Hdf5Handle openFile(const std::filesystem::path& file, const Origin& origin)
{
    silenceHdf5();
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_file_locking(access, false, true); // finished files are never written to: no lock, no trouble on NFS
    return {checked(H5Fopen(file.c_str(), H5F_ACC_RDONLY, access), origin, problem), H5Fclose};
}

bool exists(hid_t parent, const std::string& name)
{
    return !name.empty() && name.find('/') == std::string::npos && H5Lexists(parent, name.c_str(), H5P_DEFAULT) > 0;
}

/// An attribute of count numbers; nothing if it is missing or has another shape.
template<class Value, std::size_t count>
std::optional<std::array<Value, count>> numbers(hid_t object, const char* name, hid_t type)
{
    if (H5Aexists(object, name) <= 0) { return std::nullopt; }
    const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
    const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
    std::array<Value, count> values{};
    if (H5Sget_simple_extent_npoints(space) != static_cast<hssize_t>(count)) { return std::nullopt; }
    if (H5Aread(attribute, type, values.data()) < 0) { return std::nullopt; }
    return values;
}

/// A text of fixed length, as FieldWriter stores it; nothing if there is none.
std::optional<std::string> text(hid_t object, const char* name)
{
    if (H5Aexists(object, name) <= 0) { return std::nullopt; }
    const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
    const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
    if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0) { return std::nullopt; }
    std::string value(H5Tget_size(type), '\0');
    if (H5Aread(attribute, type, value.data()) < 0) { return std::nullopt; }
    value.erase(std::find(value.begin(), value.end(), '\0'), value.end());
    return value;
}

std::optional<Lattice> latticeOf(hid_t root)
{
    const auto origin = numbers<double, 3>(root, layout::originName, H5T_NATIVE_DOUBLE);
    const auto extent = numbers<double, 3>(root, layout::extentName, H5T_NATIVE_DOUBLE);
    const auto count = numbers<int, 3>(root, layout::countName, H5T_NATIVE_INT);
    const auto periodic = numbers<int, 3>(root, layout::periodicName, H5T_NATIVE_INT);
    const auto staggered = numbers<int, 3>(root, layout::staggeredName, H5T_NATIVE_INT);
    if (!origin || !extent || !count || !periodic || !staggered) { return std::nullopt; }
    std::array<Axis, 3> axes;
    for (std::size_t d = 0; d < 3; ++d)
    {
        if ((*count)[d] < 1) { return std::nullopt; }
        axes[d] = {"xyz"[d],
                   (*origin)[d],
                   (*extent)[d],
                   (*count)[d],
                   (*periodic)[d] != 0 ? Axis::Ends::periodic : Axis::Ends::bounded,
                   (*staggered)[d] != 0};
    }
    return Lattice(axes, {});
}

/// A dataset and its extents.
struct Dataset
{
    Dataset(hid_t parent, const std::string& name, const Origin& origin)
        : handle(checked(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), origin, problem), H5Dclose),
          extents(isph::extentsOf(Hdf5Handle(H5Dget_space(handle), H5Sclose)))
    {
    }

    Hdf5Handle handle;
    std::vector<hsize_t> extents;
};

/// Reads rows first ... first + count - 1 of the slowest dimension.
void readRows(hid_t dataset, hid_t type, hsize_t first, hsize_t count, void* values, const Origin& origin)
{
    const Hdf5Handle fileSpace(H5Dget_space(dataset), H5Sclose);
    const std::vector<hsize_t> extents = selectRows(fileSpace, first, count);
    const auto rank = static_cast<int>(extents.size());
    const Hdf5Handle memorySpace(H5Screate_simple(rank, extents.data(), nullptr), H5Sclose);
    checked(H5Dread(dataset, type, memorySpace, fileSpace, H5P_DEFAULT, values), origin, problem);
}

Hdf5Handle openStateGroup(hid_t root)
{
    return exists(root, layout::stateName) ? Hdf5Handle(H5Gopen2(root, layout::stateName, H5P_DEFAULT), H5Gclose)
                                           : Hdf5Handle();
}

template<class Value>
void getState(hid_t file, const std::string& name, hid_t type, Field<Value>& field, const Origin& origin)
{
    const Hdf5Handle group = openStateGroup(file);
    if (!group.valid() || !exists(group, name))
    {
        throw Error(Fault::input, origin, "is missing", "the file holds values but not this state of the solver");
    }
    const Dataset dataset(group, name, origin);
    const std::vector<hsize_t> wanted{static_cast<hsize_t>(field.components()), field.size()};
    if (dataset.extents != wanted)
    {
        throw Error(Fault::input, origin,
                    fmt::format("has the shape ({}) but must have ({})", fmt::join(dataset.extents, " "),
                                fmt::join(wanted, " ")),
                    "it was written for another lattice or by another scheme");
    }
    for (int c = 0; c < field.components(); ++c)
    {
        readRows(dataset.handle, type, static_cast<hsize_t>(c), 1, field[c].data(), origin);
    }
}

} // namespace

FieldReader::FieldReader(const std::filesystem::path& file, const std::string& shownAs)
    : file_(std::make_unique<File>())
{
    file_->shownAs = shownAs.empty() ? file.string() : shownAs;
    const Origin origin = file_->origin();
    verifySeal(file, origin);
    file_->hdf5 = openFile(file, origin);

    const auto formatVersion = numbers<int, 1>(file_->hdf5, layout::formatVersionName, H5T_NATIVE_INT);
    if (formatVersion && formatVersion->front() > layout::formatVersion)
    {
        const std::string program = text(file_->hdf5, layout::programName).value_or("a newer program");
        throw Error(Fault::input, origin,
                    fmt::format("has format version {}, written by {}, but this program reads no version above {}",
                                formatVersion->front(), program, layout::formatVersion),
                    "read it with the program that wrote it, or a later one");
    }
    const std::optional<Lattice> lattice = latticeOf(file_->hdf5);
    if (!formatVersion || !lattice)
    {
        throw Error(Fault::input, origin, "does not tell its format version or its lattice",
                    "it was not written by this suite");
    }
    file_->lattice = *lattice;
}

FieldReader::~FieldReader() = default;

Lattice FieldReader::lattice() const { return file_->lattice; }

std::vector<std::string> FieldReader::fields() const
{
    std::vector<std::string> names;
    const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* collected) -> herr_t
    {
        if (std::string_view(name) != layout::stateName)
        {
            static_cast<std::vector<std::string>*>(collected)->emplace_back(name);
        }
        return 0;
    };
    hsize_t index = 0;
    checked(H5Literate(file_->hdf5, H5_INDEX_NAME, H5_ITER_INC, &index, collect, &names), file_->origin(), problem);
    return names;
}

bool FieldReader::has(const std::string& name) const { return name != layout::stateName && exists(file_->hdf5, name); }

void FieldReader::require(const std::string& name) const
{
    if (has(name)) { return; }
    throw Error(Fault::input, file_->origin(name), "is missing",
                fmt::format("there are: {}", fmt::join(fields(), ", ")));
}

std::string FieldReader::unit(const std::string& name) const
{
    require(name);
    const Dataset dataset(file_->hdf5, name, file_->origin(name));
    return text(dataset.handle, layout::unitName).value_or("");
}

RealField FieldReader::read(const std::string& name) const
{
    require(name);
    const Origin origin = file_->origin(name);
    const Lattice& lattice = file_->lattice;
    const std::vector<hsize_t> scalar = layout::extentsOf(lattice, false);
    const std::vector<hsize_t> vector = layout::extentsOf(lattice, true);
    const Dataset dataset(file_->hdf5, name, origin);
    if (dataset.extents == scalar)
    {
        RealField field(1, lattice.points());
        readRows(dataset.handle, H5T_NATIVE_DOUBLE, 0, scalar[0], field[0].data(), origin);
        return field;
    }
    if (dataset.extents != vector)
    {
        throw Error(Fault::input, origin,
                    fmt::format("has the shape ({}) but its lattice asks for ({}), and 3 more for a vector",
                                fmt::join(dataset.extents, " "), fmt::join(scalar, " ")));
    }
    RealField field(lattice.dimensions(), lattice.points());
    // Plane by plane, so that the interleaved values never lie in memory as a whole.
    const std::size_t plane = vector[1] * vector[2];
    std::vector<double> values(plane * 3);
    for (hsize_t iz = 0; iz < vector[0]; ++iz)
    {
        readRows(dataset.handle, H5T_NATIVE_DOUBLE, iz, 1, values.data(), origin);
        for (int d = 0; d < field.components(); ++d)
        {
            const auto target = field[d].subspan(iz * plane, plane);
            const auto direction = static_cast<std::size_t>(lattice.direction(d));
            for (std::size_t n = 0; n < plane; ++n) { target[n] = values[3 * n + direction]; }
        }
    }
    return field;
}

bool FieldReader::hasState(const std::string& name) const
{
    const Hdf5Handle group = openStateGroup(file_->hdf5);
    return group.valid() && exists(group, name);
}

void FieldReader::readState(const std::string& name, SpectralField& field) const
{
    getState(file_->hdf5, name, layout::complexType(), field, file_->origin("state/" + name));
}

void FieldReader::readState(const std::string& name, RealField& field) const
{
    getState(file_->hdf5, name, H5T_NATIVE_DOUBLE, field, file_->origin("state/" + name));
}

} // namespace isph
