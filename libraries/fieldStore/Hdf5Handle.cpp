#include "fieldStore/Hdf5Handle.hpp"

#include "core/Error.hpp"

#include <algorithm>

namespace isph
{

void throwHdf5Error(const Origin& origin, const std::string& problem)
{
    std::string reason = "HDF5 gives no reason";
    const auto keepInnermost = [](unsigned, const H5E_error2_t* error, void* text) -> herr_t
    {
        if (error->desc != nullptr) { *static_cast<std::string*>(text) = error->desc; }
        return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keepInnermost, &reason);
    throw Error(Fault::input, origin, problem + ": " + reason);
}

std::vector<hsize_t> extentsOf(hid_t space)
{
    std::vector<hsize_t> extents(static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space), 0)));
    H5Sget_simple_extent_dims(space, extents.data(), nullptr);
    return extents;
}

std::vector<hsize_t> selectRows(hid_t space, hsize_t first, hsize_t count)
{
    std::vector<hsize_t> extents = extentsOf(space);
    std::vector<hsize_t> start(extents.size(), 0);
    start.at(0) = first;
    extents.at(0) = count;
    H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, extents.data(), nullptr);
    return extents;
}

} // namespace isph
